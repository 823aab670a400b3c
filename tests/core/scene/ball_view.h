// A ball on a floor and the camera that sees them, for the tests of what is traced.
#pragma once

#include <burnish/scene/gbuffer.h>

namespace burnish {

inline constexpr int kWidth = 160, kHeight = 90;

struct BallView {
    Scene scene;
    Camera camera;

    BallView() {
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

}  // namespace burnish
