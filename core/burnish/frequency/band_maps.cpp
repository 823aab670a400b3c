#include <burnish/frequency/band_maps.h>

#include <burnish/frequency/daubechies.h>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

using Taps = std::array<float, 4>;

/// Divided by sqrt 2: a constant keeps its value when it is low, white noise is shared out among the bands.
constexpr Taps halved(const float (&taps)[4]) {
    constexpr float half = 0.70710678f;
    return {half * taps[0], half * taps[1], half * taps[2], half * taps[3]};
}
constexpr Taps kLow = halved(kDaubechiesLow), kHigh = halved(kDaubechiesHigh);
constexpr int kLowCentre = 1, kHighCentre = 2;  // where most of the taps' energy is

/// Row `out` of four rows, each times its tap.
void combine(const std::array<const float*, 4>& rows, const Taps& taps, int width, float* out) {
    const auto [a, b, c, d] = rows;
    for (int x = 0; x < width; ++x) out[x] = taps[0] * a[x] + taps[1] * b[x] + taps[2] * c[x] + taps[3] * d[x];
}

/// Adds the squares of four rows' combination, `shift` samples to the right.
void add_squares(const std::array<const float*, 4>& rows, const Taps& taps, int width, int shift, float* out) {
    const auto [a, b, c, d] = rows;
    const auto square = [&](int x) {
        const float high = taps[0] * a[x] + taps[1] * b[x] + taps[2] * c[x] + taps[3] * d[x];
        return high * high;
    };
    for (int x = 0; x < width - shift; ++x) out[x + shift] += square(x);
    for (int x = width - shift; x < width; ++x) out[x + shift - width] += square(x);
}

/// One step at all samples: the image low and high along its rows.
struct RowSplit {
    Image low, high;

    explicit RowSplit(const Image& image) : low(image.width, image.height, 1), high(low) {
        const int width = image.width;
        std::vector<float> row(static_cast<size_t>(width) + 3);
        for (int y = 0; y < image.height; ++y) {
            std::copy_n(image.at(0, y), width, row.data());
            for (int k = 0; k < 3; ++k) row[width + k] = row[k % width];
            const float* s = row.data();
            combine({s, s + 1, s + 2, s + 3}, kLow, width, low.at(0, y));
            combine({s, s + 1, s + 2, s + 3}, kHigh, width, high.at(0, y));
        }
    }

    static std::array<const float*, 4> rows(const Image& image, int y) {
        const int height = image.height;
        return {image.at(0, y % height), image.at(0, (y + 1) % height), image.at(0, (y + 2) % height),
                image.at(0, (y + 3) % height)};
    }

    /// What is high in rows, columns or both, squared, where its wavelet is.
    Image squares() const {
        Image out(low.width, low.height, 1);
        for (int y = 0; y < low.height; ++y) {
            const int upper = (y + kLowCentre) % low.height, lower = (y + kHighCentre) % low.height;
            add_squares(rows(high, y), kLow, low.width, kHighCentre, out.at(0, upper));
            add_squares(rows(low, y), kHigh, low.width, kLowCentre, out.at(0, lower));
            add_squares(rows(high, y), kHigh, low.width, kHighCentre, out.at(0, lower));
        }
        return out;
    }

    /// What is low in both, at every other sample.
    Image next() const {
        Image out(low.width / 2, low.height / 2, 1);
        std::vector<float> row(low.width);
        for (int y = 0; y < out.height; ++y) {
            combine(rows(low, 2 * y), kLow, low.width, row.data());
            for (int x = 0; x < out.width; ++x) *out.at(x, y) = row[2 * x];
        }
        return out;
    }
};

/// Four samples to a cell's value.
struct Mean {
    float operator()(float a, float b, float c, float d) const { return 0.125f * (a + d) + 0.375f * (b + c); }
};
struct Largest {
    float operator()(float a, float b, float c, float d) const { return std::max(std::max(a, b), std::max(c, d)); }
};

/// To cells of two samples, from these and one on either side.
template <class Gather>
Image gathered(const Image& fine, Gather gather) {
    const int width = fine.width, height = fine.height;
    Image cells(width / 2, height / 2, 1);
    std::vector<float> row(static_cast<size_t>(width) + 2);
    for (int y = 0; y < cells.height; ++y) {
        const float *a = fine.at(0, (2 * y + height - 1) % height), *b = fine.at(0, 2 * y), *c = fine.at(0, 2 * y + 1),
                    *d = fine.at(0, (2 * y + 2) % height);
        for (int x = 0; x < width; ++x) row[x + 1] = gather(a[x], b[x], c[x], d[x]);
        row[0] = row[width], row[width + 1] = row[1];
        for (int x = 0; x < cells.width; ++x)
            *cells.at(x, y) = gather(row[2 * x], row[2 * x + 1], row[2 * x + 2], row[2 * x + 3]);
    }
    return cells;
}

/// Mean square of the differences to the eight cells around, halved: the variance where cells are independent.
Image variation(const Image& level) {
    Image out(level.width, level.height, 1);
    const auto around = [](int i, int size) { return (i + size) % size; };
    for (int y = 0; y < level.height; ++y) {
        for (int x = 0; x < level.width; ++x) {
            float sum = 0.0f;
            for (int k = 0; k < 9; ++k) {
                const float d =
                    *level.at(around(x + k % 3 - 1, level.width), around(y + k / 3 - 1, level.height)) - *level.at(x, y);
                sum += d * d;
            }
            *out.at(x, y) = sum / 16.0f;
        }
    }
    return out;
}

}  // namespace

BandMaps band_maps(const Image& image, int bands, BandGather gather) {
    BandMaps maps;
    maps.level = image;
    for (int band = 0; band < bands; ++band) {
        const RowSplit step(maps.level);
        maps.bands.push_back(gather == BandGather::mean ? gathered(step.squares(), Mean())
                                                        : gathered(step.squares(), Largest()));
        maps.level = step.next();
    }
    maps.below = variation(maps.level);
    return maps;
}

}  // namespace burnish
