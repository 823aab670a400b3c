// Measurements by formula in half and difference angles, in double, for tests of fits and errors.
#pragma once

#include <burnish/fit/brdf_grid.h>

#include <cmath>

namespace grid_cases {

using burnish::BrdfGrid;
using burnish::Channels;
using burnish::GridAngles;

/// All theta_h of a table, and enough of the rest for fits.
inline constexpr burnish::GridSize kSmall{90, 45, 18, 2};

struct Cosines {
    double i, o;
};

inline Cosines cosines(const GridAngles& a) {
    const double level = std::cos(a.theta_h) * std::cos(a.theta_d);
    const double tilt = std::sin(a.theta_h) * std::sin(a.theta_d) * std::cos(a.phi_d);
    return {level - tilt, level + tilt};
}

/// One channel of an SGD material whose peak is `peak` times pi cos_i cos_o and whose slopes are too small to be masked.
struct Sgd {
    double kd, peak, alpha, p, f0, f1;

    double f(const GridAngles& a) const {
        const double x = std::pow(std::tan(a.theta_h), 2), c = std::cos(a.theta_d);
        const double D = std::exp(-x / alpha) * std::pow(1 + x / (alpha * alpha), -p) / std::pow(std::cos(a.theta_h), 4);
        const double F = std::max(0.0, f0 - f1 * c + (1 - f0) * std::pow(1 - c, 5));
        const auto [cos_i, cos_o] = cosines(a);
        return kd / std::numbers::pi + peak * D * F / (std::numbers::pi * cos_i * cos_o);
    }
};

/// The same f in all channels.
template <class F>
BrdfGrid grey_grid(const burnish::GridSize& size, const F& f) {
    return BrdfGrid(size, [&](const GridAngles& a) -> std::optional<Channels> {
        const double value = f(a);
        if (value < 0) return std::nullopt;
        return Channels{value, value, value};
    });
}

}  // namespace grid_cases
