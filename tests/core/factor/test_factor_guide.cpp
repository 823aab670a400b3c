// Where materials reflect to on the whole.
#include <burnish/factor/factor_guide.h>
#include <burnish/material/any_model.h>
#include <burnish/material/parameters.h>
#include "core/scenes.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

Material material_of(const LobeParameters& lobe) { return {"test", Color3f(0, 0, 0), {lobe}}; }

Vec3f view(float degrees) { return {std::sin(degrees * kPi / 180), 0, std::cos(degrees * kPi / 180)}; }

/// Degrees from the normal, on the far side from the viewer.
float reflected_degrees(const FactorGuide& guide, float degrees) {
    const Vec3f r = guide.reflection({{0, 0, 1}, view(degrees)});
    EXPECT_NEAR(r.length(), 1, 1e-4f);
    EXPECT_NEAR(r.y, 0, 1e-4f);
    return std::atan2(-r.x, r.z) * 180 / kPi;
}

TEST(FactorGuide, IsAMirrorByItself) {
    for (const float degrees : {0.0f, 20.0f, 60.0f, 89.0f}) EXPECT_NEAR(reflected_degrees({}, degrees), degrees, 0.2f);
}

TEST(FactorGuide, FollowsAMirror) {
    const FactorGuide guide = FactorGuide::of(material_of(scenes::lobe_of(ModelId::ggx, 0.002f, 0.002f)));
    for (const float degrees : {5.0f, 20.0f, 60.0f, 85.0f}) EXPECT_NEAR(reflected_degrees(guide, degrees), degrees, 0.5f);
}

TEST(FactorGuide, LeavesTheHorizonWithRoughSurfaces) {
    const FactorGuide guide = FactorGuide::of(material_of(scenes::lobe_of(ModelId::beckmann, 0.5f, 0.5f)));
    EXPECT_NEAR(reflected_degrees(guide, 1), 0, 2);
    EXPECT_LT(reflected_degrees(guide, 85), 75);
}

TEST(FactorGuide, GoesThroughWhatTransmits) {
    LobeParameters through = scenes::lobe_of(ModelId::ggx, 0.01f, 0.01f);
    through.side = Side::transmission;
    const FactorGuide guide = FactorGuide::of(material_of(through));
    EXPECT_NEAR(reflected_degrees(guide, 30), 150, 1);
}

/// The mean by the midpoint rule, of a lobe that is not white.
TEST(FactorGuide, IsTheMeanOfTheLobe) {
    const LobeParameters lobe = scenes::lobe_of(ModelId::ggx, 0.3f, 0.3f);
    const FactorGuide guide = FactorGuide::of(material_of(lobe));
    const AnyModel model(lobe);
    for (const float degrees : {10.0f, 45.0f, 80.0f}) {
        Imath::V3d sum(0, 0, 0);
        constexpr int kSteps = 800;
        for (int iz = 0; iz < kSteps; ++iz)
            for (int ip = 0; ip < kSteps; ++ip) {
                const float z = (iz + 0.5f) / kSteps, phi = 2 * kPi * (ip + 0.5f) / kSteps, s = std::sqrt(1 - z * z);
                const Vec3f wi(s * std::cos(phi), s * std::sin(phi), z);
                sum += Imath::V3d(wi) * static_cast<double>(luminance(model.eval(view(degrees), wi)) * z);
            }
        EXPECT_NEAR(reflected_degrees(guide, degrees), std::atan2(-sum.x, sum.z) * 180 / M_PI, 0.7f) << degrees;
    }
}

TEST(FactorGuide, StaysAMirrorWhereNothingIsReflected) { EXPECT_NEAR(reflected_degrees(FactorGuide::of({}), 40), 40, 0.2f); }

}  // namespace
}  // namespace burnish
