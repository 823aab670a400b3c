#include <burnish/light/envmap.h>

#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/light/environment_layouts.h>
#include <burnish/light/filter/cube_resample.h>
#include <burnish/light/latlong.h>

#include <algorithm>
#include <string>

namespace burnish {
namespace {

constexpr int kLargestWidth = 32768;
constexpr double kBrightPart = 1e-3;  // of the sphere

void store(const Color3f& c, float* rgb) { std::copy_n(&c.x, 3, rgb); }

void check_range(const char* what, int value, int smallest, int largest) {
    if (value >= smallest && value <= largest) return;
    throw Error(ErrorCode::bad_argument, std::string(what) + " is " + std::to_string(value) + ", expected " +
                                             std::to_string(smallest) + " to " + std::to_string(largest) + ".");
}

std::array<Image, 6> level_faces(const CubePyramid& pyramid, int level) {
    const int n = pyramid.face_size() >> level;
    std::array<Image, 6> faces;
    faces.fill(Image(n, n, 3));
    for_each_index(6 * n, [&](int line) {
        const int face = line / n, y = line % n;
        for (int x = 0; x < n; ++x) store(pyramid.texel(level, face, x, y), faces[face].at(x, y));
    });
    return faces;
}

struct Texel {
    float luminance;
    double solid_angle;
};

/// Light from the brightest kBrightPart of the sphere over all light.
double bright_share(std::vector<Texel> texels) {
    std::sort(texels.begin(), texels.end(), [](const Texel& a, const Texel& b) { return a.luminance > b.luminance; });
    double left = 4.0 * std::numbers::pi * kBrightPart, bright = 0, all = 0;
    for (const Texel& texel : texels) {
        bright += texel.luminance * std::min(left, texel.solid_angle);
        left = std::max(0.0, left - texel.solid_angle);
        all += texel.luminance * texel.solid_angle;
    }
    return all > 0.0 ? bright / all : 0.0;
}

}  // namespace

Image to_latlong(const Environment& light, int width) {
    check_range("the width of the lat-long", width, 2, kLargestWidth);
    Image image(width, width / 2, 3);
    for_each_index(image.height, [&](int y) {
        const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height);
        const float omega = 2.0f * kPi * kPi * std::sin(kPi * v) / static_cast<float>(image.pixel_count());
        for (int x = 0; x < width; ++x) {
            const Vec3f d = latlong_direction({(static_cast<float>(x) + 0.5f) / static_cast<float>(width), v});
            store(light.pyramid().lookup(d, light.pyramid().level(d, omega)), image.at(x, y));
        }
    });
    return image;
}

Image to_cube_strip(const Environment& light, int face_size) {
    check_range("the size of the cube's faces", face_size, 1, kLargestWidth / 4);
    const CubePyramid& pyramid = light.pyramid();
    int level = 0;
    while (level + 1 < pyramid.level_count() && pyramid.face_size() >> (level + 1) >= face_size) ++level;
    const std::array<Image, 6> faces = resized_cube(level_faces(pyramid, level), face_size);
    Image strip(face_size, 6 * face_size, 3);
    for (int face = 0; face < 6; ++face)
        std::copy(faces[face].data.begin(), faces[face].data.end(), strip.at(0, face * face_size));
    return strip;
}

Image level_image(const CubePyramid& pyramid, int level) {
    check_range("the level of the pyramid", level, 0, pyramid.level_count() - 1);
    return horizontal_cross(level_faces(pyramid, level));
}

EnvironmentSummary summarize(const Environment& light) {
    const CubePyramid& pyramid = light.pyramid();
    const int n = pyramid.face_size();
    const auto edge = [&](int i) { return 2.0 * i / n - 1.0; };
    EnvironmentSummary summary{};
    std::vector<Texel> texels;
    texels.reserve(static_cast<size_t>(6 * n) * n);
    double sum[3] = {0, 0, 0};
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const Color3f c = pyramid.texel(0, face, x, y);
                texels.push_back({luminance(c), cube_solid_angle(edge(x), edge(x + 1), edge(y), edge(y + 1))});
                for (int k = 0; k < 3; ++k) sum[k] += c[k] * texels.back().solid_angle;
                if (texels.back().luminance <= summary.peak_luminance) continue;
                summary.peak_luminance = texels.back().luminance;
                summary.peak_direction =
                    cube_direction(face, (x + 0.5f) / static_cast<float>(n), (y + 0.5f) / static_cast<float>(n));
            }
        }
    }
    for (int k = 0; k < 3; ++k) summary.mean[k] = static_cast<float>(sum[k] / (4.0 * std::numbers::pi));
    summary.mean_luminance = luminance(summary.mean);
    summary.bright_share = static_cast<float>(bright_share(std::move(texels)));
    summary.face_size = n;
    summary.suggested_face_size = light.suggested_face_size();
    return summary;
}

}  // namespace burnish
