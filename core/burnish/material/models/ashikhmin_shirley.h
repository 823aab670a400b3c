// ashikhmin-shirley: Phong's lobe made anisotropic and reciprocal; the specular part of the model.
//
// Equations   f = sqrt((nu + 1) (nv + 1)) / (8 pi) (h.n)^(nu cos^2 phi_h + nv sin^2 phi_h) / ((wo.h) max(cos_i, cos_o)) F(wo.h)
//               = F D(h) cos theta_h / (4 (wo.h) max(cos_i, cos_o)),   nu = 2 / mx^2 - 1, nv = 2 / my^2 - 1,   D: phong_normals.h
//             weight of a sample: F cos_i / max(cos_i, cos_o), never above 1
// Source      Ashikhmin & Shirley 2000, "An Anisotropic Phong BRDF Model", eq. 4.
// Parameters  mx, my: slope widths of the equally wide Beckmann lobe.
// Traps       The paper couples a diffuse part to it: give that as another lobe or as kd with kd_coupled. Powers below 1, of some
//             fits, are wider than m = 1.
#pragma once

#include <burnish/material/lobes/half_vector_model.h>
#include <burnish/material/lobes/phong_normals.h>

namespace burnish {

class AshikhminShirley : public HalfVectorModel<AshikhminShirley, PhongNormals> {
public:
    using HalfVectorModel::HalfVectorModel;

    static ModelInfo info() {
        return {
            "ashikhmin-shirley", "anisotropic Phong lobe about the half vector", "Ashikhmin & Shirley 2000, eq. 4", {}, true};
    }

    static float shape(const Vec3f& wo, const Vec3f& wi, const HalfVector& h) {
        return h.wm.z / (4 * h.cos_theta_d * std::max(wo.z, wi.z));
    }
};

}  // namespace burnish
