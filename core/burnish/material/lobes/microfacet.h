// What microfacet models have in common: half vectors, and the Beckmann distribution that Kurt and Beckmann both stand on.
#pragma once

#include <burnish/base/types.h>

#include <algorithm>

namespace burnish {

/// Directions lower than this above the surface count as below it: keeps every 1 / cos finite in float.
inline constexpr float kMinCosine = 1e-6f;
/// Narrower lobes are mirrors to a float; keeps 1 / (mx my) finite.
inline constexpr float kMinWidth = 1e-4f;

/// exp(-80) = 2e-35, the end of float: lobes are 0 from there on.
inline constexpr float kFarTail = 80.0f;

inline bool above_surface(const Vec3f& wo, const Vec3f& wi) { return wo.z > kMinCosine && wi.z > kMinCosine; }

/// The microfacet normal half way between two directions on the same side, and its cosine to both: wo . wm = |wo + wi| / 2.
struct HalfVector {
    Vec3f wm;
    float cos_theta_d;

    HalfVector(const Vec3f& wo, const Vec3f& wi) {
        const Vec3f sum = wo + wi;
        const float length = std::sqrt(sum.length2());
        wm = sum / length;
        cos_theta_d = 0.5f * length;
    }
};

/// The one width of a model that is always round: as large a lobe as the two widths ask for.
inline float round_width(float mx, float my) { return std::sqrt(std::max(mx, kMinWidth) * std::max(my, kMinWidth)); }

inline Vec3f reflect(const Vec3f& wo, const Vec3f& wm) { return wm * (2 * wo.dot(wm)) - wo; }

/// Beckmann's normals: slopes are Gaussian, of RMS mx / sqrt(2) along t and my / sqrt(2) along b.
///
///     D(wm) = exp(-(x^2 / mx^2 + y^2 / my^2) / z^2) / (pi mx my z^4),  wm = (x, y, z)
///
/// Source: Beckmann & Spizzichino 1963; anisotropic as in Ward 1992; normalised, integral of D cos = 1 (Kurt 2010; Regular, eq. 4).
struct BeckmannDistribution {
    BeckmannDistribution(float mx, float my) : m_mx(std::max(mx, kMinWidth)), m_my(std::max(my, kMinWidth)) {
        m_inv_mx2 = 1 / (m_mx * m_mx);
        m_inv_my2 = 1 / (m_my * m_my);
        m_peak = 1 / (kPi * m_mx * m_my);
    }

    /// Density of microfacet normals in 1/sr, 0 below the surface.
    float D(const Vec3f& wm) const {
        if (wm.z <= 0) return 0;
        const float inv_z2 = 1 / (wm.z * wm.z);
        const float e = (wm.x * wm.x * m_inv_mx2 + wm.y * wm.y * m_inv_my2) * inv_z2;
        return e < kFarTail ? m_peak * std::exp(-e) * inv_z2 * inv_z2 : 0.0f;
    }

    /// Draws wm with density D cos: tan^2 = -ln(1 - u.x) along the stretched angle 2 pi u.y (Ward 1992; Regular, eq. 6-7).
    Vec3f sample(const Vec2f& u) const {
        const float r = std::sqrt(-std::log(1 - std::min(u.x, kBelowOne))), phi = 2 * kPi * u.y;
        const float x = m_mx * r * std::cos(phi), y = m_my * r * std::sin(phi);
        const float z = 1 / std::sqrt(1 + x * x + y * y);
        return {x * z, y * z, z};
    }

    /// Width along w's azimuth times its sine: |(mx x, my y)|.
    float projected_width(const Vec3f& w) const { return std::sqrt(m_mx * m_mx * w.x * w.x + m_my * m_my * w.y * w.y); }

    /// tan(theta) / m beyond which the share xi of the slopes lies: exp(-r^2) = xi; also where D cos^4 has fallen to xi.
    float border(float xi) const { return std::sqrt(-std::log(xi)); }

    float mx() const { return m_mx; }
    float my() const { return m_my; }

private:
    static constexpr float kBelowOne = 0x1.fffffep-1f;

    float m_mx, m_my, m_inv_mx2, m_inv_my2, m_peak;
};

}  // namespace burnish
