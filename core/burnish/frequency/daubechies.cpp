#include <burnish/frequency/daubechies.h>

#include <burnish/base/error.h>

#include <string>

namespace burnish {
namespace {

constexpr auto& kLow = kDaubechiesLow;
constexpr auto& kHigh = kDaubechiesHigh;

void check(const Image& image, int bands) {
    const int step = 1 << bands;
    if (bands >= 0 && image.channels == 1 && !image.empty() && image.width % step == 0 && image.height % step == 0) return;
    throw Error(ErrorCode::size_mismatch, "wavelets: expected one channel, its sides multiples of " + std::to_string(step) +
                                              ", found " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                              " x " + std::to_string(image.channels) + ". Pad the image first.");
}

/// One row to its lows and highs.
void split(const float* in, int width, float* out) {
    const int half = width / 2;
    const auto write = [&](int j, const float* s) {
        out[j] = kLow[0] * s[0] + kLow[1] * s[1] + kLow[2] * s[2] + kLow[3] * s[3];
        out[half + j] = kHigh[0] * s[0] + kHigh[1] * s[1] + kHigh[2] * s[2] + kHigh[3] * s[3];
    };
    for (int j = 0; j + 1 < half; ++j) write(j, in + 2 * j);
    const float wrapped[4] = {in[width - 2], in[width - 1], in[0], in[1]};
    write(half - 1, wrapped);
}

/// The inverse of `split`, which is its transpose.
void join(const float* in, int width, float* out) {
    const int half = width / 2;
    for (int j = 0; j < half; ++j) {
        const int before = j == 0 ? half - 1 : j - 1;
        for (int k = 0; k < 2; ++k)
            out[2 * j + k] =
                kLow[k] * in[j] + kHigh[k] * in[half + j] + kLow[k + 2] * in[before] + kHigh[k + 2] * in[half + before];
    }
}

/// out = sum of four rows, each times its tap.
void combine(const float* const rows[4], const float taps[4], int width, float* out) {
    const float *a = rows[0], *b = rows[1], *c = rows[2], *d = rows[3];
    for (int x = 0; x < width; ++x) out[x] = taps[0] * a[x] + taps[1] * b[x] + taps[2] * c[x] + taps[3] * d[x];
}

void split_columns(const Image& in, int width, int height, Image& out) {
    const int half = height / 2;
    for (int j = 0; j < half; ++j) {
        const int next = j + 1 == half ? 0 : 2 * j + 2;
        const float* const rows[4] = {in.at(0, 2 * j), in.at(0, 2 * j + 1), in.at(0, next), in.at(0, next + 1)};
        combine(rows, kLow, width, out.at(0, j));
        combine(rows, kHigh, width, out.at(0, half + j));
    }
}

void join_columns(const Image& in, int width, int height, Image& out) {
    const int half = height / 2;
    for (int j = 0; j < half; ++j) {
        const int before = j == 0 ? half - 1 : j - 1;
        const float* const rows[4] = {in.at(0, j), in.at(0, half + j), in.at(0, before), in.at(0, half + before)};
        for (int k = 0; k < 2; ++k) {
            const float taps[4] = {kLow[k], kHigh[k], kLow[k + 2], kHigh[k + 2]};
            combine(rows, taps, width, out.at(0, 2 * j + k));
        }
    }
}

}  // namespace

Image daubechies(const Image& signal, int bands) {
    check(signal, bands);
    Image image = signal, turn(signal.width, signal.height, 1);
    for (int band = 0; band < bands; ++band) {
        const int width = signal.width >> band, height = signal.height >> band;
        for (int y = 0; y < height; ++y) split(image.at(0, y), width, turn.at(0, y));
        split_columns(turn, width, height, image);
    }
    return image;
}

Image inverse_daubechies(const Image& coefficients, int bands) {
    check(coefficients, bands);
    Image image = coefficients, turn(coefficients.width, coefficients.height, 1);
    for (int band = bands - 1; band >= 0; --band) {
        const int width = image.width >> band, height = image.height >> band;
        join_columns(image, width, height, turn);
        for (int y = 0; y < height; ++y) join(turn.at(0, y), width, image.at(0, y));
    }
    return image;
}

}  // namespace burnish
