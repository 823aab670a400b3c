// Cryptomattes of a traced scene: coverage is area, ranks are in order.
#include <burnish/input/cryptomatte.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/object_matte.h>

#include <gtest/gtest.h>

#include <bit>

namespace burnish {
namespace {

constexpr int kWidth = 160, kHeight = 90;

struct View {
    Scene scene;
    Camera camera;

    View() {
        Matrix44f lift;
        lift.setTranslation(Vec3f(0.3f, 0, 1));
        scene.objects.push_back({"floor", "", make_plane(4, 4), 3, 1, Color3f(0.5f), 0.25f});
        scene.objects.push_back({"ball", "", transformed(make_sphere(1, 512), lift), 7, 2, Color3f(0.5f), 0.75f});
        camera.centre = {0.5f, -6, 2};
        camera.axis = Vec3f(0, 1, -0.2f).normalized();
        camera.right = {0.6f, 0, 0};
        camera.up = camera.right.cross(camera.axis) * (9.0f / 16);
        camera.has_rays = true;
    }
};

TEST(ObjectMatte, CoversTheDiscOfASphereByItsArea) {
    const View view;
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
    const View view;
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
