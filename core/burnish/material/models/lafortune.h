// lafortune: a cosine lobe about any axis that is linear in wo: off the mirror direction, forward or back to the light.
//
// Equations   f = F(wo.h) (n + 2) / (2 pi) ((a.wi) / max(|cxy|, |cz|))^n,   a = (cxy x, cxy y, cz z) of wo,   n = 1 / (2 m^2)
//             sample cos^n about a: weights are F cos_i (n + 2) / (n + 1) (|a| / max)^n
// Source      Lafortune et al. 1997, "Non-linear approximation of reflectance functions", eq. 4; scaled as the fits of Ngan et al. 2005.
// Parameters  cxy = -1, cz = 1 is `lewis`; only their ratio matters. |cxy| > cz brightens and lowers the lobe towards the horizon,
//             cxy > 0 sends it back. m: the slope width of the equally wide Beckmann lobe seen from above; round.
// Traps       The axis of n = 1000 and cxy = -1.01 cz gains e^10 from above to the horizon. D and border are of a lobe about the
//             mirror direction: lobes far off it are for estimators that do not lay their lookups out by half vectors.
#pragma once

#include <burnish/material/lobes/cosine_lobe_model.h>

namespace burnish {

class Lafortune : public CosineLobeModel<Lafortune> {
public:
    static ModelInfo info() {
        return {"lafortune",
                "cosine lobe about an axis off the mirror direction",
                "Lafortune et al. 1997, eq. 4; Ngan et al. 2005",
                {{"cxy", kMirrorCxy, -1.0f, 1.0f, "axis along the surface, of wo: -1 forward, 1 back"},
                 {"cz", kMirrorCz, 0.0f, 1.0f, "axis along the normal"}},
                true,
                false};
    }

    explicit Lafortune(const LobeParameters& p) : CosineLobeModel(p) {
        const float cxy = p.extra.empty() ? kMirrorCxy : p.extra[0], cz = p.extra.empty() ? kMirrorCz : p.extra[1];
        const float largest = std::max({std::abs(cxy), std::abs(cz), kMinCosine});
        m_cxy = cxy / largest, m_cz = cz / largest;
    }

    static float exponent(float m) { return mirror_exponent(m); }
    static float normals_width(float m) { return m; }

    Vec3f axis(const Vec3f& wo) const {
        const Vec3f a(m_cxy * wo.x, m_cxy * wo.y, m_cz * wo.z);
        const float length2 = a.length2();
        return length2 > 0 ? a / std::sqrt(length2) : Vec3f(0, 0, 1);
    }

    float shape(const Vec3f& wo, const Vec3f& wi) const {
        const float s2 = wo.x * wo.x + wo.y * wo.y;
        const float missing = (1 - m_cxy * m_cxy) * s2 + (1 - m_cz * m_cz) * wo.z * wo.z;  // 1 - |a|^2, exact where it is small
        const float length_n = std::exp(0.5f * m_lobe.exponent * std::log1p(-std::min(missing, 1.0f)));
        return (m_lobe.exponent + 2) / (2 * kPi) * length_n * m_lobe.raised(axis(wo), wi);
    }

private:
    static constexpr float kMirrorCxy = -1, kMirrorCz = 1;

    float m_cxy, m_cz;
};

}  // namespace burnish
