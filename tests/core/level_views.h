// Frames of level surfaces, one above the other, and of a ball: what tests of places need.
#pragma once

#include "core/scenes.h"

#include <functional>

namespace burnish::scenes {

/// What a camera sees: along a unit direction from the eye, false where there is nothing.
using Seen = std::function<bool(const Vec3f& eye, const Vec3f& d, Vec3f& p, Vec3f& n)>;

/// `elevation` in degrees, looking at the origin from the distance 4, 40 degrees wide.
inline AovFrame view_of(const Seen& scene, float elevation, float scale = 1, Vec3f offset = Vec3f(0), int size = 160) {
    const float angle = elevation * kPi / 180;
    Camera camera;
    camera.centre = Vec3f(0, -4 * std::cos(angle), 4 * std::sin(angle));
    camera.axis = -camera.centre.normalized(), camera.has_rays = true;
    const Vec3f up(0, std::sin(angle), std::cos(angle));
    camera.right = camera.axis.cross(up) * 0.36f, camera.up = up * 0.36f;
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, size, size};
    Image position(size, size, 3), normal(size, size, 3);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            Vec3f p, n;
            const auto centre = [&](int i) { return 2 * (static_cast<float>(i) + 0.5f) / static_cast<float>(size) - 1; };
            if (!scene(camera.centre, camera.ray({centre(x), -centre(y)}).normalized(), p, n)) continue;
            p = p * scale + offset;
            std::copy_n(&p.x, 3, position.at(x, y)), std::copy_n(&n.x, 3, normal.at(x, y));
        }
    camera.centre = camera.centre * scale + offset;
    frame.layers[Role::position] = std::move(position), frame.layers[Role::normal] = std::move(normal);
    frame.camera = camera;
    return frame;
}

inline bool level(float height, const Vec3f& eye, const Vec3f& d, Vec3f& p, Vec3f& n) {
    if (d.z >= 0) return false;
    p = eye + d * ((height - eye.z) / d.z), n = Vec3f(0, 0, 1);
    return true;
}

inline bool floor_only(const Vec3f& eye, const Vec3f& d, Vec3f& p, Vec3f& n) { return level(0, eye, d, p, n); }

/// A square top half a unit above the floor, without sides.
inline bool table(const Vec3f& eye, const Vec3f& d, Vec3f& p, Vec3f& n) {
    return (level(0.5f, eye, d, p, n) && std::max(std::fabs(p.x), std::fabs(p.y)) < 0.4f) || level(0, eye, d, p, n);
}

inline bool ball(const Vec3f& eye, const Vec3f& d, Vec3f& p, Vec3f& n) {
    const double b = eye.dot(d), root = b * b - (eye.dot(eye) - 1.0);
    p = eye + d * static_cast<float>(-b - std::sqrt(std::max(root, 0.0))), n = p.normalized();
    return root > 0;
}

}  // namespace burnish::scenes
