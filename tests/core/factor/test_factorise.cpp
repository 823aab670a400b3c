// Factorisations of functions whose factors are known.
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
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
    EXPECT_DOUBLE_EQ(error.rms, std::sqrt((1 + 0 + 4 + 4 + 4 + 4) / 6.0));
}

}  // namespace
}  // namespace burnish
