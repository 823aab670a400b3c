#include <burnish/composite/resolve.h>

#include <burnish/base/parallel.h>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

/// line[i] += weight * other[i]
void add_scaled(float* line, const float* other, size_t count, float weight) {
    for (size_t i = 0; i < count; ++i) line[i] += weight * other[i];
}

}  // namespace

Resolver::Resolver(const SampleGrid& grid, const PixelFilter& filter, const Window& samples, const Window& pixels)
    : m_taps(filter_taps(filter, grid.factor)),
      m_samples(samples),
      m_pixels(pixels),
      m_factor(grid.factor),
      m_left(grid.samples_of(pixels).x - samples.x),
      m_top(grid.samples_of(pixels).y - samples.y) {}

/// Filters across, each row of samples for itself and from its first to its last that is not empty, then down.
/// `sample(index, values)` tells the channels of a sample, which are 0 where `is_empty(index)`.
template <int kChannels, class IsEmpty, class Sample>
Image Resolver::filtered(const IsEmpty& is_empty, const Sample& sample) const {
    const int taps = static_cast<int>(m_taps.weights.size()), from = m_left - m_taps.reach;
    Image across(m_pixels.width, m_samples.height, kChannels);
    for_each_index(m_samples.height, [&](int y) {
        const size_t row = static_cast<size_t>(y) * m_samples.width;
        int begin = std::max(from, 0), end = std::min(from + (m_pixels.width - 1) * m_factor + taps, m_samples.width);
        while (begin < end && is_empty(row + begin)) ++begin;
        while (begin < end && is_empty(row + end - 1)) --end;
        if (begin >= end) return;
        std::vector<float> line((static_cast<size_t>(m_pixels.width - 1) * m_factor + taps) * kChannels);
        for (int x = begin; x < end; ++x) sample(row + x, &line[static_cast<size_t>(x - from) * kChannels]);
        const int first = std::max((begin - from - taps) / m_factor, 0);
        const int last = std::min((end - 1 - from) / m_factor, m_pixels.width - 1);
        for (int x = first; x <= last; ++x) {
            const float* own = &line[static_cast<size_t>(x) * m_factor * kChannels];
            std::array<float, kChannels> sum{};
            for (int i = 0; i < taps; ++i) add_scaled(sum.data(), own + i * kChannels, kChannels, m_taps.weights[i]);
            std::copy(sum.begin(), sum.end(), across.at(x, y));
        }
    });
    Image down(m_pixels.width, m_pixels.height, kChannels);
    for_each_index(m_pixels.height, [&](int y) {
        for (int i = 0; i < taps; ++i) {
            const int row = m_top + y * m_factor - m_taps.reach + i;
            if (row < 0 || row >= m_samples.height) continue;
            add_scaled(down.at(0, y), across.at(0, row), static_cast<size_t>(m_pixels.width) * kChannels, m_taps.weights[i]);
        }
    });
    return down;
}

template <int kChannels>
Image Resolver::mean_of(const Image& samples, const PixelVector<float>& coverage) const {
    const auto is_empty = [&](size_t i) { return coverage[i] == 0; };
    const Image sums = filtered<kChannels + 1>(is_empty, [&](size_t i, float* values) {
        for (int c = 0; c < kChannels; ++c) values[c] = coverage[i] * samples.at(i)[c];
        values[kChannels] = coverage[i];
    });
    Image mean = Image::unset(m_pixels.width, m_pixels.height, kChannels);
    for_each_index(m_pixels.height, [&](int y) {
        for (int x = 0; x < m_pixels.width; ++x) {
            const float *sum = sums.at(x, y), covered = sum[kChannels];
            for (int c = 0; c < kChannels; ++c) mean.at(x, y)[c] = covered > 0 ? sum[c] / covered : 0.0f;
        }
    });
    return mean;
}

Image Resolver::mean(const Image& samples, const PixelVector<float>& coverage) const {
    return samples.channels == 1 ? mean_of<1>(samples, coverage) : mean_of<3>(samples, coverage);
}

Cover Resolver::cover(const Surfaces& surfaces, const PixelVector<float>& coverage) const {
    const auto is_empty = [&](size_t i) { return surfaces.validity(i) == Validity::background; };
    const Image sums = filtered<2>(is_empty, [&](size_t i, float* values) {
        values[0] = coverage[i];
        values[1] = is_empty(i) ? 0.0f : 1.0f;
    });
    Cover cover;
    cover.overlay.resize(sums.pixel_count()), cover.specular.resize(sums.pixel_count());
    for (size_t i = 0; i < sums.pixel_count(); ++i) {
        const float covered = sums.at(i)[0], surface = sums.at(i)[1];
        cover.overlay[i] = covered;
        cover.specular[i] = surface > 0 ? std::min(covered / surface, 1.0f) : 0.0f;
    }
    return cover;
}

template <class Fold>
Image Resolver::folded(const Image& samples, float first, const Fold& fold) const {
    Image out(m_pixels.width, m_pixels.height, 1, first);
    for_each_index(m_pixels.height, [&](int y) {
        const int top = std::max(m_top + y * m_factor, 0), bottom = std::min(m_top + (y + 1) * m_factor, m_samples.height);
        const int end = std::min(m_left + m_pixels.width * m_factor, m_samples.width);
        for (int row = top; row < bottom; ++row)
            for (int x = std::max(m_left, 0); x < end; ++x) {
                float& value = *out.at((x - m_left) / m_factor, y);
                value = fold(value, *samples.at(x, row));
            }
    });
    return out;
}

Image Resolver::sum(const Image& samples) const {
    return folded(samples, 0.0f, [](float a, float b) { return a + b; });
}

Image Resolver::least(const Image& samples, float none) const {
    return folded(samples, none, [](float a, float b) { return std::min(a, b); });
}

}  // namespace burnish
