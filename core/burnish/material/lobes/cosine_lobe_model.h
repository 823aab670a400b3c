// What models share that are drawn as a power of the cosine to an axis: all but the equation and the axis.
//
// A model states `shape(wo, wi)`, its f without Fresnel, `axis(wo)`, the unit vector to draw about, `exponent(m)`, and
// `normals_width(m)`: D and border are those of Blinn's normals of that width, the half vectors that its lobe is nearest to from above.
// Towards the horizon the lobe is rounder than that, and as half vectors wider across the view by 1 / cos(theta_o).
#pragma once

#include <burnish/material/lobes/cosine_lobe.h>
#include <burnish/material/model.h>
#include <burnish/material/lobes/phong_normals.h>

namespace burnish {

template <class Model>
class CosineLobeModel {
public:
    explicit CosineLobeModel(const LobeParameters& p) : CosineLobeModel(round_width(p.mx, p.my), p.fresnel) {}

    Model with_widths(float mx, float my) const {
        Model other = model();
        static_cast<CosineLobeModel&>(other) = CosineLobeModel(round_width(mx, my), m_fresnel);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        return m_fresnel(HalfVector(wo, wi).cos_theta_d) * model().shape(wo, wi);
    }

    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        return above_surface(wo, wi) ? m_lobe.pdf(model().axis(wo), wi) : 0.0f;
    }

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return m_lobe.sample(model().axis(wo), u); }
    float D(const Vec3f& wm) const { return m_normals.D(wm); }
    float border(float xi) const { return m_normals.border(xi) * (Model::normals_width(m_width) / m_width); }

protected:
    float m_width;
    CosineLobe m_lobe;

private:
    CosineLobeModel(float width, const Fresnel& fresnel)
        : m_width(width),
          m_lobe{Model::exponent(width)},
          m_normals(Model::normals_width(width), Model::normals_width(width)),
          m_fresnel(fresnel) {}

    const Model& model() const { return static_cast<const Model&>(*this); }

    PhongNormals m_normals;
    Fresnel m_fresnel;
};

}  // namespace burnish
