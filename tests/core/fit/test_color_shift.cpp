// Colours that change with the angle are told from those that do not.
#include <burnish/fit/color_shift.h>
#include <burnish/material/material_brdf.h>
#include <core/material/lobe_cases.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

Material red_lacquer() {
    Material material;
    material.kd = {0.3f, 0.05f, 0.02f};
    material.lobes = {make_lobe(ModelId::ggx, 0.2f, 0.2f)};
    material.lobes[0].tint = {0.2f, 0.18f, 0.15f};
    return material;
}

/// Seen along the normal as `material`, towards the horizon with red and blue exchanged.
std::vector<BrdfSample> measured(const Material& material, bool changes) {
    const MaterialBrdf f(material);
    std::vector<BrdfSample> samples;
    for (double theta_i = 5; theta_i < 85; theta_i += 10)
        for (double theta_o = 2.5; theta_o < 85; theta_o += 5)
            for (double phi = 0; phi < 360; phi += 30) {
                const Vec3f wo = direction_deg(theta_o, phi), wi = direction_deg(theta_i, 0);
                Color3f value = f(wo, wi);
                if (changes && theta_o > 40) std::swap(value.x, value.z);
                samples.push_back({wo, wi, value});
            }
    return samples;
}

TEST(ColorShift, IsNoneForTheMaterialItself) {
    EXPECT_LT(color_shift(measured(red_lacquer(), false), red_lacquer()), 1e-5);
    EXPECT_EQ(color_shift({}, red_lacquer()), 0);
}

TEST(ColorShift, IsSeenWhereTheColourChanges) {
    EXPECT_GT(color_shift(measured(red_lacquer(), true), red_lacquer()), kVisibleColorShift);
}

TEST(ColorShift, DoesNotMindBrightness) {
    Material darker = red_lacquer();
    darker.kd *= 0.5f, darker.lobes[0].strength = 0.5f;
    EXPECT_LT(color_shift(measured(red_lacquer(), false), darker), 1e-5);
}

}  // namespace
}  // namespace burnish
