#include "core/scenes.h"
#include "core/simd_targets.h"

#include <burnish/surface/classify.h>
#include <burnish/surface/collect.h>
#include <burnish/surface/fetch.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

using namespace burnish;

namespace {

constexpr int kWidth = 37, kHeight = 29;  // no multiple of any vector
constexpr size_t kPixels = kWidth * kHeight;
constexpr float kMinLength = 0.3f;
const Vec3f kEye(0.5f, -0.25f, 4);

/// Surfaces at random, one pixel in four broken in one way or another.
struct RandomPixels {
    RandomPixels() : position(kWidth, kHeight, 3), normal(kWidth, kHeight, 3), depth(kWidth, kHeight, 1, 2), rule(kPixels, 0) {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> uniform(-1, 1);
        const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
        const float odd[] = {nan, inf, -inf, 1e10f, 0, 1e-8f, 0.1f};
        for (size_t i = 0; i < kPixels; ++i) {
            for (int k = 0; k < 3; ++k) position.at(i)[k] = uniform(random), normal.at(i)[k] = uniform(random);
            rule[i] = static_cast<int16_t>(i / 64 % 2 + random() % 16 / 15);
            if (random() % 4) continue;
            const float value = odd[random() % std::size(odd)];
            float* const targets[] = {position.at(i) + random() % 3, normal.at(i) + random() % 3, depth.at(i)};
            *targets[random() % 3] = value;
            if (random() % 4 == 0) std::fill_n(random() % 2 ? position.at(i) : normal.at(i), 3, value);
            if (random() % 8 == 0) rule[i] = -1;
        }
    }

    PixelLayers layers(bool with_depth) const {
        return {position.data.data(), normal.data.data(), with_depth ? depth.data.data() : nullptr, rule.data()};
    }

    Image position, normal, depth;
    std::vector<int16_t> rule;
};

bool is_far(float v) { return std::abs(v) >= 1e9f; }

/// What `classify` is to find, pixel by pixel.
Validity expected(const RandomPixels& pixels, bool with_depth, size_t i) {
    const Vec3f p(pixels.position.at(i)[0], pixels.position.at(i)[1], pixels.position.at(i)[2]);
    const Vec3f n(pixels.normal.at(i)[0], pixels.normal.at(i)[1], pixels.normal.at(i)[2]);
    if (p == Vec3f(0, 0, 0) || is_far(p.x) || is_far(p.y) || is_far(p.z)) return Validity::background;
    if (with_depth && !(*pixels.depth.at(i) < 1e9f)) return Validity::background;
    if (!is_finite(p) || !is_finite(n)) return Validity::not_finite;
    if (n.length() < 1e-6f) return Validity::zero_normal;
    if (n.length() < kMinLength) return Validity::averaged_normal;
    if (pixels.rule[i] < 0) return Validity::unassigned;
    return n.dot(kEye - p) > 0 ? Validity::valid : Validity::back_facing;
}

std::vector<Validity> classified(const RandomPixels& pixels, bool with_depth, PixelCounts& counts) {
    std::vector<Validity> validity(kPixels);
    counts.rule.assign(3, 0);
    classify(pixels.layers(with_depth), {kEye, kMinLength}, validity, counts);
    return validity;
}

/// A third of the pixels in runs, the others here and there, in no order.
std::vector<uint32_t> some_pixels() {
    std::vector<uint32_t> pixels;
    for (uint32_t i = 100; i < 100 + kPixels / 3; ++i) pixels.push_back(i);
    std::mt19937 random(3);
    for (int i = 0; i < 101; ++i) pixels.push_back(random() % kPixels);
    return pixels;
}

}  // namespace

TEST(PixelKernels, ClassifyAndCountAsOnePixelAfterTheOther) {
    const RandomPixels pixels;
    for (const bool with_depth : {false, true})
        burnish_test::for_each_target([&] {
            PixelCounts counts, truth;
            truth.rule.assign(3, 0);
            const std::vector<Validity> found = classified(pixels, with_depth, counts);
            for (size_t i = 0; i < kPixels; ++i) {
                const Validity validity = expected(pixels, with_depth, i);
                EXPECT_EQ(found[i], validity) << i;
                ++truth.validity[static_cast<size_t>(validity)];
                if (validity == Validity::valid) ++truth.rule[static_cast<size_t>(pixels.rule[i])];
            }
            EXPECT_EQ(counts.validity, truth.validity);
            EXPECT_EQ(counts.rule, truth.rule);
            for (const size_t count : truth.validity) EXPECT_GT(count, 0u) << "the pixels try every kind";
        });
}

TEST(PixelKernels, CollectThePixelsOfARuleInAWindow) {
    const RandomPixels pixels;
    PixelCounts counts;
    const std::vector<Validity> validity = classified(pixels, true, counts);
    burnish_test::for_each_target([&] {
        for (const Window& window : {Window{0, 0, kWidth, kHeight}, Window{3, 5, 32, 9}, Window{30, 0, 7, kHeight}})
            for (const int rule : {0, 1, 2}) {
                std::vector<uint32_t> found{77}, truth{77};
                collect({validity.data(), pixels.rule.data(), kWidth}, window, rule, found);
                for (int y = window.y; y < window.y + window.height; ++y)
                    for (int x = window.x; x < window.x + window.width; ++x)
                        if (const uint32_t i = y * kWidth + x; validity[i] == Validity::valid && pixels.rule[i] == rule)
                            truth.push_back(i);
                EXPECT_EQ(found, truth) << rule;
            }
    });
}

TEST(PixelKernels, FetchTheSameBitsInWhateverListAPixelComes) {
    const RandomPixels pixels;
    const std::vector<uint32_t> listed = some_pixels();
    burnish_test::for_each_target([&] {
        Vec3Planes n, wo, one;
        fetch_unit(pixels.normal.data.data(), listed, n);
        fetch_views(pixels.position.data.data(), kEye, listed, wo);
        ASSERT_EQ(n.x.size(), listed.size());
        ASSERT_EQ(wo.z.size(), listed.size());
        for (size_t i = 0; i < listed.size(); ++i) {
            const float *p = pixels.position.at(static_cast<size_t>(listed[i])),
                        *v = pixels.normal.at(static_cast<size_t>(listed[i]));
            const Vec3f view = kEye - Vec3f(p[0], p[1], p[2]), normal(v[0], v[1], v[2]);
            if (!is_finite(view) || is_far(view.length()) || !is_finite(normal) || is_far(normal.length())) continue;
            EXPECT_EQ(wo[i], view / std::sqrt(view.length2())) << i;
            EXPECT_EQ(n[i], normal / std::sqrt(std::max(normal.length2(), 1e-37f))) << i;
        }
        for (const uint32_t& pixel : listed) {
            fetch_unit(pixels.normal.data.data(), {&pixel, 1}, one);
            EXPECT_EQ(std::memcmp(&one.x[0], &n.x[static_cast<size_t>(&pixel - listed.data())], sizeof(float)), 0);
        }
    });
}
