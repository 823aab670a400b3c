// ggx: microfacets with long-tailed slopes (Trowbridge-Reitz), the lobe of most production renderers.
//
// Equations   f = F(wo.h) D(h) G1(wo) G1(wi) / (4 cos_o cos_i)
//             D(h) = 1 / (pi mx my (x^2/mx^2 + y^2/my^2 + z^2)^2),  h = (x, y, z)
//             G1(w) = 2 z / (z + s(w)),  s(w) = |(mx x, my y, z)|,  so  f = F D / ((z_o + s_o) (z_i + s_i))
//             sample the visible normals, bounded to those that reflect above the surface: p(wi) = D(h) / (2 (k z_o + s_o))
// Source      Walter et al. 2007, eq. 33-34; anisotropic: Heitz 2014; sampling: Heitz 2018, as a spherical cap
//             by Dupuy & Benyoub 2023, bounded by Eto & Tokuyoshi 2023 (k = 1 is the unbounded one).
// Parameters  mx, my: alpha along t and b, the square of the artist's roughness; equals Cycles' GGX.
// Traps       G is separable, not height-correlated, and without multiple scattering, as Cycles has it. Tails are long:
//             D falls like tan^-4, so a lobe of alpha 0.02 still reflects a bright lamp 30 degrees away.
#pragma once

#include <burnish/material/lobes/microfacet.h>
#include <burnish/material/model.h>

namespace burnish {

class Ggx {
public:
    static ModelInfo info() {
        return {"ggx",
                "microfacets with long-tailed slopes (Trowbridge-Reitz), Smith shadowing",
                "Walter et al. 2007, eq. 20, 33-34; Heitz 2014",
                {},
                true};
    }

    explicit Ggx(const LobeParameters& p) : m_fresnel(p.fresnel) { set_widths(p.mx, p.my); }

    Ggx with_widths(float mx, float my) const {
        Ggx other = *this;
        other.set_widths(mx, my);
        return other;
    }

    Color3f eval(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return Color3f(0);
        const HalfVector h(wo, wi);
        return m_fresnel(h.cos_theta_d) * (D(h.wm) / ((wo.z + stretched_length(wo)) * (wi.z + stretched_length(wi))));
    }

    float pdf(const Vec3f& wo, const Vec3f& wi) const {
        if (!above_surface(wo, wi)) return 0;
        return D(HalfVector(wo, wi).wm) / (2 * (cap_bound(wo) * wo.z + stretched_length(wo)));
    }

    Vec3f sample(const Vec3f& wo, const Vec2f& u) const {
        const Vec3f wo_std = Vec3f(m_mx * wo.x, m_my * wo.y, wo.z) / stretched_length(wo);
        const float low = cap_bound(wo) * wo_std.z;  // the cap of mirrored directions reaches from -low to 1
        const float z = (1 - u.y) * (1 + low) - low, phi = 2 * kPi * u.x;
        const float r = std::sqrt(std::max(0.0f, 1 - z * z));
        const Vec3f m_std(wo_std.x + r * std::cos(phi), wo_std.y + r * std::sin(phi), std::max(wo_std.z + z, kMinCosine));
        const Vec3f m(m_mx * m_std.x, m_my * m_std.y, m_std.z);
        return reflect(wo, m / std::sqrt(m.length2()));
    }

    float D(const Vec3f& wm) const {
        if (wm.z <= 0) return 0;
        const float e = wm.x * wm.x * m_inv_mx2 + wm.y * wm.y * m_inv_my2 + wm.z * wm.z;
        return m_peak / (e * e);
    }

    /// tan(theta) / alpha beyond which the share xi of the slopes lies: 1 / (1 + r^2) = xi.
    float border(float xi) const { return std::sqrt(1 / xi - 1); }

    /// Share of the microfacets facing w that w sees, in [0, 1]: Smith's, exact.
    float G1(const Vec3f& w) const { return 2 * w.z / (w.z + stretched_length(w)); }

private:
    void set_widths(float mx, float my) {
        m_mx = std::max(mx, kMinWidth);
        m_my = std::max(my, kMinWidth);
        m_inv_mx2 = 1 / (m_mx * m_mx);
        m_inv_my2 = 1 / (m_my * m_my);
        m_peak = 1 / (kPi * m_mx * m_my);
        m_narrow2 = std::min({m_mx * m_mx, m_my * m_my, 1.0f});
    }

    float stretched_length(const Vec3f& w) const {
        const float x = m_mx * w.x, y = m_my * w.y;
        return std::sqrt(x * x + y * y + w.z * w.z);
    }

    /// Eto & Tokuyoshi's k in (0, 1]: normals below k times the visible cap reflect below the surface.
    float cap_bound(const Vec3f& wo) const {
        const float s = 1 + std::sqrt(wo.x * wo.x + wo.y * wo.y), s2 = s * s;
        return (1 - m_narrow2) * s2 / (s2 + m_narrow2 * wo.z * wo.z);
    }

    Fresnel m_fresnel;
    float m_mx, m_my, m_inv_mx2, m_inv_my2, m_peak, m_narrow2;
};

}  // namespace burnish
