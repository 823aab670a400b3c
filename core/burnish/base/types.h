// The vocabulary every stage speaks: vectors, colours and the shading frame.
//
// Conventions, stated here once and never varied:
// - Directions are unit vectors that point away from the surface: `wo` to the viewer, `wi` to the light, `wm` (or h) the
//   microfacet normal half way between them, `n` the shading normal, `ng` the geometric normal.
// - Local frame: x = tangent t, y = bitangent b, z = normal n. A `_l` suffix means "in the local frame".
// - Radiance is linear RGB, scene referred. Angles are radians unless a name says `_deg`.
// - Images are (height, width, channels), row 0 on top, 32-bit float.
#pragma once

#include <Imath/ImathColor.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <cmath>
#include <numbers>

namespace burnish {

using Vec2f = Imath::V2f;
using Vec3f = Imath::V3f;
using Color3f = Imath::C3f;
using Matrix33f = Imath::M33f;  // Imath's row vectors: v * M
using Matrix44f = Imath::M44f;

inline constexpr float kPi = std::numbers::pi_v<float>;

/// Rec.709 luminance of a linear colour.
inline float luminance(const Color3f& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

inline bool is_finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// A right-handed orthonormal shading frame.
struct Frame {
    Vec3f t, b, n;

    Vec3f to_local(const Vec3f& v) const { return {v.dot(t), v.dot(b), v.dot(n)}; }
    Vec3f to_world(const Vec3f& v) const { return t * v.x + b * v.y + n * v.z; }

    /// Frame about `n` whose tangent is any; source: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
    static Frame around(const Vec3f& n) {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z), xy = n.x * n.y * a;
        return {{1 + sign * n.x * n.x * a, sign * xy, -sign * n.x}, {xy, sign + n.y * n.y * a, -n.y}, n};
    }

    /// Frame about `n` whose tangent is `hint` made perpendicular to n; falls back to `around(n)` when they are parallel or
    /// the hint is zero.
    static Frame along(const Vec3f& n, const Vec3f& hint) {
        const Vec3f t = hint - n * n.dot(hint);
        const float length2 = t.length2();
        if (!(length2 > 1e-12f)) return around(n);
        const Vec3f unit = t / std::sqrt(length2);
        return {unit, n.cross(unit), n};
    }

    /// The frame turned about its normal by `angle` radians, right-hand rule.
    Frame turned(float angle) const {
        const float c = std::cos(angle), s = std::sin(angle);
        return {t * c + b * s, b * c - t * s, n};
    }
};

}  // namespace burnish
