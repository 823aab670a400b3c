#include "sparse_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace burnish {
namespace {

constexpr int kTile = 16;

/// What brings the mean over the mask to 0.18.
double exposure(const Image& picture, const Image& mask) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < picture.pixel_count(); ++i)
        for (int c = 0; c < 3 && *mask.at(i) > 0; ++c) sum += static_cast<double>(picture.at(i)[c]), ++count;
    return 0.18 * count / sum;
}

struct Tiles {
    const Image &picture, &mask;
    double scale;  // of the picture before the display
};

bool is_covered(const Image& mask, int x, int y) { return x < mask.width && y<mask.height&& * mask.at(x, y)> 0; }

/// Linear colour at (x, y) between the covered grid points about it; false where there is none.
bool interpolated(const Image& picture, const Image& mask, int x, int y, int step, std::array<double, 3>& color) {
    const int x0 = x / step * step, y0 = y / step * step;
    const double fx = static_cast<double>(x - x0) / step, fy = static_cast<double>(y - y0) / step;
    double weights = 0;
    color = {};
    for (int k = 0; k < 4; ++k) {
        const int px = x0 + k % 2 * step, py = y0 + k / 2 * step;
        const double weight = (k % 2 ? fx : 1 - fx) * (k / 2 ? fy : 1 - fy);
        if (weight == 0 || !is_covered(mask, px, py)) continue;
        weights += weight;
        for (size_t c = 0; c < 3; ++c) color[c] += weight * static_cast<double>(picture.at(px, py)[c]);
    }
    for (double& c : color) c /= weights > 0 ? weights : 1;
    return weights > 0;
}

/// Pixels to shade in the tile for a grid of `step`, and whether it stays within the error allowed.
bool is_enough(const Tiles& tiles, int x0, int y0, int step, double mean_square_allowed, size_t& shaded) {
    double square = 0, count = 0;
    shaded = 0;
    for (int y = y0; y < std::min(y0 + kTile, tiles.mask.height); ++y)
        for (int x = x0; x < std::min(x0 + kTile, tiles.mask.width); ++x) {
            if (!is_covered(tiles.mask, x, y)) continue;
            count += 3;
            std::array<double, 3> color;
            if ((x % step == 0 && y % step == 0) || !interpolated(tiles.picture, tiles.mask, x, y, step, color)) {
                ++shaded;
                continue;
            }
            for (size_t c = 0; c < 3; ++c) {
                const double error =
                    encoded(color[c] * tiles.scale) - encoded(static_cast<double>(tiles.picture.at(x, y)[c]) * tiles.scale);
                square += error * error;
            }
        }
    return square <= count * mean_square_allowed;
}

}  // namespace

double encoded(double x) {
    x = std::clamp(x, 0.0, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

size_t oracle_pixels(const Image& picture, const Image& mask, double db) {
    const Tiles tiles{picture, mask, exposure(picture, mask)};
    const double allowed = std::pow(10.0, -db / 10);
    size_t total = 0;
    for (int y = 0; y < picture.height; y += kTile)
        for (int x = 0; x < picture.width; x += kTile) {
            size_t shaded = 0;
            for (int step = kTile; step >= 1; step /= 2)
                if (is_enough(tiles, x, y, step, allowed, shaded)) break;
            total += shaded;
        }
    return total;
}

}  // namespace burnish
