// phong: a power of the cosine to the mirror direction, over cos_i: the first highlight of computer graphics.
//
// Equations   f = F(wo.h) (n + 1) / (2 pi) (r.wi)^n / cos_i,   r = wo mirrored at the normal,   n = 1 / (2 m^2)
//             sample cos^n about r, which is f cos_i / F: weights are F
// Source      Phong 1975, "Illumination for computer generated pictures", as a BRDF in Bandwidth, III.4.4.4. Neither has the factor
//             (n + 1) / (2 pi): with it, F = 1 and strength 1 return all light that does not fall below the surface.
// Parameters  m, the slope width of the equally wide Beckmann lobe seen from above; round.
// Traps       Not reciprocal: bright without bound for light at the horizon. Round about r, so without the long streaks that
//             half-vector lobes draw at grazing angles.
#pragma once

#include <burnish/material/lobes/cosine_lobe_model.h>

namespace burnish {

class Phong : public CosineLobeModel<Phong> {
public:
    using CosineLobeModel::CosineLobeModel;

    static ModelInfo info() {
        return {"phong", "power of the cosine to the mirror direction, over cos_i", "Phong 1975", {}, false, false};
    }

    static float exponent(float m) { return mirror_exponent(m); }
    static float normals_width(float m) { return m; }
    static Vec3f axis(const Vec3f& wo) { return mirror_direction(wo); }
    float shape(const Vec3f& wo, const Vec3f& wi) const { return m_lobe.pdf(axis(wo), wi) / wi.z; }
};

}  // namespace burnish
