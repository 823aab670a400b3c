// Cryptomattes of a traced scene: coverage is area, ranks are in order.
#include <burnish/input/cryptomatte.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/object_matte.h>

#include <core/scene/ball_view.h>

#include <gtest/gtest.h>

#include <bit>

namespace burnish {
namespace {

TEST(ObjectMatte, CoversTheDiscOfASphereByItsArea) {
    const BallView view;
    const Tracer tracer(view.scene);
    const Cryptomatte matte = trace_object_matte(tracer, view.camera, kWidth, kHeight, 4, 4, "CryptoObject", {});
    ASSERT_EQ(matte.manifest.at("ball"), cryptomatte_id("ball"));
    double coarse = 0, fine = 0;
    for (size_t i = 0; i < matte.ranks[0].pixel_count(); ++i)
        for (const Image& rank : matte.ranks)
            if (std::bit_cast<uint32_t>(rank.at(i)[0]) == cryptomatte_id("ball")) coarse += rank.at(i)[1];
    const AovFrame frame = trace_gbuffer(tracer, view.camera, kWidth * 8, kHeight * 8, {});
    for (const float id : frame.layer(Role::object_id).data) fine += id == 7;
    EXPECT_NEAR(coarse, fine / 64, 2e-3 * coarse);
}

TEST(ObjectMatte, RanksFallAndSumToTheShareThatHitsAnything) {
    const BallView view;
    const Tracer tracer(view.scene);
    const Cryptomatte matte = trace_object_matte(tracer, view.camera, kWidth, kHeight, 4, 4, "CryptoObject", {});
    size_t mixed = 0;
    for (size_t i = 0; i < matte.ranks[0].pixel_count(); ++i) {
        float sum = 0, last = 1;
        for (const Image& rank : matte.ranks) {
            ASSERT_LE(rank.at(i)[1], last);
            last = rank.at(i)[1], sum += last;
        }
        ASSERT_LE(sum, 1.0f);
        mixed += matte.ranks[1].at(i)[1] > 0;
    }
    EXPECT_GT(mixed, 50u);
}

}  // namespace
}  // namespace burnish
