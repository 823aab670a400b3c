// Rays against shapes whose hits are known in closed form.
#include <burnish/base/error.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/trace.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

Scene sphere_on_plane() {
    Matrix44f lift;
    lift.setTranslation(Vec3f(0, 0, 1));
    Scene scene;
    scene.objects.push_back({"floor", "", make_plane(50, 50), 1, 1, Color3f(0.5f), 1});
    scene.objects.push_back({"ball", "", transformed(make_sphere(1, 1024), lift), 2, 2, Color3f(0.5f), 1});
    return scene;
}

TEST(Tracer, HitsSphereAndPlaneWhereGeometrySays) {
    const Scene scene = sphere_on_plane();
    const Tracer tracer(scene);
    const Vec3f origin(0.5f, -6, 3), centre(0, 0, 1);
    int on_ball = 0, on_floor = 0;
    for (uint32_t i = 0; i < 4096; ++i) {
        const Vec2f u = owen_sobol(i, 0);
        const Vec3f d = (Vec3f(6 * u.x - 3, 0, 4 * u.y - 1) - origin).normalized();
        const float b = d.dot(origin - centre), square = b * b - (origin - centre).length2() + 1;
        if (std::abs(square) < 1e-3f) continue;  // the silhouette of the mesh is not quite the sphere's
        const auto hit = tracer.closest(origin, d);
        const float expected = square > 0 ? -b - std::sqrt(square) : -origin.z / d.z;
        if (square < 0 && (d.z >= 0 || expected > 40)) continue;
        ASSERT_TRUE(hit);
        ASSERT_EQ(hit->object, square > 0 ? 1 : 0);
        const Vec3f p = origin + d * expected, n = square > 0 ? p - centre : Vec3f(0, 0, 1);
        ASSERT_NEAR(hit->distance, expected, 1e-3 + 1e-5 / std::sqrt(std::abs(square)));
        ASSERT_NEAR((hit->p - p).length(), 0, 1e-3);
        ASSERT_NEAR((hit->n - n).length(), 0, 2e-3);
        ASSERT_NEAR(hit->n.length(), 1, 1e-5);
        ASSERT_NEAR(hit->ng.length(), 1, 1e-5);
        ASSERT_LT(hit->ng.dot(d), 0);
        ASSERT_NEAR(hit->t.dot(hit->n), 0, 1e-5);
        ++(square > 0 ? on_ball : on_floor);
    }
    EXPECT_GT(on_ball, 400);
    EXPECT_GT(on_floor, 400);
}

TEST(Tracer, DistanceIsMeasuredInLengthsOfTheDirection) {
    const Scene scene = sphere_on_plane();
    const auto hit = Tracer(scene).closest({5, 5, 4}, {0, 0, -2});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 2, 1e-6);
}

TEST(Tracer, SeesTheInsideOfASurfaceWithNormalsTurnedToTheRay) {
    const Scene scene = sphere_on_plane();
    const auto hit = Tracer(scene).closest({0, 0, 1}, {1, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->n.x, -1, 1e-4);
    EXPECT_LT(hit->ng.x, 0);
}

TEST(Tracer, RaysGoThroughHiddenObjects) {
    const Scene scene = sphere_on_plane();
    const Tracer tracer(scene);
    const int ball[] = {1}, both[] = {0, 1};
    ASSERT_EQ(tracer.closest({0, 0, 5}, {0, 0, -1})->object, 1);
    const auto hit = tracer.closest({0, 0, 5}, {0, 0, -1}, 0, kInfinitelyFar, ball);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->object, 0);
    EXPECT_FLOAT_EQ(hit->distance, 5);
    EXPECT_FALSE(tracer.closest({0, 0, 5}, {0, 0, -1}, 0, kInfinitelyFar, both));
}

TEST(Tracer, OcclusionEndsAtTheGivenDistance) {
    const Scene scene = sphere_on_plane();
    const Tracer tracer(scene);
    EXPECT_TRUE(tracer.occluded({0, 0, 5}, {0, 0, -1}));
    EXPECT_TRUE(tracer.occluded({0, 0, 5}, {0, 0, -1}, 3.01f));
    EXPECT_FALSE(tracer.occluded({0, 0, 5}, {0, 0, -1}, 2.99f));
    EXPECT_FALSE(tracer.occluded({0, 0, 5}, {0, 0, 1}));
}

TEST(Tracer, RaysThatLeaveASurfaceDoNotMeetIt) {
    const Scene scene = sphere_on_plane();
    const Tracer tracer(scene);
    for (uint32_t i = 0; i < 1000; ++i) {
        const Vec2f u = owen_sobol(i, 3);
        const auto hit = tracer.closest({40 * u.x - 20, 40 * u.y - 20, 30}, {0, 0, -1});
        ASSERT_TRUE(hit);
        ASSERT_FALSE(tracer.occluded(leaving_point(*hit), hit->n));
    }
}

TEST(Tracer, EmptySceneIsHitByNothing) {
    const Scene scene;
    const Tracer tracer(scene);
    EXPECT_FALSE(tracer.closest({0, 0, 0}, {0, 0, 1}));
    EXPECT_FALSE(tracer.occluded({0, 0, 0}, {0, 0, 1}));
}

TEST(Tracer, RefusesTrianglesThatNameNoVertex) {
    Scene scene = sphere_on_plane();
    scene.objects[0].mesh.triangles[0][1] = 99;
    try {
        const Tracer tracer(scene);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        EXPECT_NE(std::string(error.what()).find("floor"), std::string::npos);
    }
}

}  // namespace
}  // namespace burnish
