// Skies with suns, for the tests that find and shade them.
#pragma once

#include <burnish/base/image.h>
#include <burnish/light/filter/cube_faces.h>
#include <burnish/light/latlong.h>

#include <array>
#include <vector>

namespace burnish_test {

using namespace burnish;

/// A disc of constant radiance; radius in degrees.
struct PaintedSun {
    Vec3f direction;
    float radius_deg = 0.27f;
    Color3f radiance{60000, 50000, 40000};

    double solid_angle() const { return 2 * M_PI * (1 - std::cos(radius_deg * M_PI / 180)); }
};

/// A blue sky over dark ground, without suns.
inline Color3f sky(const Vec3f& d) {
    return d.y > 0 ? Color3f(0.5f, 0.7f, 1.0f) * (1.0f - 0.6f * d.y) : Color3f(0.15f, 0.12f, 0.1f);
}

/// Sky and suns averaged over a texel, 64 places, each at a height of its own; direction(x, y) of places in [0, 1]^2 of the texel.
template <class Direction>
Color3f texel_with_suns(const std::vector<PaintedSun>& suns, Direction&& direction) {
    const Vec3f middle = direction(0.5f, 0.5f);
    Color3f value = sky(middle);
    for (const PaintedSun& sun : suns) {
        const Vec3f to_sun = sun.direction.normalized();
        if (middle.dot(to_sun) < std::cos(0.1f)) continue;
        int inside = 0;
        for (int i = 0; i < 64; ++i) {
            const Vec3f d = direction((i % 8 + 0.5f) / 8, (i / 8 + (i % 8 + 0.5f) / 8) / 8);
            inside += std::asin(0.5f * (d - to_sun).length()) * 2 < sun.radius_deg * kPi / 180;
        }
        value += sun.radiance * (inside / 64.0f);
    }
    return value;
}

inline Image sunny_latlong(const std::vector<PaintedSun>& suns, int height) {
    Image image(2 * height, height, 3);
    for (int y = 0; y < height; ++y) {
        const double top = std::cos(M_PI * y / height), bottom = std::cos(M_PI * (y + 1) / height);
        for (int x = 0; x < image.width; ++x) {
            const Color3f c = texel_with_suns(suns, [&](float u, float v) {
                const double theta = std::acos(top + (bottom - top) * v);  // even in solid angle
                return latlong_direction({(x + u) / static_cast<float>(image.width), static_cast<float>(theta / M_PI)});
            });
            std::copy_n(&c.x, 3, image.at(x, y));
        }
    }
    return image;
}

inline std::array<Image, 6> sunny_cube(const std::vector<PaintedSun>& suns, int size) {
    std::array<Image, 6> faces;
    for (int face = 0; face < 6; ++face) {
        faces[face] = Image(size, size, 3);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const float n = static_cast<float>(size);
                const Color3f c =
                    texel_with_suns(suns, [&](float u, float v) { return cube_direction(face, (x + u) / n, (y + v) / n); });
                std::copy_n(&c.x, 3, faces[face].at(x, y));
            }
    }
    return faces;
}

}  // namespace burnish_test
