#include "core/input/synthetic_view.h"

#include <gtest/gtest.h>

using namespace burnish;

TEST(Camera, SeesTheMiddleOfPixelsOfTheDisplayWindow) {
    const Window display{10, 20, 200, 100};
    EXPECT_EQ(screen_point(10, 20, display), Vec2f(-0.995f, 0.99f));
    EXPECT_EQ(screen_point(209, 119, display), Vec2f(0.995f, -0.99f));
    EXPECT_GT(screen_point(10, 10, display).y, 1) << "overscan above the window lies above 1";
}

TEST(Camera, ProjectsWhatItsRaysReach) {
    const Camera camera = camera_looking({3, -4, 2}, {0, 1, 1}, 0.7f, 1.5f, 0.4f, -0.3f);
    for (const Vec2f& s : {Vec2f(0, 0), Vec2f(-0.9f, 0.3f), Vec2f(0.8f, 1.4f)})
        for (const float z : {0.1f, 1.0f, 50.0f}) {
            const auto projected = camera.project(camera.centre + camera.ray(s) * z);
            ASSERT_TRUE(projected);
            EXPECT_NEAR((*projected - s).length(), 0, 2e-6f * 4 / std::min(z, 1.0f));
        }
    EXPECT_FALSE(camera.project(camera.centre - camera.axis)) << "a point behind the camera is not seen";
}

TEST(Camera, LooksAlongThePerpendicularOfItsImagePlaneWhateverTheShift) {
    const Camera camera = camera_looking({0, -5, 1}, {0, 0, 1}, 0.5f, 1, 0.7f, 0.2f);
    EXPECT_NEAR((camera.forward() - Vec3f(0, 1, 0)).length(), 0, 1e-6);
}
