// Beckmann normals as they are seen from wo: the visible normals, density D(wm) (wo.wm)+ / area(wo).
//
// Seen from a stretched direction of polar angle theta, the slope x along it has density (1 - x tan) exp(-x^2), x < cot, and
// the one across stays Gaussian. The distribution function of x,
//
//     C(x) ~ 1 + erf(x) + tan exp(-x^2) / sqrt(pi),
//
// is inverted by Newton's method in b = erf(x), where it is nearly straight. Source: Heitz & d'Eon 2014, "Importance sampling
// microfacet-based BSDFs using the distribution of visible normals"; Newton in erf: Jakob 2014, "An improved visible normal
// sampling routine for the Beckmann distribution".
#pragma once

#include <burnish/material/lobes/microfacet.h>

namespace burnish {

inline constexpr float kInvSqrtPi = std::numbers::inv_sqrtpi_v<float>;

/// x with erf(x) = y, |y| < 1, to 4e-7 relative. Source: Giles 2010, "Approximating the erfinv function" (single precision).
inline float inverse_erf(float y) {
    const float w = -std::log((1 - y) * (1 + y));
    if (w < 5) {
        const float v = w - 2.5f;
        float p = 2.81022636e-08f;
        for (const float c : {3.43273939e-07f, -3.5233877e-06f, -4.39150654e-06f, 0.00021858087f, -0.00125372503f,
                              -0.00417768164f, 0.246640727f, 1.50140941f})
            p = c + p * v;
        return p * y;
    }
    const float v = std::sqrt(w) - 3;
    float p = -0.000200214257f;
    for (const float c : {0.000100950558f, 0.00134934322f, -0.00367342844f, 0.00573950773f, -0.0076224613f, 0.00943887047f,
                          1.00167406f, 2.83297682f})
        p = c + p * v;
    return p * y;
}

/// Area of all microfacets that w sees, projected along w, per unit of surface: integral of D(wm) (w.wm)+ dwm, exact.
inline float visible_area(const BeckmannDistribution& normals, const Vec3f& w) {
    const float width = normals.projected_width(w), a = w.z / width;
    return 0.5f * (w.z * (1 + std::erf(a)) + width * std::exp(-a * a) * kInvSqrtPi);
}

/// The visible slope along the view for u in [0, 1); `cot` > 0 of the stretched view's polar angle, infinity included.
inline float sample_visible_slope(float cot, float u) {
    constexpr float kEdge = 0.9999999f;  // erf of the steepest slope a float tells from a wall
    const float tan_by_sqrt_pi = kInvSqrtPi / cot, top = std::min(std::erf(cot), kEdge);
    const float total = 1 + top + tan_by_sqrt_pi * std::exp(-cot * cot);
    const float theta = std::atan(1 / cot);
    const float bend = 1 + theta * (-0.876f + theta * (0.4265f - 0.0594f * theta));
    float low = -kEdge, high = top, b = std::max(top - (1 + top) * std::pow(1 - u, bend), low), x = 0;
    for (int step = 0; step < 10; ++step) {
        x = inverse_erf(b);
        const float excess = 1 + b + tan_by_sqrt_pi * std::exp(-x * x) - u * total;
        if (std::abs(excess) < 1e-5f * total) break;
        (excess > 0 ? high : low) = b;
        b -= excess / (1 - x / cot);
        if (!(b > low && b < high)) b = 0.5f * (low + high);
    }
    return x;
}

/// Draws a visible normal; wo above the surface.
inline Vec3f sample_visible_normal(const BeckmannDistribution& normals, const Vec3f& wo, const Vec2f& u) {
    const float mx = normals.mx(), my = normals.my(), width = normals.projected_width(wo);
    const float along = sample_visible_slope(wo.z / width, u.x);
    const float y = u.y > 0 ? u.y : 0.5f;  // low-discrepancy sets begin at the edge, where nothing is: the middle stands for it
    const float across = inverse_erf(std::clamp(2 * y - 1, -0.9999999f, 0.9999999f));
    const float c = width > 0 ? mx * wo.x / width : 1, s = width > 0 ? my * wo.y / width : 0;
    const Vec3f m(-mx * (c * along - s * across), -my * (s * along + c * across), 1);
    return m / std::sqrt(m.length2());
}

/// Beckmann's normals drawn as they are seen: p(wi) = D(h) / (4 area(wo)).
struct VisibleBeckmann : BeckmannDistribution {
    using BeckmannDistribution::BeckmannDistribution;

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return sample_visible_normal(*this, wo, u); }
    float pdf(const Vec3f& wo, const HalfVector& h) const { return D(h.wm) / (4 * visible_area(*this, wo)); }
};

}  // namespace burnish
