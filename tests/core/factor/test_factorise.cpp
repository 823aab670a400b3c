// Factorisations of functions whose factors are known.
#include "cook_torrance.h"

#include <burnish/base/display.h>
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/factor/brdf_samples.h>
#include <burnish/factor/factor_error.h>
#include <burnish/factor/factorise.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace burnish {
namespace {

using Function = std::function<Color3f(const DirectionPair&)>;

/// At pairs of texels of discs of `size`, over the whole sphere for lighting.
std::vector<FactorSample> grid_samples(FactoredFunction of, int size, const Function& f) {
    const DirectionMap grid(of == FactoredFunction::brdf ? Mapping::parabolic : Mapping::double_parabolic, size);
    std::vector<FactorSample> samples;
    for (int a = 0; a < grid.texels(); ++a)
        for (int b = 0; b < grid.texels(); ++b) {
            const DirectionPair pair{grid.direction(a), grid.direction(b)};
            const bool is_seen = of == FactoredFunction::brdf || pair.a.dot(pair.b) > 0;
            if (grid.holds(a) && grid.holds(b) && is_seen) samples.push_back({pair, f(pair), 1});
        }
    return samples;
}

/// Smooth and above zero.
Color3f hill(const Vec3f& d, const Vec3f& top) {
    return Color3f(0.3f, 0.5f, 1.0f) + Color3f(1, 0.7f, 0.4f) * std::exp(d.dot(top));
}

/// A product for each parametrisation's factors, of hills about a direction a map.
Function separable(const Parametrization& parametrization, const FactorGuide& guide) {
    return [&parametrization, guide](const DirectionPair& pair) {
        Color3f product(1, 1, 1);
        for (const Factor& factor : parametrization.factors) {
            const float angle = 1.0f + 2 * static_cast<float>(factor.map);
            product *= hill(factor.direction->project(pair, guide), {std::sin(angle) * 0.6f, std::cos(angle) * 0.6f, 0.8f});
        }
        return product;
    };
}

TEST(Factorise, FindsTheFactorsOfAProduct) {
    FactorGuide guide;
    guide.dominant = Vec3f(2, -1, 2) / 3.0f;
    for (const Parametrization& parametrization : parametrizations())
        for (const Mapping sphere : {Mapping::double_parabolic, Mapping::cube}) {
            const auto samples = grid_samples(parametrization.of, 10, separable(parametrization, guide));
            FactoriseSettings settings;
            settings.size = 16;
            settings.sphere = sphere;
            const Factors factors = factorise(parametrization, samples, guide, settings);
            EXPECT_LT(factor_error(factors, samples).average_relative, 1e-2)
                << parametrization.name << " " << mapping_name(sphere);
            if (parametrization.of == FactoredFunction::brdf) break;
        }
}

TEST(Factorise, StartsWithTheAnswerWhereThereIsOneFactor) {
    // As prefiltered light is looked up by the reflected direction alone (Factor 63): nothing has to be solved.
    const Factor reflection = parametrization_by_name("nr").factors[1];
    const Parametrization r{"r", "", FactoredFunction::lighting, {{reflection.direction, 0}}};
    const auto samples = grid_samples(FactoredFunction::lighting, 12, separable(r, {}));
    FactoriseSettings start;
    start.size = 16, start.iterations = 0, start.polish = false;
    EXPECT_LT(factor_error(factorise(r, samples, {}, start), samples).average_relative, 0.02);
}

/// Lobes that are no product of functions of either direction.
Color3f mixed(const DirectionPair& pair) {
    const float peak = std::exp(6 * (pair.a.dot(pair.b) - 1));
    return Color3f(0.05f, 0.1f, 0.2f) + Color3f(0.5f, 0.4f, 0.3f) * peak + Color3f(0.3f) * (pair.a.z * pair.b.z);
}

double display_error(const Factors& factors, const std::vector<FactorSample>& samples) {
    double mean = 0, sum = 0;
    for (const FactorSample& s : samples)
        mean += (s.value.x + s.value.y + s.value.z) / (3.0 * static_cast<double>(samples.size()));
    for (const FactorSample& s : samples)
        for (int channel = 0; channel < 3; ++channel) {
            const auto shown = [&](const Color3f& f) { return display_encoded(f[channel] * kMiddleGrey / mean); };
            sum += std::pow(shown(factors(s.pair)) - shown(s.value), 2);
        }
    return std::sqrt(sum / static_cast<double>(samples.size()));
}

TEST(Factorise, PolishesTheErrorThatIsAskedFor) {
    const Parametrization& io = parametrization_by_name("io");
    const auto samples = grid_samples(FactoredFunction::brdf, 10, mixed);
    const auto made = [&](FactorMeasure measure, bool polish) {
        FactoriseSettings settings;
        settings.size = 12, settings.measure = measure, settings.polish = polish;
        return factorise(io, samples, {}, settings);
    };
    const Factors plain = made(FactorMeasure::relative, false), relative = made(FactorMeasure::relative, true),
                  display = made(FactorMeasure::display, true), absolute = made(FactorMeasure::absolute, true);
    const auto relative_of = [&](const Factors& f) { return factor_error(f, samples).average_relative; };
    const auto rms_of = [&](const Factors& f) { return factor_error(f, samples).rms; };
    for (const Factors& other : {plain, display, absolute}) EXPECT_LT(relative_of(relative), 0.98 * relative_of(other));
    for (const Factors& other : {plain, relative, absolute})
        EXPECT_LT(display_error(display, samples), display_error(other, samples));
    for (const Factors& other : {plain, relative, display}) EXPECT_LT(rms_of(absolute), 0.99 * rms_of(other));
}

TEST(Factorise, SumsTermsWithSigns) {
    // Of rank 2: exact with two terms, but for what maps blend between their texels.
    const Parametrization& io = parametrization_by_name("io");
    const auto samples = grid_samples(FactoredFunction::brdf, 10, [](const DirectionPair& pair) {
        return Color3f(1, 2, 3) + Color3f(0.8f, 1.5f, 2.0f) * (pair.a.x * pair.b.x);
    });
    const auto error_with = [&](int terms) {
        FactoriseSettings settings;
        settings.size = 16, settings.terms = terms, settings.measure = FactorMeasure::absolute;
        const Factors factors = factorise(io, samples, {}, settings);
        EXPECT_EQ(factors.terms.size(), static_cast<size_t>(terms));
        return factor_error(factors, samples).rms;
    };
    const double one = error_with(1), two = error_with(2);
    EXPECT_GT(one, 0.1);
    EXPECT_LT(two, 0.01);
}

TEST(Factorise, MeetsTheSourceWithTheGoldOfCookAndTorrance) {
    for (const char* name : {"pqp", "hd"}) {
        const Parametrization& parametrization = parametrization_by_name(name);
        const auto samples = brdf_samples(parametrization, CookTorrance{0.3f}, {24, 0.02f});
        const FactoriseSettings settings;
        const FactorError error = factor_error(factorise(parametrization, samples, {}, settings), samples, settings.bias);
        EXPECT_LT(error.average_relative, 0.094) << name;
    }
}

TEST(Factorise, GivesTheSameBitsForAnyThreadCount) {
    const Parametrization& nr = parametrization_by_name("nr");
    const auto samples = grid_samples(FactoredFunction::lighting, 8, separable(nr, {}));
    const auto texels = [&](int threads) {
        const ThreadLimit limit(threads);
        FactoriseSettings settings;
        settings.size = 8;
        return factorise(nr, samples, {}, settings).terms[0][1].texels;
    };
    EXPECT_EQ(texels(1), texels(2));
}

TEST(Factorise, RefusesWhatItCannotFactor) {
    const Parametrization& io = parametrization_by_name("io");
    EXPECT_THROW(factorise(io, {}, FactorGuide()), Error);
    const FactorSample good{{{0, 0, 1}, {0, 0, 1}}, Color3f(1), 1};
    FactorSample endless = good, negative = good, weighed = good;
    endless.value.y = std::numeric_limits<float>::infinity();
    negative.value.z = -1;
    weighed.weight = std::numeric_limits<float>::quiet_NaN();
    for (const FactorSample& bad : {endless, negative, weighed})
        EXPECT_THROW(factorise(io, std::vector{good, bad}, FactorGuide()), Error);
    FactoriseSettings settings;
    settings.terms = 9;
    EXPECT_THROW(factorise(io, std::vector{good}, {}, settings), Error);
    settings.terms = 2, settings.polish = false;
    EXPECT_THROW(factorise(io, std::vector{good}, {}, settings), Error);
    settings = {};
    settings.size = 1;
    EXPECT_THROW(factorise(io, std::vector{good}, {}, settings), Error);
}

TEST(FactorError, IsWhatTheHandComputes) {
    const DirectionPair pair{{0, 0, 1}, {0, 0, 1}};
    const std::vector<FactorSample> samples = {{pair, Color3f(1, 2, 0), 1}, {pair, Color3f(4, 4, 4), 7}};
    const FactorError error = factor_error([](const DirectionPair&) { return Color3f(2); }, samples);
    EXPECT_DOUBLE_EQ(error.average_absolute, (1 + 0 + 2 + 2 + 2 + 2) / 6.0);
    EXPECT_DOUBLE_EQ(error.max_absolute, 2);
    EXPECT_DOUBLE_EQ(error.average_relative, (1 + 0 + 0.5 + 0.5 + 0.5) / 5.0);
    EXPECT_DOUBLE_EQ(error.max_relative, 1);
    const double floor = 0.5 * 15 / 6;  // half the mean
    const FactorError biased = factor_error([](const DirectionPair&) { return Color3f(2); }, samples, 0.5f);
    EXPECT_NEAR(biased.average_relative, (1 / (1 + floor) + 2 / floor + 3 * 2 / (4 + floor)) / 6, 1e-6);
    EXPECT_DOUBLE_EQ(error.rms, std::sqrt((1 + 0 + 4 + 4 + 4 + 4) / 6.0));
}

}  // namespace
}  // namespace burnish
