// The lat-long picture of distant light: which direction a place in it is, and back.
//
// u right, v down in [0, 1], edge to edge, texel centres at +0.5 (OpenEXR's own helpers put the first and last centres on
// the seam and the poles, half a texel off; renderers do not, and burnish follows the renderers). Axes are the light's:
// +Z in the middle, +X at u = 1/4, Y up.
//
//     u = 1/2 - atan2(x, z) / 2 pi,   v = acos(y) / pi
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>

#include <algorithm>

namespace burnish {

/// Place of unit direction d.
inline Vec2f latlong_coord(const Vec3f& d) {
    // atan2 keeps full precision near the poles, where acos(y) does not.
    const float v = std::atan2(std::sqrt(d.x * d.x + d.z * d.z), d.y) / kPi;
    return {0.5f - std::atan2(d.x, d.z) / (2.0f * kPi), v};
}

/// The unit direction at (u, v).
inline Vec3f latlong_direction(const Vec2f& uv) {
    const float phi = kPi - 2.0f * kPi * uv.x, theta = kPi * uv.y;
    return {std::sin(phi) * std::sin(theta), std::cos(theta), std::cos(phi) * std::sin(theta)};
}

/// Bilinear value of an RGB picture at (u, v): wraps in u, clamps at the poles, as renderers do.
Color3f latlong_bilinear(const Image& picture, const Vec2f& uv);

}  // namespace burnish
