#include <burnish/plan/truth.h>

#include <burnish/base/display.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace burnish {
namespace {

double decibels(double mean_square) {
    return mean_square > 0 ? -10 * std::log10(mean_square) : std::numeric_limits<double>::infinity();
}

/// Squared display error of one pixel, mean of its channels, and the largest of one channel; the truth's noise taken off both.
struct PixelError {
    double square = 0, largest = 0;
};

PixelError pixel_error(const Color3f& estimate, const Color3f& truth, double relative_error, double exposure) {
    PixelError error;
    for (int c = 0; c < 3; ++c) {
        const double linear = truth[c] * exposure;
        const double noise = linear * relative_error * display_slope(linear);
        const double off = std::abs(display_encoded(estimate[c] * exposure) - display_encoded(linear));
        error.square += (off * off - noise * noise) / 3;
        error.largest = std::max(error.largest, off - 2 * noise);
    }
    return error;
}

}  // namespace

Truth::Truth(const Surfaces& surfaces, CheckSample sample, const MaterialShader& reference)
    : m_sample(std::move(sample)), m_batches(small_batches(surfaces, m_sample.pixels, reference)) {
    ShadedBatch exact = shade_all(m_batches, reference);
    m_radiance = std::move(exact.overlay);
    m_lookups = std::reduce(exact.samples.begin(), exact.samples.end(), 0.0);
    for (size_t i = 0; i < m_radiance.size(); ++i) {
        const float light = luminance(m_radiance[i]);
        m_relative_error.push_back(light > 0 ? exact.standard_error[i] / light : 0);
    }
    if (m_sample.exposure <= 0) m_sample.exposure = exposure_of(m_radiance, m_sample.weights);
}

Closeness Truth::closeness(std::span<const Color3f> estimate) const {
    constexpr double kNineOfTen = 1.2816;  // quantile of the normal distribution
    Closeness result;
    result.pixels = m_radiance.size();
    const double count = std::max<double>(1, static_cast<double>(result.pixels));
    double sum = 0, squares = 0;
    for (size_t i = 0; i < m_radiance.size(); ++i) {
        const PixelError error = pixel_error(estimate[i], m_radiance[i], m_relative_error[i], m_sample.exposure);
        const double weighed = error.square * m_sample.weights[i] * count;
        sum += weighed, squares += weighed * weighed;
        result.largest = std::max(result.largest, error.largest);
    }
    const double mean = sum / count, variance = std::max(0.0, squares / count - mean * mean) / std::max(1.0, count - 1);
    result.psnr_db = decibels(mean);
    result.low_db = decibels(std::max(mean, 0.0) + kNineOfTen * std::sqrt(variance));
    return result;
}

Closeness Truth::closeness(const Image& overlay) const {
    std::vector<Color3f> all;
    for (const uint32_t pixel : m_sample.pixels) {
        const float* color = overlay.at(static_cast<size_t>(pixel));
        all.emplace_back(color[0], color[1], color[2]);
    }
    return closeness(all);
}

double Truth::distance_db(std::span<const Color3f> a, std::span<const Color3f> b) const {
    double sum = 0;
    for (size_t i = 0; i < m_radiance.size(); ++i)
        sum += pixel_error(a[i], b[i], 0, m_sample.exposure).square * m_sample.weights[i];
    return decibels(sum);
}

}  // namespace burnish
