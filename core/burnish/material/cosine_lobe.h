// A lobe that is a power of the cosine to an axis: round about the mirror direction, as Phong's, not about a half vector.
#pragma once

#include <burnish/material/microfacet.h>

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
        return versine < 1 ? std::exp(exponent * std::log1p(-versine)) : 0.0f;
    }

    /// Density of `sample` in 1/sr: (n + 1) / (2 pi) cos^n, integral 1 over the sphere.
    float pdf(const Vec3f& axis, const Vec3f& w) const { return (exponent + 1) / (2 * kPi) * raised(axis, w); }

    Vec3f sample(const Vec3f& axis, const Vec2f& u) const {
        const float versine = versine_beyond(1 - u.x), sine = std::sqrt(versine * (2 - versine)), phi = 2 * kPi * u.y;
        return Frame::around(axis).to_world({sine * std::cos(phi), sine * std::sin(phi), 1 - versine});
    }

    /// The density of half vectors that the lobe has for a view from above, p(wi) = D cos(theta) / (4 cos(theta)): 4 p at twice the
    /// angle. Towards the horizon the lobe stays round, and as half vectors it grows across the view by 1 / cos(theta_o).
    float D(const Vec3f& wm) const {
        const float versine = 2 * (wm.x * wm.x + wm.y * wm.y);
        if (wm.z <= 0 || versine >= 1) return 0;
        return 2 * (exponent + 1) / kPi * std::exp(exponent * std::log1p(-versine));
    }

    /// tan(theta) of the half vectors beyond which the share xi lies for a view from above.
    float border_slope(float xi) const {
        const float versine = versine_beyond(xi);
        return std::sqrt(versine / (2 - versine));
    }

private:
    /// 1 - cos of the angle beyond which the share xi of the lobe lies: cos^(n + 1) = xi.
    float versine_beyond(float xi) const { return -std::expm1(std::log(xi) / (exponent + 1)); }
};

}  // namespace burnish
