// What a display shows of linear light: the scale that every figure of burnish's accuracy is given in ("dB").
#pragma once

#include <algorithm>
#include <cmath>

namespace burnish {

/// What a picture's mean is scaled to before it is shown.
inline constexpr double kMiddleGrey = 0.18;

/// Linear to the display's signal, both 1 at white; clamped to [0, 1], then by the sRGB curve.
inline double display_encoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

/// Its derivative; 0 where it clamps.
inline double display_slope(double linear) {
    if (linear <= 0 || linear >= 1) return 0;
    return linear <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(linear, 1 / 2.4 - 1);
}

}  // namespace burnish
