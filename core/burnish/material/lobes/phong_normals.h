// Normals as powers of a cosine: what Blinn's form of Phong's lobe and Ashikhmin & Shirley's stand on.
#pragma once

#include <burnish/material/lobes/microfacet.h>

namespace burnish {

/// D(wm) = cos^(n - 1) theta / (pi mx my), where n + 1 = 2 (cos^2 phi / mx^2 + sin^2 phi / my^2): along t and b the slopes fall as
/// Beckmann's of widths mx and my do near the normal, n = 2 / m^2 - 1, and have longer tails far from it.
///
/// Source: Ashikhmin & Shirley 2000, whose density of half vectors is this D cos theta, integral 1.
struct PhongNormals {
    PhongNormals(float mx, float my) : m_mx(std::max(mx, kMinWidth)), m_my(std::max(my, kMinWidth)) {
        m_inv_mx2 = 1 / (m_mx * m_mx);
        m_inv_my2 = 1 / (m_my * m_my);
        m_peak = 1 / (kPi * m_mx * m_my);
    }

    /// Density of microfacet normals in 1/sr, 0 below the surface.
    float D(const Vec3f& wm) const {
        if (wm.z <= kMinCosine) return 0;
        const float x2 = wm.x * wm.x, y2 = wm.y * wm.y, inv_z2 = 1 / (wm.z * wm.z);
        const float tan2 = (x2 + y2) * inv_z2, log_inv_cos2 = std::log1p(tan2);
        const float m_tan2 = (x2 * m_inv_mx2 + y2 * m_inv_my2) * inv_z2;  // (n + 1) tan^2 / 2
        const float bent = tan2 > 0 ? log_inv_cos2 / tan2 : 1.0f;
        const float e = m_tan2 * bent - log_inv_cos2;
        return e < kFarTail ? m_peak * std::exp(-e) : 0.0f;
    }

    /// Draws wm with density D cos, for any view: 1 / cos^2 = (1 - u.x)^(-m^2(phi)) along the stretched angle 2 pi u.y.
    Vec3f sample(const Vec3f&, const Vec2f& u) const {
        const float psi = 2 * kPi * u.y, x = m_mx * std::cos(psi), y = m_my * std::sin(psi), m2 = x * x + y * y;
        const float tan2 = std::expm1(-m2 * std::log(1 - std::min(u.x, kBelowOne)));
        const float scale = std::sqrt(tan2 / m2), z = 1 / std::sqrt(1 + tan2);
        return {x * scale * z, y * scale * z, z};
    }

    /// Density of the directions wi that the draws reflect to.
    float pdf(const Vec3f&, const HalfVector& h) const { return D(h.wm) * h.wm.z / (4 * h.cos_theta_d); }

    /// tan(theta) / m beyond which the share xi of the slopes lies, for the mean of the widths: (1 + m^2 r^2)^(-1 / m^2) = xi.
    float border(float xi) const {
        const float m2 = m_mx * m_my;
        return std::sqrt(std::expm1(-m2 * std::log(xi)) / m2);
    }

private:
    static constexpr float kBelowOne = 0x1.fffffep-1f;

    float m_mx, m_my, m_inv_mx2, m_inv_my2, m_peak;
};

}  // namespace burnish
