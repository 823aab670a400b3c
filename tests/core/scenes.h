// Frames and lights made in code, for tests and benchmarks that need no files.
#pragma once

#include <burnish/input/assign.h>
#include <burnish/input/frame.h>
#include <burnish/material/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace burnish::scenes {

/// A lobe of these widths, F = 1; Kurt with alpha 0.4.
inline LobeParameters lobe_of(ModelId model, float mx, float my) {
    LobeParameters lobe;
    lobe.model = model, lobe.mx = mx, lobe.my = my;
    if (model == ModelId::kurt) lobe.extra = {0.4f};
    return lobe;
}

/// A unit sphere at the origin seen from (0, 0, distance), y up, filling the square frame; background P = N = 0.
inline AovFrame sphere_frame(int size, float distance = 6.0f) {
    AovFrame frame;
    frame.file = "sphere";
    frame.data_window = frame.display_window = {0, 0, size, size};
    Image position(size, size, 3), normal(size, size, 3);
    const float half = std::sqrt(1 / (distance * distance - 1));  // tangent of the angle the sphere's outline is seen under
    Camera camera;
    camera.centre = Vec3f(0, 0, distance);
    camera.axis = Vec3f(0, 0, -1), camera.right = Vec3f(half, 0, 0), camera.up = Vec3f(0, half, 0);
    camera.has_rays = true;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Vec3f d = camera.ray({2 * (x + 0.5f) / size - 1, 1 - 2 * (y + 0.5f) / size}).normalized();
            const double b = camera.centre.dot(d), c = camera.centre.length2() - 1, root = b * b - c;
            if (root <= 0) continue;
            const Vec3f p = camera.centre + d * static_cast<float>(-b - std::sqrt(root)), n = p.normalized();
            std::copy_n(&p.x, 3, position.at(x, y));
            std::copy_n(&n.x, 3, normal.at(x, y));
        }
    frame.layers[Role::position] = std::move(position);
    frame.layers[Role::normal] = std::move(normal);
    frame.camera = camera;
    return frame;
}

/// The same sphere, `radius` pixels large, in the middle of a width x height frame.
inline AovFrame sphere_in_frame(int width, int height, int radius) {
    const int size = 2 * radius, left = (width - size) / 2, top = (height - size) / 2;
    const AovFrame sphere = sphere_frame(size);
    AovFrame frame;
    frame.file = "sphere";
    frame.data_window = frame.display_window = {0, 0, width, height};
    for (const Role role : {Role::position, Role::normal}) {
        Image layer(width, height, 3);
        for (int y = std::max(0, -top); y < std::min(size, height - top); ++y)
            std::copy_n(sphere.layer(role).at(0, y), 3 * size, layer.at(left, top + y));
        frame.layers[role] = std::move(layer);
    }
    frame.camera = sphere.camera;
    frame.camera->right *= static_cast<float>(width) / size, frame.camera->up *= static_cast<float>(height) / size;
    return frame;
}

/// A gently waved sheet that covers every pixel of a width x height frame, seen from (0, 0, 3); normals within 30 degrees of +Z.
inline AovFrame covered_frame(int width, int height) {
    AovFrame frame;
    frame.file = "covered";
    frame.data_window = frame.display_window = {0, 0, width, height};
    Image position(width, height, 3), normal(width, height, 3);
    const float aspect = static_cast<float>(height) / width;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float px = 2 * (x + 0.5f) / width - 1, py = aspect * (1 - 2 * (y + 0.5f) / height);
            const Vec3f p(px, py, 0.1f * std::sin(4 * px) * std::cos(5 * py));
            const Vec3f n =
                Vec3f(-0.4f * std::cos(4 * px) * std::cos(5 * py), 0.5f * std::sin(4 * px) * std::sin(5 * py), 1).normalized();
            std::copy_n(&p.x, 3, position.at(x, y));
            std::copy_n(&n.x, 3, normal.at(x, y));
        }
    frame.layers[Role::position] = std::move(position);
    frame.layers[Role::normal] = std::move(normal);
    frame.camera = Camera{};
    frame.camera->centre = Vec3f(0, 0, 3);
    return frame;
}

/// Rule 0 everywhere, full coverage.
inline Assignment whole_frame(const AovFrame& frame) {
    const Image& any = frame.layers.begin()->second;
    Assignment assignment;
    assignment.width = any.width, assignment.height = any.height;
    assignment.rule.assign(any.pixel_count(), 0);
    assignment.coverage.assign(any.pixel_count(), 1.0f);
    assignment.counts = {any.pixel_count()};
    return assignment;
}

/// A lat-long of constant radiance.
inline Image constant_light(float value, int height = 32) { return Image(2 * height, height, 3, value); }

/// The stress light of the sources: `spots` discs of 2-10 degrees at random over the sphere, intensities up to 3000:1
/// (log-uniform) on a background of 1; edges anti-aliased 4 x 4.
inline Image stress_light(uint32_t seed, int height = 512, int spots = 40) {
    struct Spot {
        double x, y, z, cos_radius, intensity;
    };
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<Spot> list;
    const double pi = std::numbers::pi;
    for (int i = 0; i < spots; ++i) {
        const double z = 2 * uniform(random) - 1, phi = 2 * pi * uniform(random), r = std::sqrt(1 - z * z);
        const double diameter_deg = 2 + 8 * uniform(random);
        list.push_back({r * std::cos(phi), r * std::sin(phi), z, std::cos(diameter_deg / 2 * pi / 180),
                        std::pow(3000.0, uniform(random))});
    }
    Image light(2 * height, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x) {
            double sum = 0;
            for (int sub = 0; sub < 16; ++sub) {
                const double theta = pi * (y + (sub / 4 + 0.5) / 4) / height, phi = pi * (x + (sub % 4 + 0.5) / 4) / height;
                const double dx = std::sin(theta) * std::cos(phi), dy = std::sin(theta) * std::sin(phi), dz = std::cos(theta);
                double value = 1;
                for (const Spot& s : list)
                    if (dx * s.x + dy * s.y + dz * s.z > s.cos_radius) value = std::max(value, s.intensity);
                sum += value / 16;
            }
            std::fill_n(light.at(x, y), 3, static_cast<float>(sum));
        }
    return light;
}

}  // namespace burnish::scenes
