// Factors in 8 bits: what they keep, how far they are off.
#include "cook_torrance.h"

#include <burnish/base/error.h>
#include <burnish/factor/brdf_samples.h>
#include <burnish/factor/factor_error.h>
#include <burnish/factor/factorise.h>
#include <burnish/factor/prescale_search.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace burnish {
namespace {

DirectionPair pair_of(int i) {
    const auto direction = [](float u, float v) {
        const float z = 1 - 0.95f * u, phi = 2 * kPi * v, r = std::sqrt(1 - z * z);
        return Vec3f(r * std::cos(phi), r * std::sin(phi), z);
    };
    const auto part = [&](float step) { return std::fmod(static_cast<float>(i) * step, 1.0f); };
    return {direction(part(0.8192f), part(0.6710f)), direction(part(0.5497f), part(0.4503f))};
}

/// p(wi) q(h) p(wo) with a peak a thousand times what lies around it, as metals have.
Factors peaked_factors() {
    Factors factors = uniform_factors(parametrization_by_name("pqp"), Mapping::cube, 32, Color3f(1, 0.8f, 0.5f));
    FactorMap& half = factors.terms[0][1];
    for (size_t i = 0; i < half.texels.size(); ++i) {
        const Vec3f d = half.layout.direction(static_cast<int>(i));
        half.texels[i] *= 0.01f + 10 * std::exp(-(1 - d.z) / 0.02f);
    }
    return factors;
}

std::vector<FactorSample> samples_of(const Factors& factors, int count) {
    std::vector<FactorSample> samples;
    for (int i = 0; i < count; ++i) samples.push_back({pair_of(i), factors(pair_of(i))});
    return samples;
}

TEST(Quantise, KeepsEvenMapsWithinAStep) {
    for (const Parametrization& parametrization : parametrizations()) {
        const Factors factors = uniform_factors(parametrization, Mapping::cube, 8, Color3f(1.5f, 0.7f, 0.2f));
        const QuantisedFactors eight_bit = quantise(factors, QuantiseSettings());
        for (int i = 0; i < 50; ++i)
            for (int c = 0; c < 3; ++c) {
                const float value = factors(pair_of(i))[c];
                EXPECT_NEAR(eight_bit(pair_of(i))[c], value, 0.02f * value) << parametrization.name;
            }
    }
}

TEST(Quantise, WeightsMultiplyToOne) {
    for (const Parametrization& parametrization : parametrizations()) {
        std::vector<float> weights = {3};
        for (int map = 0; map < parametrization.map_count(); ++map) weights.push_back(0.5f + map);
        const std::vector<float> s = prescale_of_weights(parametrization, weights);
        float product = s[0];
        for (int map = 0; map < parametrization.map_count(); ++map) product *= std::pow(s[map + 1], parametrization.uses(map));
        EXPECT_NEAR(product, 1, 1e-5f) << parametrization.name;
        EXPECT_NEAR(std::pow(s[1], parametrization.uses(0)) / s[0], std::pow(weights[1], parametrization.uses(0)) / 3, 1e-5f);
        std::ranges::for_each(prescale_of_weights(parametrization, s), [&, i = 0](float again) mutable {
            EXPECT_NEAR(again, s[i++], 1e-5f);  // factors are their own weights
        });
    }
}

TEST(Quantise, ColoursAreClampedAtWhite) {
    const Factors factors = uniform_factors(parametrization_by_name("nr"), Mapping::cube, 8, Color3f(2, 1, 0.5f));
    QuantiseSettings settings;
    settings.white = 2;
    const QuantisedFactors eight_bit = quantise(factors, settings);  // 4, 1, 0.25 are wanted
    EXPECT_EQ(eight_bit.terms[0].scale, 2);
    EXPECT_NEAR(eight_bit(pair_of(1)).x, 2, 0.02f);
    EXPECT_NEAR(eight_bit(pair_of(1)).y, 1, 0.02f);
    EXPECT_NEAR(eight_bit(pair_of(1)).z, 0.25f, 0.02f);
}

TEST(Quantise, AlphaKeepsWhatIsDark) {
    const Factors factors = peaked_factors();
    const std::vector<FactorSample> samples = samples_of(factors, 4000);
    QuantiseSettings opaque;
    opaque.alpha = false;
    const QuantisedFactors without = quantise(factors, opaque);
    for (const QuantisedMap& map : without.terms[0].maps)
        EXPECT_TRUE(std::ranges::all_of(map.texels, [](const auto& texel) { return texel[3] == 255; }));
    const double with_alpha = factor_error(quantise(factors, QuantiseSettings()), samples).average_relative;
    EXPECT_LT(with_alpha, 0.02);
    EXPECT_LT(8 * with_alpha, factor_error(without, samples).average_relative);
}

TEST(Quantise, SearchesAPrescaleThatPays) {
    Factors factors = peaked_factors();
    FactorMap& half = factors.terms[0][1];
    for (size_t i = 0; i < half.texels.size(); ++i) half.texels[i] = Color3f(0.2f + 0.1f * static_cast<float>(i % 7));
    half.texels[2 * 32 + 16] = Color3f(50);  // near the horizon: takes all the range, hardly looked up
    const std::vector<FactorSample> samples = samples_of(factors, 4000);
    QuantiseSettings opaque;
    opaque.alpha = false;
    const QuantiseSettings found = best_prescale(factors, opaque, samples)[0];
    const FactorError prescaled = factor_error(quantise(factors, found), samples);
    EXPECT_LT(8 * prescaled.average_relative, factor_error(quantise(factors, opaque), samples).average_relative);
    EXPECT_LT(prescaled.average_relative, 0.02);
}

TEST(Quantise, AddsTermsUp) {
    Factors factors = peaked_factors();
    factors.terms.push_back(uniform_factors(*factors.parametrization, Mapping::cube, 32, Color3f(0.3f, 0.2f, 0.7f)).terms[0]);
    factors.terms[1][0].texels[5] = Color3f(-0.01f);  // one that is cut off
    const std::vector<FactorSample> samples = samples_of(factors, 2000);
    const QuantisedFactors eight_bit = quantise(factors, best_prescale(factors, {}, samples));
    ASSERT_EQ(eight_bit.terms.size(), 2u);
    EXPECT_NE(eight_bit.terms[0].white, eight_bit.terms[1].white);
    EXPECT_LT(factor_error(eight_bit, samples).average_relative, 0.02);
}

TEST(Quantise, SearchesNothingThatIsGiven) {
    const Factors factors = peaked_factors();
    const QuantiseSettings given{{1, 1, 1}, 3};
    const QuantiseSettings found = best_prescale(factors, given, samples_of(factors, 100))[0];
    EXPECT_EQ(found.weights, given.weights);
    EXPECT_EQ(found.white, 3);
}

TEST(Quantise, KeepsTheGoldOfTheSource) {
    // Factor 4.3: average relative error 0.094 of the maps, 0.240 of 8 bits; RMS 0.294 and 0.862.
    const Parametrization& pqp = parametrization_by_name("pqp");
    const CookTorrance gold{0.3f};
    const std::vector<FactorSample> samples = brdf_samples(pqp, gold, {.size = 14});
    constexpr float kBias = 1e-5f;
    FactoriseSettings maps;
    maps.size = 64;
    const Factors factors = factorise(pqp, samples, {}, maps);
    const QuantisedFactors eight_bit = quantise(factors, best_prescale(factors, {}, samples));
    const FactorError is = factor_error(factors, samples, kBias), rounded = factor_error(eight_bit, samples, kBias);
    EXPECT_LT(is.average_relative, 0.094);
    EXPECT_LT(rounded.average_relative, 0.24);
    EXPECT_LT(rounded.rms, 0.862 / 0.294 * is.rms);
}

TEST(Quantise, RefusesWhatCannotBe) {
    Factors factors = peaked_factors();
    EXPECT_THROW(best_prescale(factors, {}, {}), Error);
    for (const QuantiseSettings& bad :
         {QuantiseSettings{{1, 1}}, QuantiseSettings{{1, 0, 1}}, QuantiseSettings{{}, -1}, QuantiseSettings{{}, 0, 3}})
        EXPECT_THROW(quantise(factors, bad), Error);
    factors.terms.push_back(factors.terms[0]);
    for (Color3f& texel : factors.terms[1][0].texels) texel *= -0.5f;
    EXPECT_THROW(quantise(factors, QuantiseSettings()), Error);
}

}  // namespace
}  // namespace burnish
