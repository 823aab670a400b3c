#include "core/simd_targets.h"

#include <burnish/base/error.h>
#include <burnish/base/types.h>
#include <burnish/composite/add_overlay.h>
#include <burnish/composite/composite.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace burnish;

namespace {

constexpr int kSize = 4;

Image filled(int channels, float value) { return Image(kSize, kSize, channels, value); }

Cover covered(float share) { return {PixelVector<float>(kSize * kSize, share), {}, {}}; }

AovFrame beauty_frame() {
    AovFrame frame;
    frame.file = "shot.exr";
    frame.layers[Role::beauty] = filled(3, 0.1f + 0.2f);
    frame.layers[Role::alpha] = filled(1, 0.25f);
    return frame;
}

}  // namespace

TEST(Composite, ZeroOverlayGivesTheBeautyBitForBit) {
    const AovFrame frame = beauty_frame();
    const Composite out = composite(frame, covered(1), filled(3, 0), nullptr, {});
    for (size_t i = 0; i < out.beauty.pixel_count(); ++i) {
        for (int c = 0; c < 3; ++c) EXPECT_EQ(out.beauty.at(i)[c], frame.layers.at(Role::beauty).at(i)[c]);
        EXPECT_EQ(out.beauty.at(i)[3], 0.25f);
    }
}

TEST(Composite, GainTintMaskAndCoverageMultiplyTheOverlay) {
    AovFrame frame = beauty_frame();
    frame.layers[Role::mask] = filled(1, 0.5f);
    CompositeSettings settings;
    settings.gain = 3, settings.tint = Color3f(1, 0.5f, 0);
    const Composite out = composite(frame, covered(0.5f), filled(3, 2), nullptr, settings);
    EXPECT_FLOAT_EQ(out.overlay.at(5)[0], 2 * 3 * 0.5f * 0.5f);
    EXPECT_FLOAT_EQ(out.overlay.at(5)[1], 2 * 3 * 0.5f * 0.5f * 0.5f);
    EXPECT_FLOAT_EQ(out.overlay.at(5)[2], 0);
    EXPECT_FLOAT_EQ(out.beauty.at(5)[0], 0.3f + 1.5f);
}

TEST(Composite, BrokenMaskPixelsHideTheOverlay) {
    AovFrame frame = beauty_frame();
    frame.layers[Role::mask] = filled(1, 1);
    *frame.layers[Role::mask].at(size_t{5}) = std::numeric_limits<float>::quiet_NaN();
    const Composite out = composite(frame, covered(1), filled(3, 2), nullptr, {});
    EXPECT_EQ(out.beauty.at(5)[0], frame.layers.at(Role::beauty).at(5)[0]);
    EXPECT_FLOAT_EQ(out.beauty.at(6)[0], 0.3f + 2);
}

TEST(Composite, ReplaceTakesTheRenderedSpecularOut) {
    AovFrame frame = beauty_frame();
    frame.divided_by_albedo = true;
    frame.layers[Role::specular_direct] = filled(3, 0.5f);
    frame.layers[Role::specular_indirect] = filled(3, 0.25f);
    frame.layers[Role::specular_albedo] = filled(3, 0.2f);
    CompositeSettings settings;
    settings.mode = CompositeMode::replace;
    const Composite out = composite(frame, covered(1), filled(3, 1), nullptr, settings);
    EXPECT_FLOAT_EQ(out.beauty.at(0)[0], 0.3f + 1 - 0.2f * 0.75f);
    frame.divided_by_albedo = false;
    EXPECT_FLOAT_EQ(rendered_specular(frame).at(0)[0], 0.75f);
}

TEST(Composite, DifferenceAddsNewMinusOld) {
    CompositeSettings settings;
    settings.mode = CompositeMode::difference;
    const Image old_overlay = filled(3, 0.75f);
    const Composite out = composite(beauty_frame(), covered(1), filled(3, 1), &old_overlay, settings);
    EXPECT_FLOAT_EQ(out.beauty.at(0)[0], 0.3f + 0.25f);
}

TEST(Composite, BuildsTheDiffusePartWhereThereIsNoBeauty) {
    AovFrame frame;
    frame.divided_by_albedo = true;
    frame.layers[Role::diffuse_direct] = filled(3, 2);
    frame.layers[Role::diffuse_indirect] = filled(3, 1);
    frame.layers[Role::diffuse_albedo] = filled(3, 0.5f);
    EXPECT_FLOAT_EQ(composite(frame, covered(1), filled(3, 0), nullptr, {}).beauty.at(3)[1], 1.5f);

    AovFrame lit;
    lit.layers[Role::irradiance] = filled(3, kPi);
    EXPECT_TRUE(needs_kd(lit) && !needs_kd(frame));
    Cover cover = covered(1);
    cover.kd = filled(3, 0.25f);
    cover.kd.at(3)[1] = 0.5f;
    const Composite out = composite(lit, cover, filled(3, 0), nullptr, {});
    EXPECT_FLOAT_EQ(out.beauty.at(3)[1], 0.5f);
    EXPECT_FLOAT_EQ(out.diffuse.at(3)[0], 0.25f);
}

TEST(Composite, NamesWhatIsMissing) {
    CompositeSettings settings;
    settings.mode = CompositeMode::replace;
    try {
        composite(beauty_frame(), covered(1), filled(3, 1), nullptr, settings);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ErrorCode::missing_channel);
        EXPECT_NE(std::string(e.what()).find("specular_direct"), std::string::npos);
    }
}

TEST(Composite, RowsOfAnyLengthAreTheSameBitsWithEveryInstructionSet) {
    constexpr size_t kPixels = 45;
    std::mt19937 random(11);
    std::uniform_real_distribution<float> uniform(0, 3);
    const auto values = [&](size_t count) {
        std::vector<float> result(count);
        for (float& value : result) value = uniform(random);
        return result;
    };
    const std::vector<float> shaded = values(3 * kPixels), old = values(3 * kPixels), base = values(3 * kPixels);
    const std::vector<float> removed = values(3 * kPixels), coverage = values(kPixels), mask = values(kPixels);
    const std::vector<float> replaced = values(kPixels), alpha = values(kPixels);
    const Color3f tint(0.9f, 0.7f, 1.3f);
    constexpr float kGain = 1.7f;
    burnish_test::for_each_target([&] {
        std::vector<float> overlay = shaded, beauty(4 * kPixels);
        add_overlay({overlay.data(), old.data(), base.data(), removed.data(), coverage.data(), replaced.data(), mask.data(),
                     alpha.data(), beauty.data()},
                    tint, kGain, kPixels);
        for (size_t i = 0; i < kPixels; ++i) {
            const volatile float weight = coverage[i] * mask[i],
                                 share = replaced[i] * mask[i];  // volatile: rounded after each step
            for (size_t k = 0; k < 3; ++k) {
                const volatile float gained = kGain * weight, factor = tint[static_cast<int>(k)] * gained;
                const volatile float added = (shaded[3 * i + k] - old[3 * i + k]) * factor, taken = removed[3 * i + k] * share;
                const volatile float sum = base[3 * i + k] + added;
                EXPECT_EQ(overlay[3 * i + k], added) << i;
                EXPECT_EQ(beauty[4 * i + k], sum - taken) << i;
            }
            EXPECT_EQ(beauty[4 * i + 3], alpha[i]) << i;
        }
    });
}
