// beckmann: microfacets with Gaussian slopes, as renderers have it.
//
// Equations   f = F(wo.h) D(h) G1(wo) G1(wi) / (4 cos_o cos_i),   D anisotropic Beckmann, see microfacet.h
//             G1(w) = (3.535 a + 2.181 a^2) / (1 + 2.276 a + 2.577 a^2) for a < 1.6, else 1;  a = z / |(mx x, my y)|
//             sample the visible normals, so p(wi) = D(h) / (4 area(wo)), area exact: see beckmann_visible.h
// Source      Walter, Marschner, Li & Torrance 2007, eq. 20, 25, 27; anisotropic masking by Heitz 2014.
// Parameters  mx, my slope widths (RMS slope times sqrt(2)); equals Cycles' Beckmann and Mitsuba's `beckmann` alpha.
// Traps       G is separable and without multiple scattering: at m = 1 more than half of the light is lost (albedo 0.46 from
//             above), at 0.6 a seventh. The rational G1 is up to 0.4 % off Smith's exact one: renderers with erf differ so.
#pragma once

#include <burnish/material/lobes/beckmann_visible.h>
#include <burnish/material/model.h>

namespace burnish {

class Beckmann {
public:
    static ModelInfo info() {
        return {
            "beckmann", "microfacets with Gaussian slopes, Smith shadowing", "Walter et al. 2007, eq. 20, 25, 27", {}, true};
    }

    explicit Beckmann(const LobeParameters& p) : m_normals(p.mx, p.my), m_fresnel(p.fresnel) {}

    Beckmann with_widths(float mx, float my) const {
        Beckmann other = *this;
        other.m_normals = BeckmannDistribution(mx, my);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        const HalfVector h(wo, wi);
        return m_fresnel(h.cos_theta_d) * (m_normals.D(h.wm) * G1(wo) * G1(wi) / (4 * wo.z * wi.z));
    }

    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return 0;
        return m_normals.D(HalfVector(wo, wi).wm) / (4 * visible_area(m_normals, wo));
    }

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return reflect(wo, sample_visible_normal(m_normals, wo, u)); }
    float D(const Vec3f& wm) const { return m_normals.D(wm); }
    float border(float xi) const { return m_normals.border(xi); }

    /// Share of the microfacets facing w that w sees, in [0, 1].
    float G1(const Vec3f& w) const {
        const float width = m_normals.projected_width(w);
        if (w.z >= 1.6f * width) return 1;
        const float a = w.z / width;
        return (3.535f + 2.181f * a) * a / (1 + (2.276f + 2.577f * a) * a);
    }

private:
    BeckmannDistribution m_normals;
    Fresnel m_fresnel;
};

}  // namespace burnish
