// oren-nayar: matt facets that are rough, so that light comes back to where it is from; the diffuse one of the set.
//
// Equations   f = F(wo.h) (A + B max(0, cos(phi_i - phi_o)) sin(alpha) tan(beta)) / pi,   alpha, beta: the larger, smaller theta
//             A = 1 - s^2 / (2 (s^2 + 0.33)),  B = 0.45 s^2 / (s^2 + 0.09),  s = m / sqrt(2): the RMS slope of facets of width m
//             sample cos_i / pi: weights between A and A + B
// Source      Oren & Nayar 1994, "Generalization of Lambert's reflectance model", eq. 30 (the qualitative model, without
//             interreflection).
// Parameters  m, slope width of the facets as Beckmann's; 0 is Lambert's law. tint: the facets' reflectivity. Round.
// Traps       It is as wide for every m: D and border are those of normals all over the hemisphere, D = 1 / pi.
#pragma once

#include <burnish/material/lobes/cosine_lobe_model.h>

namespace burnish {

class OrenNayar : public CosineLobeModel<OrenNayar> {
public:
    static ModelInfo info() {
        return {"oren-nayar", "rough matt surface, brighter back towards the light", "Oren & Nayar 1994, eq. 30", {}, true,
                false};
    }

    using CosineLobeModel::CosineLobeModel;

    static float exponent(float) { return 1; }
    static float normals_width(float) { return 1; }
    static Vec3f axis(const Vec3f&) { return {0, 0, 1}; }

    float shape(const Vec3f& wo, const Vec3f& wi) const {
        const float s2 = 0.5f * m_width * m_width;
        const float A = 1 - 0.5f * s2 / (s2 + 0.33f), B = 0.45f * s2 / (s2 + 0.09f);
        const float sines_cos_phi = wo.x * wi.x + wo.y * wi.y;  // sin_o sin_i cos(phi_i - phi_o)
        return (A + B * std::max(sines_cos_phi, 0.0f) / std::max(wo.z, wi.z)) / kPi;
    }
};

}  // namespace burnish
