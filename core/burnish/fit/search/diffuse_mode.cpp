#include <burnish/fit/search/diffuse_mode.h>
#include <burnish/fit/search/weighted_median.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr float kLowest = 1e-6f, kHighest = 1e3f;    // of f
constexpr int kBinsPerDecade = 60;                   // 4 % wide
constexpr float kAround = 1.1f;                      // the peak of the histogram: its mode times or by this
constexpr float kFloor = 0.5f;                       // values below this share of the mode are under the floor,
constexpr double kMaxBelow = 0.25, kMinPeak = 0.05;  // shares of all weight: under the floor at most, around the mode at least

int bin_of(float f) { return static_cast<int>(kBinsPerDecade * std::log10(f / kLowest)); }

/// The middle of the fullest bin after smoothing over seven.
float mode(std::span<const WeightedValue> values) {
    constexpr int kBins = static_cast<int>(kBinsPerDecade * 9), kSmooth = 3;
    std::vector<double> histogram(kBins, 0.0);
    for (const WeightedValue& v : values)
        for (int d = -kSmooth; d <= kSmooth; ++d)
            if (const int bin = bin_of(v.value) + d; bin >= 0 && bin < kBins)
                histogram[static_cast<size_t>(bin)] += v.weight * (kSmooth + 1 - std::abs(d));
    const auto fullest = std::ranges::max_element(histogram) - histogram.begin();
    return kLowest * std::pow(10.0f, (static_cast<float>(fullest) + 0.5f) / kBinsPerDecade);
}

float channel_kd(const TransferSamples& samples, int channel) {
    std::vector<WeightedValue> values;
    double all = 0;
    for (size_t j = 0; j < samples.size(); ++j) {
        const float f = samples.p[j][channel] / samples.cosine[j];
        if (!(f >= kLowest && f < kHighest)) continue;
        values.push_back({f, samples.weight[j], static_cast<int>(j)});
        all += samples.weight[j];
    }
    if (values.empty()) return 0;
    const float top = mode(values);
    double below = 0;
    std::vector<WeightedValue> around;
    double peak = 0;
    for (const WeightedValue& v : values) {
        if (v.value < kFloor * top) below += v.weight;
        if (v.value < top / kAround || v.value > top * kAround) continue;
        around.push_back(v);
        peak += v.weight;
    }
    if (below > kMaxBelow * all || peak < kMinPeak * all) return 0;
    return std::min(1.0f, kPi * weighted_median(around).value);
}

}  // namespace

Color3f diffuse_mode(const TransferSamples& samples) {
    return {channel_kd(samples, 0), channel_kd(samples, 1), channel_kd(samples, 2)};
}

}  // namespace burnish
