// G-buffers: every layer tells of the same point of the same object.
#include <burnish/base/parallel.h>
#include <burnish/scene/gbuffer.h>

#include <core/scene/ball_view.h>

#include <gtest/gtest.h>

#include <cstring>

namespace burnish {
namespace {

float number(const AovFrame& frame, Role role, size_t pixel) { return *frame.layer(role).at(pixel); }
Vec3f vector(const AovFrame& frame, Role role, size_t pixel) {
    const float* v = frame.layer(role).at(pixel);
    return {v[0], v[1], v[2]};
}

TEST(Gbuffer, PositionLiesOnThePixelsRayAtItsPlanarDepth) {
    const BallView view;
    const Tracer tracer(view.scene);
    const AovFrame frame = trace_gbuffer(tracer, view.camera, kWidth, kHeight, {});
    size_t hits = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const size_t pixel = static_cast<size_t>(y) * kWidth + x;
            const float z = number(frame, Role::depth, pixel);
            if (z == kMissDepth) continue;
            const Vec3f p = vector(frame, Role::position, pixel);
            const Vec2f centre((2 * x + 1.0f) / kWidth - 1, 1 - (2 * y + 1.0f) / kHeight);
            ASSERT_NEAR((p - view.camera.centre - view.camera.ray(centre) * z).length(), 0, 1e-4);
            ASSERT_NEAR((p - view.camera.centre).dot(view.camera.axis), z, 1e-4);
            ++hits;
        }
    EXPECT_GT(hits, 4000u);
}

TEST(Gbuffer, LayersBelongToTheObjectThatWasHit) {
    const BallView view;
    const Tracer tracer(view.scene);
    const AovFrame frame = trace_gbuffer(tracer, view.camera, kWidth, kHeight, {});
    size_t seen[3] = {};
    for (size_t i = 0; i < frame.layer(Role::depth).pixel_count(); ++i) {
        const float id = number(frame, Role::object_id, i);
        const Vec3f p = vector(frame, Role::position, i), n = vector(frame, Role::normal, i);
        const bool floor = id == 3, ball = id == 7;
        ++seen[floor ? 1 : ball ? 2 : 0];
        ASSERT_EQ(number(frame, Role::material_id, i), floor ? 1 : ball ? 2 : 0);
        ASSERT_EQ(number(frame, Role::roughness, i), floor ? 0.25f : ball ? 0.75f : 0);
        if (floor) {
            ASSERT_NEAR((n - Vec3f(0, 0, 1)).length(), 0, 1e-6);
            ASSERT_NEAR(frame.layer(Role::uv).at(i)[0], (p.x + 4) / 8, 1e-5);
            ASSERT_NEAR((vector(frame, Role::tangent, i) - Vec3f(1, 0, 0)).length(), 0, 1e-6);
        } else if (ball) {
            ASSERT_NEAR((n - (p - Vec3f(0.3f, 0, 1))).length(), 0, 1e-3);
            ASSERT_NEAR(n.length(), 1, 1e-5);
            ASSERT_NEAR(vector(frame, Role::tangent, i).z, 0, 1e-2);
        } else {
            ASSERT_EQ(n, Vec3f(0.0f));
            ASSERT_EQ(number(frame, Role::depth, i), kMissDepth);
        }
    }
    for (const size_t count : seen) EXPECT_GT(count, 500u);
}

TEST(Gbuffer, IsTheSameForAnyThreadCount) {
    const BallView view;
    const auto traced = [&](int threads) {
        const ThreadLimit limit(threads);
        const Tracer tracer(view.scene);
        return trace_gbuffer(tracer, view.camera, kWidth, kHeight, {});
    };
    const AovFrame one = traced(1), two = traced(2);
    for (const auto& [role, image] : one.layers)
        EXPECT_EQ(std::memcmp(image.data.data(), two.layer(role).data.data(), image.data.size() * sizeof(float)), 0);
}

}  // namespace
}  // namespace burnish
