// Filter weights against the renderers' own formulas, integrated numerically.
#include <burnish/composite/pixel_filter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

using namespace burnish;

namespace {

/// A filter as a renderer's source spells it: value at x pixels from the centre, and where it ends.
struct Published {
    FilterKind kind;
    float width;
    double reach;
    std::function<double(double)> value;
};

std::vector<Published> published() {
    const auto window = [](double x) {  // Cycles, width 1.5: the window over twice the width
        const double v = 2 * std::numbers::pi * (x / 3.0 + 0.5);
        return 0.35875 - 0.48829 * std::cos(v) + 0.14128 * std::cos(2 * v) - 0.01168 * std::cos(3 * v);
    };
    return {{FilterKind::box, 1.0f, 0.5, [](double) { return 1.0; }},
            {FilterKind::box, 1.5f, 0.75, [](double) { return 1.0; }},
            {FilterKind::triangle, 2.0f, 1.0, [](double x) { return 1 - std::abs(x); }},
            {FilterKind::gaussian, 2.0f, 1.0, [](double x) { return std::exp(-2 * x * x); }},
            {FilterKind::gaussian, 3.0f, 1.5, [](double x) { return std::exp(-2 * (x / 1.5) * (x / 1.5)); }},
            {FilterKind::blackman_harris, 1.5f, 1.5, window}};
}

double numeric_integral(const Published& filter, double from, double to) {
    constexpr int kSteps = 2000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double x = from + (to - from) * (i + 0.5) / kSteps;
        sum += std::abs(x) < filter.reach ? filter.value(x) : 0.0;
    }
    return sum * (to - from) / kSteps;
}

}  // namespace

TEST(PixelFilter, WeightsAreWhatTheFilterHasOverEachSample) {
    for (const Published& filter : published())
        for (const int factor : {1, 2, 3, 4}) {
            const FilterTaps taps = filter_taps({filter.kind, filter.width}, factor);
            const double all = numeric_integral(filter, -filter.reach, filter.reach);
            ASSERT_EQ(static_cast<int>(taps.weights.size()), factor + 2 * taps.reach);
            EXPECT_EQ(taps.reach, static_cast<int>(std::ceil((filter.reach - 0.5) * factor)));
            for (int i = 0; i < factor + 2 * taps.reach; ++i) {
                const double left = static_cast<double>(i - taps.reach) / factor - 0.5;
                EXPECT_NEAR(taps.weights[i], numeric_integral(filter, left, left + 1.0 / factor) / all, 3e-4)
                    << filter_name(filter.kind) << " " << filter.width << " factor " << factor << " sample " << i;
            }
        }
}

TEST(PixelFilter, WeightsSumToOneAndAreSymmetric) {
    for (const Published& filter : published()) {
        const std::vector<float> weights = filter_taps({filter.kind, filter.width}, 4).weights;
        EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-6);
        for (size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(weights[i], weights[weights.size() - 1 - i], 1e-7);
    }
}

TEST(PixelFilter, BoxOfOnePixelIsTheMean) {
    for (const int factor : {1, 2, 4, 5}) {
        const FilterTaps taps = filter_taps({FilterKind::box, 1.0f}, factor);
        EXPECT_EQ(taps.reach, 0);
        for (const float weight : taps.weights) EXPECT_NEAR(weight, 1.0 / factor, 1e-7);
    }
}

TEST(PixelFilter, WhatIsLeftOpenIsTheRenderersDefault) {
    EXPECT_EQ(settled({}, Renderer::cycles).kind, FilterKind::blackman_harris);
    EXPECT_EQ(settled({}, Renderer::cycles).width, 1.5f);
    EXPECT_EQ(settled({}, Renderer::arnold).kind, FilterKind::gaussian);
    EXPECT_EQ(settled({}, Renderer::unknown).kind, FilterKind::box);
    EXPECT_EQ(settled({FilterKind::triangle, 0}, Renderer::cycles).width, 2.0f);
    EXPECT_EQ(settled({FilterKind::gaussian, 3}, Renderer::cycles).width, 3.0f);
}
