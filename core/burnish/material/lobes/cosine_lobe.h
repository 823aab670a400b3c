// A lobe that is a power of the cosine to an axis: round about the mirror direction, as Phong's, not about a half vector.
#pragma once

#include <burnish/material/lobes/microfacet.h>

namespace burnish {

/// wo on the other side of the normal.
inline Vec3f mirror_direction(const Vec3f& wo) { return {-wo.x, -wo.y, wo.z}; }

/// The power that is as wide as Beckmann's lobe of width m from above, where a half vector moves half as far as its direction.
inline float mirror_exponent(float m) { return 1 / (2 * m * m); }

/// cos^exponent of the angle to an axis, 0 beyond a right angle.
struct CosineLobe {
    float exponent;

    /// (axis . w)^n, exact for narrow lobes too; unit vectors.
    float raised(const Vec3f& axis, const Vec3f& w) const {
        const float versine = 0.5f * (axis - w).length2();
        if (versine >= 1) return 0;
        const float e = -exponent * std::log1p(-versine);
        return e < kFarTail ? std::exp(-e) : 0.0f;
    }

    /// Density of `sample` in 1/sr: (n + 1) / (2 pi) cos^n, integral 1 over the sphere.
    float pdf(const Vec3f& axis, const Vec3f& w) const { return (exponent + 1) / (2 * kPi) * raised(axis, w); }

    Vec3f sample(const Vec3f& axis, const Vec2f& u) const {
        const float versine = -std::expm1(std::log(1 - u.x) / (exponent + 1)), phi = 2 * kPi * u.y;
        const float sine = std::sqrt(versine * (2 - versine));
        return Frame::around(axis).to_world({sine * std::cos(phi), sine * std::sin(phi), 1 - versine});
    }
};

}  // namespace burnish
