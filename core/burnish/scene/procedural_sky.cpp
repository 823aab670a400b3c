#include <burnish/base/parallel.h>
#include <burnish/scene/procedural_sky.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kSunRadius = 0.75f * kPi / 180;
constexpr Color3f kSun{5600.0f, 4700.0f, 3500.0f}, kZenith{0.11f, 0.20f, 0.41f}, kHorizon{0.86f, 0.84f, 0.80f};
constexpr Color3f kGlow{1.0f, 0.80f, 0.55f}, kHills{0.07f, 0.12f, 0.18f};

float smooth_step(float edge0, float edge1, float x) {
    const float t = std::clamp((x - edge0) / (edge1 - edge0), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

Color3f mix(const Color3f& a, const Color3f& b, float t) { return a * (1 - t) + b * t; }

Vec3f direction(float azimuth_deg, float elevation_deg) {
    const float a = azimuth_deg * kPi / 180, e = elevation_deg * kPi / 180;
    return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

/// Share of a soft box seen along d: 1 inside, falling to 0 over the outer fifth.
float coverage(const SoftBox& box, const Vec3f& d) {
    const float depth = d.dot(box.centre);
    if (depth <= 0) return 0;
    const Vec3f right = box.centre.cross(Vec3f(0, 0, 1)).normalized(), up = right.cross(box.centre);
    const float x = std::abs(d.dot(right)) / (depth * box.half.x), y = std::abs(d.dot(up)) / (depth * box.half.y);
    return (1 - smooth_step(0.8f, 1.0f, x)) * (1 - smooth_step(0.8f, 1.0f, y));
}

/// Elevation (sine) of the hills' edge.
float hill_edge(const Vec3f& d) {
    const float a = std::atan2(d.y, d.x);
    return 0.045f + 0.018f * std::sin(3 * a + 1.0f) + 0.010f * std::sin(7 * a + 0.4f) + 0.004f * std::sin(19 * a);
}

Color3f sun(const Vec3f& d) {
    const float angle = std::acos(std::clamp(d.dot(ProceduralSky::sun_direction()), -1.0f, 1.0f));
    return kSun * (1 - smooth_step(0.9f * kSunRadius, 1.1f * kSunRadius, angle));
}

}  // namespace

Vec3f ProceduralSky::sun_direction() { return direction(-118, 34); }

ProceduralSky::ProceduralSky() {
    m_boxes = {{direction(142, 34), {0.30f, 0.22f}, {5.0f, 4.8f, 4.5f}},
               {direction(-78, 26), {0.07f, 0.38f}, {5.0f, 5.3f, 5.8f}},
               {direction(25, 62), {0.45f, 0.10f}, {4.5f, 4.5f, 4.5f}}};
    constexpr int kWidth = 512, kHeight = kWidth / 2;
    for (int y = 0; y < kHeight / 2; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const Vec3f d = latlong_direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, kWidth, kHeight);
            const float solid_angle = 2 * kPi * kPi / (kWidth * kHeight) * std::sqrt(1 - d.z * d.z);
            m_ground_irradiance += without_sun(d) * (d.z * solid_angle);
        }
    m_ground_irradiance += kSun * (kPi * kSunRadius * kSunRadius * sun_direction().z);
}

/// What stands above the horizon but for the disc of the sun.
Color3f ProceduralSky::without_sun(const Vec3f& d) const {
    Color3f sky = mix(kZenith, kHorizon, std::exp(-8.0f * std::max(d.z, 0.0f)));
    const float near_sun = std::max(d.dot(sun_direction()), 0.0f);
    sky += kGlow * (0.25f * std::pow(near_sun, 5.0f) + 1.2f * std::pow(near_sun, 60.0f));
    sky = mix(mix(kHills, kHorizon, 0.30f), sky, smooth_step(-0.002f, 0.002f, d.z - hill_edge(d)));
    for (const SoftBox& box : m_boxes) sky = mix(sky, box.radiance, coverage(box, d));
    return sky;
}

Color3f ProceduralSky::radiance(const Vec3f& d) const {
    if (d.z >= 0) return without_sun(d) + sun(d);
    const float shade = 1 - 0.7f * smooth_step(0.15f, 1.0f, -d.z);
    const Color3f ground = ground_albedo() * m_ground_irradiance * (shade / kPi);
    return mix(ground, mix(kHills, kHorizon, 0.5f), 0.6f * std::exp(200 * d.z));
}

Image ProceduralSky::picture(int width, int samples) const {
    Image image(width, width / 2, 3);
    for_each_index(image.height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Color3f sum(0.0f);
            for (int i = 0; i < samples * samples; ++i) {
                const float u = (static_cast<float>(i % samples) + 0.5f) / static_cast<float>(samples);
                const float v = (static_cast<float>(i / samples) + 0.5f) / static_cast<float>(samples);
                sum += radiance(latlong_direction(static_cast<float>(x) + u, static_cast<float>(y) + v, width, image.height));
            }
            sum /= static_cast<float>(samples * samples);
            std::copy_n(&sum.x, 3, image.at(x, y));
        }
    });
    return image;
}

Vec3f latlong_direction(float x, float y, int width, int height) {
    const float phi = kPi - 2 * kPi * x / static_cast<float>(width), theta = kPi * y / static_cast<float>(height);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace burnish
