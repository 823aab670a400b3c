// A scene with a known camera: a box room with a ball in it, ray traced in closed form into a position layer.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/camera.h>

#include <cmath>
#include <limits>

namespace burnish {

inline Camera camera_looking(const Vec3f& centre, const Vec3f& target, float half_width, float aspect, float shift_x = 0,
                             float shift_y = 0) {
    Camera camera;
    const Vec3f forward = (target - centre).normalized(), side = forward.cross(Vec3f(0, 0, 1)).normalized();
    camera.centre = centre;
    camera.right = side * half_width;
    camera.up = side.cross(forward) * (half_width / aspect);
    camera.axis = forward + camera.right * shift_x + camera.up * shift_y;
    camera.has_rays = true;
    return camera;
}

/// Distance to the ball from c along r (not unit length), in lengths of r; infinite for a miss.
inline double hit_ball(const Imath::V3d& c, const Imath::V3d& r, const Imath::V3d& ball, double radius) {
    const Imath::V3d o = c - ball;
    const double a = r.dot(r), b = o.dot(r), discriminant = b * b - a * (o.dot(o) - radius * radius);
    const double t = discriminant < 0 ? -1 : (-b - std::sqrt(discriminant)) / a;
    return t > 0 ? t : std::numeric_limits<double>::infinity();
}

/// Distance to the inside of the box [-5, 5] x [-5, 5] x [0, 6].
inline double hit_room(const Imath::V3d& c, const Imath::V3d& r) {
    double t = std::numeric_limits<double>::infinity();
    const Imath::V3d low(-5, -5, 0), high(5, 5, 6);
    for (unsigned k = 0; k < 3; ++k)
        if (r[k] != 0) t = std::min(t, ((r[k] > 0 ? high[k] : low[k]) - c[k]) / r[k]);
    return t;
}

enum class SyntheticScene { room_with_ball, ball_only, floor_only };

/// Position layer of the scene; (0, 0, 0) where nothing is hit, as Cycles writes it.
inline Image position_layer(const Camera& camera, const Window& data, const Window& display, SyntheticScene scene,
                            double radius = 1) {
    Image position(data.width, data.height, 3);
    const Imath::V3d c(camera.centre), axis(camera.axis), right(camera.right), up(camera.up), ball(0.3, 0.5, 1.2);
    for (int y = 0; y < data.height; ++y)
        for (int x = 0; x < data.width; ++x) {
            const double sx = 2 * (data.x + x - display.x + 0.5) / display.width - 1;
            const double sy = 1 - 2 * (data.y + y - display.y + 0.5) / display.height;
            const Imath::V3d r = axis + right * sx + up * sy;
            double t = scene == SyntheticScene::floor_only ? -c.z / r.z : hit_ball(c, r, ball, radius);
            if (scene == SyntheticScene::room_with_ball) t = std::min(t, hit_room(c, r));
            if (!(t > 0) || !std::isfinite(t)) continue;
            for (unsigned k = 0; k < 3; ++k) position.at(x, y)[k] = static_cast<float>(c[k] + t * r[k]);
        }
    return position;
}

/// Largest distance, in units of the window's half size, between where the two cameras see the points of the layer.
inline float largest_reprojection(const Camera& camera, const Image& position, const Window& data, const Window& display) {
    float largest = 0;
    for (int y = 0; y < data.height; ++y)
        for (int x = 0; x < data.width; ++x) {
            const float* p = position.at(x, y);
            if (p[0] == 0 && p[1] == 0 && p[2] == 0) continue;
            const auto s = camera.project({p[0], p[1], p[2]});
            const Vec2f expected = screen_point(data.x + x, data.y + y, display);
            largest = std::max(largest, s ? (*s - expected).length() : std::numeric_limits<float>::infinity());
        }
    return largest;
}

}  // namespace burnish
