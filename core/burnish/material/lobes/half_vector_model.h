// What models share that are drawn by their half vectors: all but the equation.
//
// A model states `shape(wo, wi, h)`, what is left of f when F D is taken out, and its normals: D, border, how a half vector is drawn
// for a view, and the density of the directions wi that come of it.
#pragma once

#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/model.h>

namespace burnish {

template <class Model, class Normals>
class HalfVectorModel {
public:
    explicit HalfVectorModel(const LobeParameters& p) : m_normals(p.mx, p.my), m_fresnel(p.fresnel) {}

    Model with_widths(float mx, float my) const {
        Model other = static_cast<const Model&>(*this);
        other.m_normals = Normals(mx, my);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        const HalfVector h(wo, wi);
        return m_fresnel(h.cos_theta_d) * (m_normals.D(h.wm) * Model::shape(wo, wi, h));
    }

    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return 0;
        return m_normals.pdf(wo, HalfVector(wo, wi));
    }

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return reflect(wo, m_normals.sample(wo, u)); }
    float D(const Vec3f& wm) const { return m_normals.D(wm); }
    float border(float xi) const { return m_normals.border(xi); }

protected:
    Normals m_normals;
    Fresnel m_fresnel;
};

}  // namespace burnish
