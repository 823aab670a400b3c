// table: a measured reflectance shown as it is, from a file.
//
// Equations   f = measured(wo, wi) - kd / pi, not below 0; kd is the material's diffuse part
//             stretched to other widths, a = (mx, my) / own: f cos_i (wo.h) cos^3 theta_h of the half vector whose slopes are those of
//             h over a, divided by the same of h and by ax ay, so that every view keeps its energy
//             D and border from f itself (slope_profile.h); samples by inversion of tables (half_vector_sampler.h)
// Source      Matusik et al. 2003; Walkthrough 3.2
// Parameters  table, the file; mx, my, slope widths: the table's own where none are given.
// Traps       Made wider or narrower it is no measurement any more, nor reciprocal, and a narrower one lacks near the horizon what
//             the horizon took from the table's own lobe. Fresnel is in the numbers; r0, ior, eta, metal do nothing.
#pragma once

#include <burnish/base/error.h>
#include <burnish/material/measured/measured_lobe.h>
#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/model.h>

namespace burnish {

class Table {
public:
    static ModelInfo info() {
        return {.name = "table",
                .summary = "a measured reflectance as it is, named by \"table\": a .binary, .brdf, .alta, .dat or .gonio file",
                .source = "Matusik et al. 2003; Walkthrough 3.2",
                .parameters = {},
                .reciprocal = false,
                .own_width = true};
    }

    /// Throws Error(bad_argument) when p.data is no MeasuredLobe.
    explicit Table(const LobeParameters& p)
        : m_lobe(std::dynamic_pointer_cast<const MeasuredLobe>(p.data)), m_widths(p.mx, p.my) {
        if (!m_lobe) throw Error(ErrorCode::bad_argument, "model table: needs \"table\", the file of a measurement");
        set_widths(p.mx, p.my);
    }

    Table with_widths(float mx, float my) const {
        Table other = *this;
        other.set_widths(mx, my);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        return m_widths == m_lobe->own_widths() ? m_lobe->eval(wo, wi) : stretched(wo, wi);
    }
    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        return above_surface(wo, wi) ? m_lobe->sampler().pdf(wo, wi, m_widths) : 0.0f;
    }
    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return m_lobe->sampler().sample(wo, u, m_widths); }

    float D(const Vec3f& wm) const {
        if (wm.z <= kMinCosine) return 0;
        const float x = wm.x / (wm.z * m_widths.x), y = wm.y / (wm.z * m_widths.y), rho2 = x * x + y * y, z2 = wm.z * wm.z;
        return m_lobe->profile().q(std::log1p(rho2)) / (kPi * m_widths.x * m_widths.y * (1 + rho2) * z2 * z2);
    }
    float border(float xi) const { return m_lobe->profile().border(xi); }

    float own_width() const { return std::sqrt(m_lobe->own_widths().x * m_lobe->own_widths().y); }
    std::shared_ptr<const LobeData> data() const { return m_lobe; }

private:
    /// The table's own widths where these are the same but for rounding.
    void set_widths(float mx, float my) {
        m_widths = {std::max(mx, kMinWidth), std::max(my, kMinWidth)};
        if ((m_widths / m_lobe->own_widths() - Vec2f(1)).length2() < 1e-8f) m_widths = m_lobe->own_widths();
    }

    Color3f stretched(const Vec3f& wo, const Vec3f& wi) const {
        const HalfVector h(wo, wi);
        const Vec2f a = m_widths / m_lobe->own_widths();
        const Vec3f own = Vec3f(h.wm.x / a.x, h.wm.y / a.y, h.wm.z).normalized(), own_wi = reflect(wo, own);
        if (!above_surface(wo, own_wi)) return Color3f(0);
        const float z = own.z / h.wm.z, own_measure = own_wi.z * wo.dot(own) * z * z * z;
        return m_lobe->eval(wo, own_wi) * (own_measure / (wi.z * h.cos_theta_d * a.x * a.y));
    }

    std::shared_ptr<const MeasuredLobe> m_lobe;
    Vec2f m_widths;
};

}  // namespace burnish
