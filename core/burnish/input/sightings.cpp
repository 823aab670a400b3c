#include <burnish/input/camera.h>
#include <burnish/input/sightings.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

bool is_interior(const Image& position, const Image* valid, const RowStrips& rows, int x, int y) {
    if (x < 1 || x + 1 >= position.width || !rows.has_neighbours(y)) return false;
    if (valid && !(*valid->at(x, y) > 0)) return false;
    return is_hit(position.at(x, y)) && is_hit(position.at(x - 1, y)) && is_hit(position.at(x + 1, y)) &&
           is_hit(position.at(x, y - 1)) && is_hit(position.at(x, y + 1));
}

/// Interior pixels on a grid of the given pitch.
std::vector<size_t> interior_pixels(const Image& position, const Image* valid, const RowStrips& rows, int pitch) {
    std::vector<size_t> pixels;
    for (int y = pitch / 2; y < position.height; y += pitch)
        for (int x = pitch / 2; x < position.width; x += pitch)
            if (is_interior(position, valid, rows, x, y)) pixels.push_back(static_cast<size_t>(y) * position.width + x);
    return pixels;
}

}  // namespace

bool is_hit(const float* p) {
    const float largest = std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
    return largest > 0 && largest < kFarthest && std::isfinite(p[0] + p[1] + p[2]);
}

std::vector<Sighting> sample_sightings(const Image& position, const Image* valid, const RowStrips& rows, const Window& display,
                                       size_t wanted) {
    // Start coarse and refine while an object is too small for the grid, so that large frames are not read whole.
    int pitch = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(position.pixel_count()) / (4.0 * wanted))));
    std::vector<size_t> pixels = interior_pixels(position, valid, rows, pitch);
    while (pixels.size() < wanted && pitch > 1) {
        pitch = (pitch + 1) / 2;
        pixels = interior_pixels(position, valid, rows, pitch);
    }

    const size_t count = std::min(wanted, pixels.size());
    std::vector<Sighting> sightings;
    sightings.reserve(count);
    for (size_t i = 0; i < count; ++i) {
        const size_t pixel = pixels[i * pixels.size() / count];
        const int x = static_cast<int>(pixel % position.width), y = static_cast<int>(pixel / position.width);
        const float* p = position.at(pixel);
        sightings.push_back(
            {pixel, Imath::V2d(screen_point(rows.data.x + x, rows.data.y + rows.row(y), display)), {p[0], p[1], p[2]}});
    }
    return sightings;
}

}  // namespace burnish
