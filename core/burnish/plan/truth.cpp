#include <burnish/plan/truth.h>

#include <burnish/base/display.h>
#include <burnish/base/parallel.h>
#include <burnish/sampling/sequence.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr size_t kPixelsABatch = 8;

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

Truth::Truth(const Surfaces& surfaces, std::span<const uint32_t> pixels, const MaterialShader& reference)
    : m_pixels(pixels.begin(), pixels.end()) {
    for (size_t begin = 0; begin < pixels.size(); begin += kPixelsABatch) {
        const auto own = pixels.subspan(begin, std::min(kPixelsABatch, pixels.size() - begin));
        SurfaceBatch& batch = m_batches.emplace_back();
        batch.pixel.assign(own.begin(), own.end());
        surfaces.fill(batch, reference.needs());
    }
    std::vector<ShadedBatch> parts = shaded(reference);
    for (ShadedBatch& part : parts) {
        for (size_t i = 0; i < part.overlay.size(); ++i) {
            const float light = luminance(part.overlay[i]);
            m_radiance.push_back(part.overlay[i]);
            m_relative_error.push_back(light > 0 ? part.standard_error[i] / light : 0);
            m_lookups += part.samples[i];
        }
    }
    double sum = 0;
    for (const Color3f& color : m_radiance) sum += (color.x + color.y + color.z) / 3;
    if (sum > 0) m_exposure = kMiddleGrey * static_cast<double>(m_radiance.size()) / sum;
}

std::vector<ShadedBatch> Truth::shaded(const MaterialShader& shader) const {
    std::vector<ShadedBatch> parts(m_batches.size());
    for_each_index(static_cast<int>(parts.size()),
                   [&](int i) { shader.shade(m_batches[static_cast<size_t>(i)], parts[static_cast<size_t>(i)]); });
    return parts;
}

Closeness Truth::closeness(std::span<const Color3f> estimate) const {
    constexpr double kNineOfTen = 1.2816;  // quantile of the normal distribution
    Closeness result;
    result.pixels = m_radiance.size();
    double sum = 0, squares = 0;
    for (size_t i = 0; i < m_radiance.size(); ++i) {
        const PixelError error = pixel_error(estimate[i], m_radiance[i], m_relative_error[i], m_exposure);
        sum += error.square, squares += error.square * error.square;
        result.largest = std::max(result.largest, error.largest);
    }
    const double count = std::max<double>(1, static_cast<double>(result.pixels)), mean = sum / count;
    const double variance = std::max(0.0, squares / count - mean * mean) / std::max(1.0, count - 1);
    result.psnr_db = decibels(mean);
    result.low_db = decibels(std::max(mean, 0.0) + kNineOfTen * std::sqrt(variance));
    return result;
}

Closeness Truth::closeness(const MaterialShader& estimator) const {
    std::vector<Color3f> all;
    for (const ShadedBatch& part : shaded(estimator)) all.insert(all.end(), part.overlay.begin(), part.overlay.end());
    return closeness(all);
}

Closeness Truth::closeness(const Image& overlay) const {
    std::vector<Color3f> all;
    for (const uint32_t pixel : m_pixels) {
        const float* color = overlay.at(static_cast<size_t>(pixel));
        all.emplace_back(color[0], color[1], color[2]);
    }
    return closeness(all);
}

std::vector<uint32_t> check_pixels(const Surfaces& surfaces, const Assignment& assignment, int rule, size_t count) {
    std::vector<uint32_t> all, chosen;
    surfaces.list({0, 0, assignment.width, assignment.height}, rule, all);
    const size_t strata = std::min(count, all.size());
    for (size_t i = 0; i < strata; ++i) {
        const size_t begin = i * all.size() / strata, end = (i + 1) * all.size() / strata;
        chosen.push_back(all[begin + hash_bits(static_cast<uint32_t>(i)) % (end - begin)]);
    }
    return chosen;
}

}  // namespace burnish
