// blinn-phong: a power of the cosine between the normal and the half vector.
//
// Equations   f = F(wo.h) (n + 2) / (8 pi) (h.n)^n = F D(h) / 4,   n = 2 / m^2 - 2,   D: see phong_normals.h
// Source      Blinn 1977, "Models of light reflection for computer synthesized pictures"; normalised as Bandwidth, III.4.4.4, and as
//             the fits of Ngan et al. 2005, which have (n + 2) / (2 pi): their specular is a quarter of the strength here, with which
//             a narrow lobe seen from above returns all light for F = 1.
// Parameters  m, the slope width of the equally wide Beckmann lobe; round.
// Traps       No cosines below: the lobe fades like cos_i towards the horizon.
#pragma once

#include <burnish/material/lobes/half_vector_model.h>
#include <burnish/material/lobes/phong_normals.h>

namespace burnish {

struct RoundPhongNormals : PhongNormals {
    RoundPhongNormals(float mx, float my) : PhongNormals(round_width(mx, my), round_width(mx, my)) {}
};

class BlinnPhong : public HalfVectorModel<BlinnPhong, RoundPhongNormals> {
public:
    using HalfVectorModel::HalfVectorModel;

    static ModelInfo info() {
        return {"blinn-phong", "power of the cosine to the half vector, normalised", "Blinn 1977; Ngan et al. 2005", {}, true,
                false};
    }

    static float shape(const Vec3f&, const Vec3f&, const HalfVector&) { return 0.25f; }
};

}  // namespace burnish
