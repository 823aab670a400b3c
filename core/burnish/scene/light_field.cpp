#include <burnish/base/parallel.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/light_field.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kBlock = 4;
static_assert(kBlock * kBlock == IrradianceGatherer::kRuns);

/// Which run a pixel uses: neighbours in a block get runs far apart (Bayer's order).
int run_of(int x, int y) {
    static constexpr int kBayer[kBlock][kBlock] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    return kBayer[y % kBlock][x % kBlock];
}

Vec3f vector_at(const Image& image, size_t pixel) {
    const float* v = image.at(pixel);
    return {v[0], v[1], v[2]};
}

}  // namespace

LightField::LightField(const AovFrame& frame, const Tracer& tracer, const IrradianceGatherer& gatherer,
                       const Progress& progress)
    : m_frame(frame),
      m_position(frame.layer(Role::position)),
      m_normal(frame.layer(Role::normal)),
      m_gatherer(gatherer),
      m_object(m_position.pixel_count(), -1),
      m_light(m_position.pixel_count()) {
    const int width = m_position.width, height = m_position.height;
    for_each_tile(width, height, progress, "lighting", [&](const Window& tile) {
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                const auto hit = closest_at(tracer, *frame.camera, pixel_centre(x, y), width, height);
                if (!hit) continue;
                const size_t pixel = static_cast<size_t>(y) * width + x;
                m_object[pixel] = hit->object;
                m_light[pixel] = gatherer.gather(*hit, run_of(x, y), 1);
            }
    });
}

Irradiance LightField::around(const Hit& hit, float x, float y) const {
    const int left = static_cast<int>(std::floor(x - 0.5f)) - kBlock / 2 + 1;
    const int top = static_cast<int>(std::floor(y - 0.5f)) - kBlock / 2 + 1;
    Irradiance sum;
    int count = 0;
    for (int j = std::max(top, 0); j < std::min(top + kBlock, m_position.height); ++j)
        for (int i = std::max(left, 0); i < std::min(left + kBlock, m_position.width); ++i) {
            const size_t pixel = static_cast<size_t>(j) * m_position.width + i;
            if (!same_surface(hit, pixel)) continue;
            sum += m_light[pixel];
            ++count;
        }
    if (count == 0) return m_gatherer.gather(hit, 0, IrradianceGatherer::kRuns);
    return sum * (1.0f / static_cast<float>(count));
}

/// The same object, normals within 26 degrees, and no further off the hit's tangent plane than four pixels are wide.
bool LightField::same_surface(const Hit& hit, size_t pixel) const {
    if (m_object[pixel] != hit.object || vector_at(m_normal, pixel).dot(hit.n) < 0.9f) return false;
    const float pixel_width = 2 * m_frame.camera->right.length() / static_cast<float>(m_position.width) * hit.distance;
    return std::abs((vector_at(m_position, pixel) - hit.p).dot(hit.n)) < 4 * pixel_width;
}

}  // namespace burnish
