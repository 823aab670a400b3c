#include "area_cases.h"

#include <cmath>

namespace burnish::area_cases {
namespace {

const Vec3f kCamera(0, -4, 1.6f), kAside(-3, 0.6f, 1.6f);

/// A rectangle about `centre` that faces `towards`, its lower edge level.
std::vector<Vec3f> rectangle(const Vec3f& centre, const Vec3f& towards, float width, float height) {
    const Vec3f n = (towards - centre).normalized(), x = Vec3f(0, 0, 1).cross(n).normalized() * (width / 2),
                y = n.cross(x).normalized() * (height / 2);
    return {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
}

/// Grey tiles with a gradient over them, and a few bulbs thirty times as bright.
Image screen() {
    constexpr int kWidth = 96, kHeight = 64;
    Image image(kWidth, kHeight, 3);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float tile = (x / 12 + y / 16) % 2 == 0 ? 1.0f : 0.2f, slope = static_cast<float>(x) / kWidth;
            const float dx = static_cast<float>(x % 32 - 16), dy = static_cast<float>(y % 32 - 16);
            const float bulb = 30 * std::exp(-(dx * dx + dy * dy) / 12);
            float* rgb = image.at(x, y);
            rgb[0] = tile * slope + bulb, rgb[1] = tile * 0.6f + bulb, rgb[2] = tile * (1 - slope) + 0.6f * bulb;
        }
    return image;
}

void add(const Vec3f& camera, const Vec3f& p, const Vec3f& n, SurfaceBatch& batch) {
    batch.pixel.push_back(static_cast<uint32_t>(batch.pixel.size()));
    batch.p.push_back(p), batch.n.push_back(n), batch.t.push_back(Frame::around(n).t);
    batch.wo.push_back((camera - p).normalized());
}

}  // namespace

std::vector<Lamp> lamps(bool textured) {
    const Vec3f at(0, 0, 0.3f);
    const Image picture = textured ? screen() : Image();
    std::vector<Lamp> list{{"far", {rectangle({0.5f, 4, 2.2f}, at, 2, 1.2f)}, picture},
                           {"near", {rectangle({-0.3f, 1.2f, 0.9f}, at, 1.6f, 1)}, picture},
                           {"small", {rectangle({0.4f, 0.8f, 0.8f}, at, 0.25f, 0.2f)}, picture},
                           {"strip", {rectangle({0, 1.5f, 1.2f}, at, 2.4f, 0.12f)}, picture}};
    for (Lamp& lamp : list) lamp.settings.radiance = Color3f(10);
    return list;
}

SurfaceBatch floor_view(int columns, int rows) {
    SurfaceBatch batch;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const float sx = 1.1f * (2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(columns) - 1),
                        sy = -0.12f - 0.65f * (static_cast<float>(y) + 0.5f) / static_cast<float>(rows);
            const Vec3f ray(sx * 0.7f, 1, sy);
            add(kCamera, kCamera + ray * (-kCamera.z / ray.z), {0, 0, 1}, batch);
        }
    return batch;
}

SurfaceBatch sphere_view(int columns, int rows) {
    const Vec3f centre(0, 0, 0.5f);
    const Vec3f forward = (centre - kAside).normalized(), right = forward.cross(Vec3f(0, 0, 1)).normalized(),
                up = right.cross(forward);
    SurfaceBatch batch;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            const float sx = 2 * (static_cast<float>(x) + 0.5f) / static_cast<float>(columns) - 1,
                        sy = 1 - 2 * (static_cast<float>(y) + 0.5f) / static_cast<float>(rows);
            const Vec3f ray = (forward + (right * sx + up * sy) * 0.17f).normalized(), from = kAside - centre;
            const float b = from.dot(ray), root = b * b - from.length2() + 0.25f;
            if (root <= 0.002f) continue;
            const Vec3f p = from + ray * (-b - std::sqrt(root));
            add(kAside, p + centre, p.normalized(), batch);
        }
    return batch;
}

}  // namespace burnish::area_cases
