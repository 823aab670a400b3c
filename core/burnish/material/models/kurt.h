// kurt: a Beckmann lobe whose shadowing is one exponent; the model that measured materials are fitted with.
//
// Equations   f = F(wo.h) D(h) / (4 (wo.h) ((wi.n) (wo.n))^alpha),   D anisotropic Beckmann, see microfacet.h
//             sample h with density D cos(theta_h), so p(wi) = D(h) cos(theta_h) / (4 (wo.h))
// Source      Kurt, Szirmay-Kalos & Krivanek 2010, "An anisotropic BRDF model for fitting and Monte Carlo rendering", as
//             given in methods: Regular, eq. 2-7 and 10, and Walkthrough, eq. 3.3-3.4. Fresnel usually Schlick's.
// Parameters  mx, my slope widths; alpha in [0, 1]: 0 never creates energy, but the directional albedo falls like cos(theta_o)
//             (0.26 at 75 deg); measured materials fit at 0.3-0.6; 1 brightens grazing angles without bound.
// Traps       For alpha > 0 the albedo exceeds 1 near the horizon when F does not fall with it: check_energy (albedo.h) tells.
//             The weight f cos / p = F cos(theta_i) / (cos(theta_h) (cos_i cos_o)^alpha) has no distribution left in it,
//             but below-horizon draws make it noisy at grazing angles (relative variance 0.6 at 85 deg, m = 0.1).
#pragma once

#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/model.h>

namespace burnish {

class Kurt {
public:
    static ModelInfo info() {
        return {
            "kurt",
            "Beckmann lobe with adjustable shadowing, for fitting measured materials",
            "Kurt, Szirmay-Kalos & Krivanek 2010",
            {{"alpha", kDefaultAlpha, 0.0f, 1.0f, "brightness at grazing angles; high values create energy near the horizon"}},
            true};
    }

    explicit Kurt(const LobeParameters& p)
        : m_normals(p.mx, p.my), m_fresnel(p.fresnel), m_alpha(p.extra.empty() ? kDefaultAlpha : p.extra[0]) {}

    Kurt with_widths(float mx, float my) const {
        Kurt other = *this;
        other.m_normals = BeckmannDistribution(mx, my);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        const HalfVector h(wo, wi);
        const float shadowing = std::pow(wo.z * wi.z, m_alpha);
        return m_fresnel(h.cos_theta_d) * (m_normals.D(h.wm) / (4 * h.cos_theta_d * shadowing));
    }

    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return 0;
        const HalfVector h(wo, wi);
        return m_normals.D(h.wm) * h.wm.z / (4 * h.cos_theta_d);
    }

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return reflect(wo, m_normals.sample(u)); }
    float D(const Vec3f& wm) const { return m_normals.D(wm); }
    float border(float xi) const { return m_normals.border(xi); }

private:
    static constexpr float kDefaultAlpha = 0.4f;

    BeckmannDistribution m_normals;
    Fresnel m_fresnel;
    float m_alpha;
};

}  // namespace burnish
