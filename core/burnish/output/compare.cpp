#include <burnish/base/display.h>
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/base/types.h>
#include <burnish/output/compare.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace burnish {
namespace {

constexpr double kRelMseFloor = 0.01;  // of the reference's mean

/// The two images, what covers them, and how many channels count.
struct Pair {
    const Image &test, &reference;
    const Image* mask;
    int channels;

    Pair(const Image& a, const Image& b, const Image* m) : test(a), reference(b), mask(m), channels(std::min(3, a.channels)) {
        const auto size = [](const Image& i) {
            return std::to_string(i.width) + "x" + std::to_string(i.height) + "x" + std::to_string(i.channels);
        };
        if (size(a) != size(b))
            throw Error(ErrorCode::size_mismatch, "cannot compare an image of " + size(a) + " with a reference of " + size(b));
        if (m && (m->width != a.width || m->height != a.height))
            throw Error(ErrorCode::size_mismatch, "cannot mask an image of " + size(a) + " with a mask of " + size(*m));
    }
    bool covered(int x, int y) const { return !mask || *mask->at(x, y) > 0; }
    bool finite(int x, int y) const {
        const auto is_finite = [](float value) { return std::isfinite(value); };
        return std::all_of(test.at(x, y), test.at(x, y) + channels, is_finite) &&
               std::all_of(reference.at(x, y), reference.at(x, y) + channels, is_finite);
    }
};

/// Sums of one row; rows are added in order, so the figures do not depend on the threads.
struct Sums {
    size_t pixels = 0, non_finite = 0;
    double reference = 0, square = 0, relative = 0, display = 0, largest = -1;
    int x = 0, y = 0;

    void operator+=(const Sums& row) {
        pixels += row.pixels, non_finite += row.non_finite;
        reference += row.reference, square += row.square, relative += row.relative, display += row.display;
        if (row.largest > largest) largest = row.largest, x = row.x, y = row.y;
    }
};

/// Adds up `pixel(x, y, sums)` over the covered finite pixels.
template <typename Pixel>
Sums sum_pixels(const Pair& pair, Pixel pixel) {
    std::vector<Sums> rows(static_cast<size_t>(pair.test.height));
    for_each_index(pair.test.height, [&](int y) {
        Sums& row = rows[static_cast<size_t>(y)];
        for (int x = 0; x < pair.test.width; ++x) {
            if (!pair.covered(x, y)) continue;
            if (!pair.finite(x, y)) {
                ++row.non_finite;
                continue;
            }
            ++row.pixels;
            pixel(x, y, row);
        }
    });
    Sums total;
    for (const Sums& row : rows) total += row;
    return total;
}

Sums reference_sums(const Pair& pair) {
    return sum_pixels(pair, [&](int x, int y, Sums& sums) {
        for (int c = 0; c < pair.channels; ++c) sums.reference += pair.reference.at(x, y)[c];
    });
}

double reference_mean(const Pair& pair, const Sums& sums) {
    return sums.pixels == 0 ? 0 : sums.reference / (static_cast<double>(sums.pixels) * pair.channels);
}

Sums error_sums(const Pair& pair, double mean) {
    const double floor = kRelMseFloor * mean, exposure = mean > 0 ? kMiddleGrey / mean : 1;
    const auto display = [exposure](double value) { return display_encoded(value * exposure); };
    return sum_pixels(pair, [&](int x, int y, Sums& sums) {
        for (int c = 0; c < pair.channels; ++c) {
            const double a = pair.test.at(x, y)[c], b = pair.reference.at(x, y)[c], error = a - b;
            const double weight = b * b + floor * floor, shown = display(a) - display(b);
            sums.square += error * error;
            if (error != 0) sums.relative += error * error / weight;
            sums.display += shown * shown;
            if (std::fabs(error) > sums.largest) sums.largest = std::fabs(error), sums.x = x, sums.y = y;
        }
    });
}

}  // namespace

Comparison compare_images(const Image& test, const Image& reference, const Image* mask) {
    const Pair pair(test, reference, mask);
    const Sums first = reference_sums(pair);
    Comparison result;
    result.pixels = first.pixels;
    result.non_finite = first.non_finite;
    result.reference_mean = reference_mean(pair, first);
    if (first.pixels == 0) return result;

    const Sums sums = error_sums(pair, result.reference_mean);
    const double values = static_cast<double>(sums.pixels) * pair.channels;
    result.display_psnr_db = -10 * std::log10(sums.display / values);
    result.relative_rms = sums.square > 0 ? std::sqrt(sums.square / values) / result.reference_mean : 0;
    result.rel_mse = sums.relative / values;
    result.largest_error = sums.largest;
    result.largest_x = sums.x;
    result.largest_y = sums.y;
    return result;
}

Image difference_image(const Image& test, const Image& reference, const Image* mask, float gain) {
    const Pair pair(test, reference, mask);
    const double mean = reference_mean(pair, reference_sums(pair));
    const auto brightness = [&](const float* p) { return pair.channels == 3 ? luminance({p[0], p[1], p[2]}) : p[0]; };
    Image difference(test.width, test.height, 3);
    for_each_index(test.height, [&](int y) {
        for (int x = 0; x < test.width; ++x) {
            Color3f colour(0, 0, 0);
            if (pair.covered(x, y) && !pair.finite(x, y)) colour = {1, 0, 1};
            if (pair.covered(x, y) && pair.finite(x, y)) {
                const double error = brightness(test.at(x, y)) - brightness(reference.at(x, y));
                const auto t = static_cast<float>(std::clamp(gain * error / (mean > 0 ? mean : 1), -1.0, 1.0)) / 2;
                colour = {0.5f + t, 0.5f - std::fabs(t), 0.5f - t};
            }
            std::copy_n(colour.getValue(), 3, difference.at(x, y));
        }
    });
    return difference;
}

}  // namespace burnish
