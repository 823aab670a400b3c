#include <burnish/fit/color_shift.h>

#include <burnish/material/material_brdf.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burnish {
namespace {

float sum_of(const Color3f& color) { return color.x + color.y + color.z; }

Color3f shares(const Color3f& color) {
    constexpr float kBlack = 1e-9f;
    return color / std::max(sum_of(color), kBlack);
}

/// The value that a hundredth of the pairs exceeds.
float brightest(std::span<const BrdfSample> samples) {
    std::vector<float> values;
    for (const BrdfSample& sample : samples) values.push_back(sum_of(sample.f));
    const auto limit = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 100);
    std::ranges::nth_element(values, limit);
    return *limit;
}

}  // namespace

double color_shift(std::span<const BrdfSample> samples, const Material& fit) {
    if (samples.empty()) return 0;
    const MaterialBrdf model(fit);
    const float limit = brightest(samples);
    double shifted = 0, light = 0;
    for (const BrdfSample& sample : samples) {
        if (sum_of(sample.f) > limit) continue;
        const Color3f difference = shares(sample.f) - shares(model(sample.wo, sample.wi));
        const float sine_o = std::sqrt(std::max(0.0f, 1 - sample.wo.z * sample.wo.z));
        const double weight =
            sum_of(sample.f) * std::fabs(sample.wi.z) * sample.wo.z * sine_o;  // of its light, over the sphere
        shifted += 0.5 * weight * (std::fabs(difference.x) + std::fabs(difference.y) + std::fabs(difference.z));
        light += weight;
    }
    return light > 0 ? shifted / light : 0;
}

}  // namespace burnish
