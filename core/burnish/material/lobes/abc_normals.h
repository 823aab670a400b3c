// The ABC distribution of microfacets: a knee and a tail of any length, made for the long tails of measured materials.
#pragma once

#include <burnish/material/lobes/microfacet.h>

namespace burnish {

/// D(wm) = K / (1 + B (1 - cos theta))^C, with K so that the integral of D cos is 1, and the slopes stretched from `own_width` to
/// mx, my:  D'(s) cos^4 = (w^2 / (mx my)) D(s_0) cos_0^4,  slopes s_0 = (w s_x / mx, w s_y / my).
///
/// Source: Löw et al. 2012, "BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces", eq. 15, from the ABC model of
/// smooth surfaces (Church et al. 1989); there A takes the place of K.
class AbcNormals {
public:
    /// B > 0, C >= 0.
    AbcNormals(float B, float C);

    void set_widths(float mx, float my) {
        m_sx = m_own_width / std::max(mx, kMinWidth);
        m_sy = m_own_width / std::max(my, kMinWidth);
    }

    /// Density of microfacet normals in 1/sr, 0 below the surface.
    float D(const Vec3f& wm) const {
        const Vec3f s = unstretched(wm);
        const float inv_length2 = 1 / s.length2();
        return wm.z > 0 ? m_peak * falloff(s, inv_length2) * m_sx * m_sy * inv_length2 * inv_length2 : 0.0f;
    }

    /// Density of `sample` in 1/sr: (1 + B (1 - cos))^-C without the cosine of D cos, which its integral can be inverted for.
    float pdf(const Vec3f& wm) const {
        const Vec3f s = unstretched(wm);
        const float inv_length2 = 1 / s.length2();
        return wm.z > 0 ? m_drawn_peak * falloff(s, inv_length2) * m_sx * m_sy * inv_length2 * std::sqrt(inv_length2) : 0.0f;
    }

    Vec3f sample(const Vec2f& u) const;

    /// tan(theta) beyond which the share xi of the slopes lies, in widths.
    float border(float xi) const;

    /// The slope at which D has fallen to 1 / e, as Beckmann's D cos^4 at its width; at most 1.
    float own_width() const { return m_own_width; }
    /// K of these B and C: the published A is K pi / 4 times a colour of strength (abc.h).
    static double peak(double B, double C);

private:
    Vec3f unstretched(const Vec3f& wm) const { return {m_sx * wm.x, m_sy * wm.y, wm.z}; }

    /// (1 + B (1 - cos))^-C of the direction of s.
    float falloff(const Vec3f& s, float inv_length2) const {
        const float sin2 = (s.x * s.x + s.y * s.y) * inv_length2, versine = sin2 / (1 + s.z * std::sqrt(inv_length2));
        return std::exp(-m_C * std::log1p(m_B * versine));
    }

    float m_B, m_C, m_peak, m_drawn_peak, m_own_width, m_sx = 1, m_sy = 1;
};

}  // namespace burnish
