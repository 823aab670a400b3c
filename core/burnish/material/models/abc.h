// abc: microfacets with tails of any length, whose parameters were fitted to a hundred measured materials.
//
// Equations   f = F(wo.h) D(h) G / (4 cos_i cos_o),   D = K / (1 + B (1 - cos theta_h))^C, see abc_normals.h
//             G = min(1, 2 cos_h cos_i / (wo.h), 2 cos_h cos_o / (wo.h)),  the V-grooves of Torrance & Sparrow 1967
//             sample h with density ~ (1 + B (1 - cos))^-C: weights are below F cos_h times a constant
// Source      Löw, Kronander, Ynnerman & Unger 2012, eq. 15. Theirs has A instead of K and 1 / pi instead of 1 / 4: a published
//             colour A is the tint 4 A / (pi K), K = AbcNormals::peak(B, C).
// Parameters  B: how narrow the knee is; C: how fast the tail falls (2 is near ggx, below 1 half of the light is in the tail).
//             Their width is `own_width`; other mx, my stretch the slopes.
// Traps       Fits with C far below 1 have more light in the tail than in the highlight; as D is as bright as K says, the highlight
//             of strength 1 is dim there.
#pragma once

#include <burnish/material/lobes/abc_normals.h>
#include <burnish/material/model.h>

namespace burnish {

class Abc {
public:
    static ModelInfo info() {
        return {"abc",
                "microfacets with tails of any length, V-groove shadowing",
                "Löw et al. 2012, eq. 15",
                {{"B", kKnee, 1.0f, 1e8f, "narrowness of the highlight"},
                 {"C", kTail, 0.0f, 10.0f, "how fast its tail falls; 2 is near ggx"}},
                true,
                true,
                true};
    }

    explicit Abc(const LobeParameters& p)
        : m_normals(p.extra.empty() ? kKnee : p.extra[0], p.extra.empty() ? kTail : p.extra[1]), m_fresnel(p.fresnel) {
        m_normals.set_widths(p.mx, p.my);
    }

    Abc with_widths(float mx, float my) const {
        Abc other = *this;
        other.m_normals.set_widths(mx, my);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        const HalfVector h(wo, wi);
        const float G = std::min(1.0f, 2 * h.wm.z * std::min(wo.z, wi.z) / h.cos_theta_d);
        return m_fresnel(h.cos_theta_d) * (m_normals.D(h.wm) * G / (4 * wo.z * wi.z));
    }

    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return 0;
        const HalfVector h(wo, wi);
        return m_normals.pdf(h.wm) / (4 * h.cos_theta_d);
    }

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return reflect(wo, m_normals.sample(u)); }
    float D(const Vec3f& wm) const { return m_normals.D(wm); }
    float border(float xi) const { return m_normals.border(xi); }
    float own_width() const { return m_normals.own_width(); }

private:
    static constexpr float kKnee = 1000, kTail = 1.5f;

    AbcNormals m_normals;
    Fresnel m_fresnel;
};

}  // namespace burnish
