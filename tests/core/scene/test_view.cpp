// Cameras of mirrors and panes: which pixel sees what, and what they must not see.
#include <burnish/sampling/sequence.h>
#include <burnish/scene/gbuffer.h>

#include <core/scene/ball_view.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr HalfSpace kFloor{{0, 0, 0}, {0, 0, -2}};  // any normal will do

/// A tilted mirror behind the ball and a camera whose lens is shifted.
struct TiltedMirror : BallView {
    HalfSpace mirror{{0, 3, 0}, {0.2f, -1, 0.1f}};
    TiltedMirror() { camera.axis += camera.up * 0.3f; }
};

TEST(View, PixelsOfAMirrorSeeWhatTheFrameSeesReflectedLeftForRight) {
    const TiltedMirror scene;
    const Tracer tracer(scene.scene);
    const View frame{scene.camera, kWidth, kHeight}, mirror = mirror_view(frame, scene.mirror);
    const Vec3f n = scene.mirror.normal.normalized();
    int seen = 0;
    for (uint32_t i = 0; i < 16384; ++i) {
        const Vec2f raster = owen_sobol(i, 0) * Vec2f(kWidth, kHeight);
        const Vec3f d = scene.camera.ray(screen_point(raster, kWidth, kHeight));
        const float s = (scene.mirror.point - scene.camera.centre).dot(n) / d.dot(n);
        if (!(s > 0)) continue;
        const auto expected = tracer.closest(scene.camera.centre + d * s, d - n * (2 * n.dot(d)));
        const auto hit = mirror.closest(tracer, {kWidth - raster.x, raster.y});
        if (expected && expected->distance < 1e-2f) continue;  // where the mirror cuts the floor
        ASSERT_EQ(hit.has_value(), expected.has_value());
        if (!hit) continue;
        ASSERT_EQ(hit->object, expected->object);
        ASSERT_NEAR((hit->p - expected->p).length(), 0, 2e-4 * expected->distance);
        ASSERT_NEAR(hit->distance, s + expected->distance, 2e-4 * hit->distance);
        ++seen;
    }
    EXPECT_GT(seen, 300);
}

TEST(View, AMirrorDoesNotSeeItsOwnPlaneNorWhatIsBehind) {
    const BallView scene;
    const Tracer tracer(scene.scene);
    const AovFrame frame = trace_gbuffer(tracer, mirror_view({scene.camera, kWidth, kHeight}, kFloor), {});
    int ball = 0;
    for (const float id : frame.layer(Role::object_id).data) {
        ASSERT_NE(id, 3);
        ball += id == 7;
    }
    EXPECT_GT(ball, 500);
    ASSERT_TRUE(frame.camera);
    EXPECT_NEAR(frame.camera->centre.z, -scene.camera.centre.z, 1e-6);
}

TEST(View, ThroughAPaneOnlyWhatIsBehindItIsSeen) {
    BallView scene;
    scene.scene.objects.push_back({"pane", "", make_plane(1, 1), 9, 1, Color3f(0.5f), 0});
    Matrix44f upright;
    upright.setEulerAngles(Vec3f(kPi / 2, 0, 0));
    upright[3][1] = -3, upright[3][2] = 1;
    scene.scene.objects.back().mesh = transformed(scene.scene.objects.back().mesh, upright);
    const Tracer tracer(scene.scene);
    View view = behind_view({scene.camera, kWidth, kHeight}, {{0, -3, 0}, {0, 1, 0}});
    view.hidden = {2};
    const AovFrame frame = trace_gbuffer(tracer, view, {}), whole = trace_gbuffer(tracer, scene.camera, kWidth, kHeight, {});
    const Image &position = frame.layer(Role::position), &depth = frame.layer(Role::depth);
    int changed = 0;
    for (size_t i = 0; i < position.pixel_count(); ++i) {
        const float id = *frame.layer(Role::object_id).at(i), before = *whole.layer(Role::object_id).at(i);
        ASSERT_NE(id, 9);
        if (id == 0) continue;
        ASSERT_GT(position.at(i)[1], -3);
        const Vec3f p(position.at(i)[0], position.at(i)[1], position.at(i)[2]);
        ASSERT_NEAR((p - scene.camera.centre).dot(scene.camera.forward()), *depth.at(i), 1e-3);
        changed += before == 9;
    }
    EXPECT_GT(changed, 500);
}

}  // namespace
}  // namespace burnish
