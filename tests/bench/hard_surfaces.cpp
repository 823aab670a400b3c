#include "bench/hard_surfaces.h"

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace burnish {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

AovFrame empty_frame(int width, int height) {
    AovFrame frame;
    frame.file = "made";
    frame.data_window = frame.display_window = {0, 0, width, height};
    frame.layers[Role::position] = Image(width, height, 3);
    frame.layers[Role::normal] = Image(width, height, 3);
    frame.camera = Camera{};
    frame.camera->centre = Vec3f(0, 0, 3);
    return frame;
}

void set_pixel(AovFrame& frame, int x, int y, const Vec3f& p, const Vec3f& n) {
    const Vec3f unit = n.normalized();
    std::copy_n(&p.x, 3, frame.layers.at(Role::position).at(x, y));
    std::copy_n(&unit.x, 3, frame.layers.at(Role::normal).at(x, y));
}

}  // namespace

float noise(int x, int y) {
    uint32_t h = static_cast<uint32_t>(x) * 0x9E3779B1u ^ static_cast<uint32_t>(y) * 0x85EBCA77u;
    h = (h ^ h >> 15) * 0x2C1B3C6Du, h = (h ^ h >> 12) * 0x297A2D39u;
    return static_cast<float>((h ^ h >> 15) >> 8) * 0x1p-24f;
}

float ramp(int x) { return std::fabs(static_cast<float>(x % 1200) - 600) / 600; }

float waves(int x, int y, float period) {
    return 0.5f + 0.5f * std::sin(kTurn * static_cast<float>(x) / period) * std::sin(kTurn * static_cast<float>(y) / period);
}

Vec2f noisy_slope(int x, int y) { return {0.1f * noise(x, y) - 0.05f, 0.1f * noise(x + 7919, y) - 0.05f}; }

Vec2f faint_slope(int x, int y) { return noisy_slope(x, y) * 0.2f; }

Vec2f bumpy_slope(int x, int y) {
    const float u = kTurn * static_cast<float>(x) / 12, v = kTurn * static_cast<float>(y) / 12;
    return {0.3f * std::cos(u) * std::sin(v), 0.3f * std::sin(u) * std::cos(v)};
}

Vec2f wavy_slope(int x, int y) {
    const float u = kTurn * static_cast<float>(x) / 200, v = kTurn * static_cast<float>(y) / 200;
    return {0.2f * std::cos(u) * std::sin(v), 0.2f * std::sin(u) * std::cos(v)};
}

Vec2f tiled_slope(int x, int y) {
    const auto bevel = [](int place) { return place % 24 < 2 ? -0.5f : place % 24 >= 22 ? 0.5f : 0.0f; };
    return {bevel(x), bevel(y)};
}

void tilt_normals(AovFrame& frame, Vec2f (*slope)(int x, int y)) {
    Image& normals = frame.layers.at(Role::normal);
    for (int y = 0; y < normals.height; ++y)
        for (int x = 0; x < normals.width; ++x) {
            float* at = normals.at(x, y);
            const Vec3f n(at[0], at[1], at[2]);
            if (n.length2() == 0) continue;
            const Vec3f across = n.cross(Vec3f(0, 1, 0.1f)).normalized(), along = n.cross(across);
            const Vec2f by = slope(x, y);
            const Vec3f tilted = (n + across * by.x + along * by.y).normalized();
            std::copy_n(&tilted.x, 3, at);
        }
}

void round_to_half(Image& image) {
    for (float& value : image.data) value = static_cast<float>(Imath::half(value));
}

AovFrame wire_frame(int width, int height, float thickness) {
    AovFrame frame = empty_frame(width, height);
    constexpr float kSlant = 0.31f, kSpacing = 24;
    const float pixel = 2.0f / static_cast<float>(width);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float place = static_cast<float>(x) + kSlant * static_cast<float>(y) + 0.37f;
            const float off = 2 * (std::fmod(place, kSpacing) - 0.5f * kSpacing) / (thickness * std::hypot(1.0f, kSlant));
            if (std::fabs(off) >= 1) continue;
            const Vec3f p(pixel * static_cast<float>(x) - 1, 0.5f - pixel * static_cast<float>(y), 0);
            const Vec3f across = Vec3f(1, -kSlant, 0).normalized();
            set_pixel(frame, x, y, p, across * off + Vec3f(0, 0, std::sqrt(1 - off * off)));
        }
    return frame;
}

AovFrame plane_frame(int width, int height) {
    AovFrame frame = empty_frame(width, height);
    const Vec3f n(0, std::sqrt(0.75f), 0.5f);
    const float pixel = 2.0f / static_cast<float>(width);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec3f d(pixel * static_cast<float>(x) - 1, 0.5f - pixel * static_cast<float>(y), -3);
            const float t = Vec3f(0, 0, 3).dot(n) / -d.dot(n);
            set_pixel(frame, x, y, Vec3f(0, 0, 3) + d * t, n);
        }
    return frame;
}

}  // namespace burnish
