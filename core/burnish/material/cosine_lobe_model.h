// What models share that are drawn as a power of the cosine to an axis: all but the equation and the axis.
//
// A model states `shape(wo, wi)`, its f without Fresnel, `axis(wo)`, the unit vector to draw about, and `exponent(m)`. D and border
// are those of its draws for a view from above (cosine_lobe.h).
#pragma once

#include <burnish/material/cosine_lobe.h>
#include <burnish/material/model.h>

namespace burnish {

template <class Model>
class CosineLobeModel {
public:
    explicit CosineLobeModel(const LobeParameters& p) : m_fresnel(p.fresnel) { set_widths(p.mx, p.my); }

    Model with_widths(float mx, float my) const {
        Model other = model();
        other.set_widths(mx, my);
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
    float D(const Vec3f& wm) const { return m_lobe.D(wm); }
    float border(float xi) const { return m_lobe.border_slope(xi) / m_width; }

protected:
    CosineLobe m_lobe;
    float m_width;

private:
    const Model& model() const { return static_cast<const Model&>(*this); }

    void set_widths(float mx, float my) {
        m_width = round_width(mx, my);
        m_lobe.exponent = Model::exponent(m_width);
    }

    Fresnel m_fresnel;
};

}  // namespace burnish
