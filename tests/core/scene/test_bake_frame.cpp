// Beauty, albedo and irradiance of light maps as a camera sees them.
#include <burnish/scene/bake_frame.h>
#include <burnish/scene/gbuffer.h>

#include <core/scene/ball_view.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

/// Irradiance / pi that grows along u.
Image ramp() {
    Image map(64, 4, 3);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            for (int c = 0; c < 3; ++c) map.at(x, y)[c] = static_cast<float>(x + 1) * static_cast<float>(c + 1);
    return map;
}

TEST(BakeFrame, BeautyIsAlbedoTimesIrradianceOverPiPlusEmission) {
    BallView view;
    view.scene.objects[0].albedo = {0.25f, 0.5f, 1}, view.scene.objects[1].emission = {3, 2, 1};
    const Tracer tracer(view.scene);
    LightMaps maps;
    maps.irradiance = ramp();
    const SurfaceLight light(view.scene, std::move(maps));
    const View seen{view.camera, kWidth, kHeight};
    AovFrame frame = trace_gbuffer(tracer, seen, {});
    add_seen_light(frame, tracer, seen, light, 16, LightParts::apart, {});
    int floor = 0, ball = 0, sky = 0;
    for (int y = 1; y < kHeight - 1; ++y)
        for (int x = 1; x < kWidth - 1; ++x) {
            const auto id = [&](int dx, int dy) { return *frame.layer(Role::object_id).at(x + dx, y + dy); };
            bool inside = true;
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) inside &= id(dx, dy) == id(0, 0);
            if (!inside) continue;
            const float *beauty = frame.layer(Role::beauty).at(x, y), *e = frame.layer(Role::irradiance).at(x, y);
            const float* albedo = frame.layer(Role::diffuse_albedo).at(x, y);
            ASSERT_EQ(*frame.layer(Role::alpha).at(x, y), id(0, 0) == 0 ? 0 : 1);
            for (int c = 0; c < 3; ++c) {
                const float emission = id(0, 0) == 7 ? static_cast<float>(3 - c) : 0.0f;
                ASSERT_NEAR(beauty[c], albedo[c] * e[c] / kPi + emission, 2e-3 * (beauty[c] + 1));
                if (id(0, 0) == 3) {
                    const Vec3f p(frame.layer(Role::position).at(x, y)[0], 0, 0);
                    const float u = (p.x + 4) / 8, expected = (64 * u + 0.5f) * static_cast<float>(c + 1);
                    ASSERT_NEAR(e[c] / kPi, expected, 0.03 * expected + 0.1);
                }
            }
            ++(id(0, 0) == 0 ? sky : id(0, 0) == 3 ? floor : ball);
        }
    EXPECT_GT(floor, 1000);
    EXPECT_GT(ball, 300);
    EXPECT_GT(sky, 300);
}

}  // namespace
}  // namespace burnish
