// The whole material as one function adds up what its parts say.
#include <burnish/material/material_brdf.h>
#include <burnish/material/models/ward.h>
#include <core/material/lobe_cases.h>

#include <gtest/gtest.h>

namespace burnish {

TEST(MaterialBrdf, AddsDiffuseLobesAndTransmission) {
    Material material;
    material.kd = {0.3f, 0.2f, 0.1f};
    material.lobes = {make_lobe(ModelId::ggx, 0.1f, 0.3f), make_lobe(ModelId::ward, 0.2f, 0.2f, Side::transmission)};
    material.lobes[0].strength = 2, material.lobes[0].tint = {1, 0.5f, 0.25f}, material.lobes[0].rotation = 0.5f * kPi;
    const MaterialBrdf f(material);
    const Vec3f wo = direction_deg(40, 20), wi = direction_deg(50, 190), through(wi.x, wi.y, -wi.z);

    const Vec3f wo_turned = direction_deg(40, -70), wi_turned = direction_deg(50, 100);
    const Color3f lobe = Ggx(material.lobes[0]).eval(wo_turned, wi_turned) * material.lobes[0].tint * 2;
    EXPECT_LT((f(wo, wi) - lobe - material.kd / kPi).length(), 1e-5f * lobe.length());
    EXPECT_LT((f(wo, through) - Ward(material.lobes[1]).eval(wo, wi)).length(), 1e-5f * f(wo, through).length());
    EXPECT_EQ(f(direction_deg(100, 0), wi), Color3f(0));
}

}  // namespace burnish
