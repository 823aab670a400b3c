// sgd: microfacets with shifted gamma distributed slopes, a distribution for each colour channel, as measured materials want it.
//
// Equations   f = F(wo.h) D(h) G1(wo) G1(wi) / (pi cos_o cos_i),   D(h) = P22(tan^2 theta_h) / (pi cos^4 theta_h), see shifted_gamma.h
//             G1: Smith's, tabulated; or its fit where g1_lambda > 0, see fitted_shadowing.h
//             sample h with the mean of the channels' slopes, so p(wi) = D(h) cos(theta_h) / (4 (wo.h)) of its table
// Source      Bagher, Soler & Holzschuch 2012, "Accurate fitting of measured reflectances using a Shifted Gamma micro-facet
//             distribution"; Bandwidth, V.3.
// Parameters  alpha, p: width and sharpness of the slopes; g1_lambda, g1_c, g1_k: of the fit of G1, 0 for Smith's own.
//             mx, my: stretch the slopes by mx / own_width along t and my / own_width along b; stretched slopes keep their G1 at
//             the stretched direction (Heitz 2014, 5.3).
// Traps       Over pi, not 4: F is not a reflectance, and published F0 exceed 1. G1 is separable.
//             Peaks are alpha wide, far narrower than the median slope, which lies near sqrt(alpha).
#pragma once

#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/model.h>
#include <burnish/material/sgd/sgd_data.h>

namespace burnish {

class Sgd {
public:
    static ModelInfo info() {
        return {"sgd",
                "microfacets with shifted gamma distributed slopes, for measured materials",
                "Bagher, Soler & Holzschuch 2012; Bandwidth, V.3",
                {{"alpha", 0.1f, 1e-6f, 10, "end of the tail: slopes fall like exp(-tan^2 / alpha)", true},
                 {"p", 0.5f, 0, 5, "sharpness of the peak: like (alpha^2 + tan^2)^-p", true},
                 {"g1_lambda", 0, 0, 1e9f, "of the fit of G1; 0: exact G1", true},
                 {"g1_c", 1, 1e-30f, 3e38f, "of the fit of G1", true},
                 {"g1_k", 10, 0.01f, 10000, "of the fit of G1", true}},
                true,
                true,
                true};
    }

    explicit Sgd(const LobeParameters& p) : m_data(sgd_data(p)), m_fresnel(p.fresnel) { set_widths(p.mx, p.my); }

    Sgd with_widths(float mx, float my) const {
        Sgd other = *this;
        other.set_widths(mx, my);
        return other;
    }

    /// The lobe seen through Gaussian slopes of density e^(-x^2 / variance.x - y^2 / variance.y): sharp peaks stay sharp in
    /// stretched slopes, but not in these. Its widths are the roots of m^2 + variance.
    Sgd blurred(const Vec2f& variance) const {
        const float own = m_data->own_width, mx = std::hypot(m_sx * own, std::sqrt(variance.x)),
                    my = std::hypot(m_sy * own, std::sqrt(variance.y));
        auto data = std::make_shared<SgdData>(*m_data, 0.5f * (variance.x / (m_sx * m_sx) + variance.y / (m_sy * m_sy)));
        data->own_width = std::sqrt(mx * my / (m_sx * m_sy));
        Sgd other = *this;
        other.m_data = std::move(data);
        other.set_widths(mx, my);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        const HalfVector h(wo, wi);
        const float x = squared_slope(h.wm), cot_o = stretched_cot(wo), cot_i = stretched_cot(wi);
        Color3f f = m_fresnel(h.cos_theta_d) * (normals_per_slope(h.wm) / (kPi * wo.z * wi.z));
        for (int k = 0; k < 3; ++k) {
            const SgdChannel& channel = m_data->channels[static_cast<size_t>(k)];
            f[k] *= channel.density(x) * channel.G1(cot_o) * channel.G1(cot_i);
        }
        return f;
    }

    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return 0;
        const HalfVector h(wo, wi);
        const float density = m_data->slopes->density(squared_slope(h.wm));
        return density * normals_per_slope(h.wm) * h.wm.z / (4 * h.cos_theta_d);
    }

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const {
        const float slope = std::sqrt(m_data->slopes->beyond(1 - static_cast<double>(u.x))), phi = 2 * kPi * u.y;
        const float x = m_sx * slope * std::cos(phi), y = m_sy * slope * std::sin(phi);
        const float z = 1 / std::sqrt(1 + x * x + y * y);
        return reflect(wo, {x * z, y * z, z});
    }

    /// Mean of the channels'.
    float D(const Vec3f& wm) const { return wm.z > 0 ? m_data->density(squared_slope(wm)) * normals_per_slope(wm) : 0.0f; }

    float border(float xi) const { return std::sqrt(m_data->slopes->beyond(xi)) / m_data->own_width; }
    float own_width() const { return m_data->own_width; }
    std::shared_ptr<const LobeData> data() const { return m_data; }

private:
    void set_widths(float mx, float my) {
        m_sx = std::max(mx, kMinWidth) / m_data->own_width;
        m_sy = std::max(my, kMinWidth) / m_data->own_width;
    }

    /// Of a microfacet, in the slopes' own measure.
    float squared_slope(const Vec3f& wm) const {
        const float x = wm.x / (m_sx * wm.z), y = wm.y / (m_sy * wm.z);
        return x * x + y * y;
    }

    /// Density of normals over that of slopes: 1 / (pi sx sy cos^4).
    float normals_per_slope(const Vec3f& wm) const {
        const float z2 = wm.z * wm.z;
        return 1 / (kPi * m_sx * m_sy * z2 * z2);
    }

    /// cot theta of a direction in the slopes' own measure.
    float stretched_cot(const Vec3f& w) const {
        const float x = m_sx * w.x, y = m_sy * w.y;
        return w.z / std::sqrt(x * x + y * y);
    }

    std::shared_ptr<const SgdData> m_data;
    Fresnel m_fresnel;
    float m_sx, m_sy;
};

}  // namespace burnish
