#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/parameters.h>

#include <algorithm>

namespace burnish {

Vec2f anisotropic_widths(float alpha, float anisotropy) {
    const float a = std::clamp(anisotropy, -0.9999f, 0.9999f), stretch = 1 - std::abs(a);
    const Vec2f widths = a >= 0 ? Vec2f(alpha * stretch, alpha / stretch) : Vec2f(alpha / stretch, alpha * stretch);
    return {std::clamp(widths.x, kMinWidth, 1.0f), std::clamp(widths.y, kMinWidth, 1.0f)};
}

}  // namespace burnish
