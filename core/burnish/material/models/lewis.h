// lewis: Phong's lobe made reciprocal and energy conserving.
//
// Equations   f = F(wo.h) (n + 2) / (2 pi) (r.wi)^n,   r = wo mirrored at the normal,   n = 1 / (2 m^2)
//             sample cos^n about r: weights are F cos_i (n + 2) / (n + 1)
// Source      Lewis 1994, "Making Shaders More Physically Plausible".
// Parameters  m, the slope width of the equally wide Beckmann lobe seen from above; round.
// Traps       The albedo falls like cos_o: dark towards the horizon, where real surfaces brighten.
#pragma once

#include <burnish/material/lobes/cosine_lobe_model.h>

namespace burnish {

class Lewis : public CosineLobeModel<Lewis> {
public:
    using CosineLobeModel::CosineLobeModel;

    static ModelInfo info() {
        return {"lewis", "Phong's lobe, reciprocal and energy conserving", "Lewis 1994", {}, true, false};
    }

    static float exponent(float m) { return mirror_exponent(m); }
    static float normals_width(float m) { return m; }
    static Vec3f axis(const Vec3f& wo) { return mirror_direction(wo); }
    float shape(const Vec3f& wo, const Vec3f& wi) const {
        return (m_lobe.exponent + 2) / (2 * kPi) * m_lobe.raised(axis(wo), wi);
    }
};

}  // namespace burnish
