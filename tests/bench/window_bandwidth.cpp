#include "bench/window_bandwidth.h"

#include <burnish/base/parallel.h>
#include <burnish/base/types.h>
#include <burnish/frequency/bandwidth_buffer.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>

namespace burnish {
namespace {

constexpr int kSize = PictureWindow::kSize;
constexpr double kShare = 0.95;
using Matrix = Eigen::Matrix<std::complex<double>, kSize, kSize>;

/// Hann's window along one axis, of sum 1.
std::array<double, kSize> hann() {
    std::array<double, kSize> weights;
    for (int i = 0; i < kSize; ++i) weights[i] = (1 - std::cos(2 * std::numbers::pi * (i + 0.5) / kSize)) / kSize;
    return weights;
}

Matrix transform() {
    Matrix m;
    for (int k = 0; k < kSize; ++k)
        for (int i = 0; i < kSize; ++i) m(k, i) = std::polar(1.0, -2 * std::numbers::pi * k * i / kSize);
    return m;
}

bool is_covered(const Image& mask, int x, int y) {
    for (int v = y; v < y + kSize; ++v)
        for (int u = x; u < x + kSize; ++u)
            if (!(*mask.at(u, v) > 0)) return false;
    return true;
}

float bandwidth_of(const Image& picture, const PictureWindow& window) {
    static const std::array<double, kSize> weights = hann();
    static const Matrix dft = transform();
    const double mean = window_mean(picture, window);
    Matrix m;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) m(y, x) = weights[x] * weights[y] * (*picture.at(window.x + x, window.y + y) - mean);
    const Matrix spectrum = dft * m * dft.transpose();
    std::vector<std::pair<double, double>> bins;  // frequency, energy
    double total = 0;
    for (int v = 0; v < kSize; ++v)
        for (int u = 0; u < kSize; ++u) {
            const int fx = std::min(u, kSize - u), fy = std::min(v, kSize - v);
            bins.emplace_back(std::hypot(fx, fy) / kSize, std::norm(spectrum(v, u)));
            total += bins.back().second;
        }
    std::ranges::sort(bins);
    double sum = 0;
    for (const auto& [frequency, energy] : bins)
        if ((sum += energy) >= kShare * total) return static_cast<float>(frequency);
    return 0;
}

}  // namespace

std::vector<PictureWindow> window_bandwidths(const Image& picture, const Image& mask, int stride) {
    std::vector<PictureWindow> windows;
    for (int y = 0; y + kSize <= picture.height; y += stride)
        for (int x = 0; x + kSize <= picture.width; x += stride)
            if (is_covered(mask, x, y)) windows.push_back({x, y, 0});
    for_each_index(static_cast<int>(windows.size()), [&](int i) { windows[i].bandwidth = bandwidth_of(picture, windows[i]); });
    return windows;
}

float windowed_level(float cycles_per_pixel) {
    constexpr int kLargePicture = 4096;
    return std::min(shading_level(cycles_per_pixel, kLargePicture, kLargePicture), 3.0f);
}

float window_mean(const Image& picture, const PictureWindow& window) {
    static const std::array<double, kSize> weights = hann();
    double sum = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) sum += weights[x] * weights[y] * *picture.at(window.x + x, window.y + y);
    return static_cast<float>(sum);
}

}  // namespace burnish
