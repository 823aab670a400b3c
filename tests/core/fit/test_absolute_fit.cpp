#include <burnish/fit/search/absolute_fit.h>
#include <gtest/gtest.h>

#include <random>

namespace burnish {
namespace {

TEST(WeightedMedian, IsTheValueOfLeastAbsoluteError) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<WeightedValue> values;
        for (int i = 0; i <= trial; ++i) values.push_back({std::round(20 * uniform(random)), uniform(random), i});
        const auto error = [&](float x) {
            double sum = 0;
            for (const WeightedValue& v : values) sum += v.weight * std::abs(v.value - x);
            return sum;
        };
        double least = error(values.front().value);
        for (const WeightedValue& v : values) least = std::min(least, error(v.value));
        std::vector<WeightedValue> shuffled = values;
        EXPECT_NEAR(error(weighted_median(shuffled).value), least, 1e-5 * (1 + least));
    }
}

TEST(WeightedMedian, OfNothingHasNoWeight) {
    std::vector<WeightedValue> none, weightless{{3, 0, 0}};
    EXPECT_EQ(weighted_median(none).index, -1);
    EXPECT_EQ(weighted_median(weightless).index, -1);
}

/// A target of two bases with outliers, as a lobe's two Fresnel ends are.
struct Problem {
    std::vector<float> target, first, second, weight;

    explicit Problem(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> uniform;
        const float s = uniform(random) - 0.3f, t = uniform(random) - 0.3f;
        for (int j = 0; j < 40; ++j) {
            first.push_back(uniform(random));
            second.push_back(uniform(random));
            weight.push_back(uniform(random));
            target.push_back(s * first.back() + t * second.back() + (j % 3 == 0 ? uniform(random) : 0.02f * uniform(random)));
        }
    }

    AbsoluteProblem view() const { return {target, first, second, weight}; }
    double error(double s, double t) const {
        double sum = 0;
        for (size_t j = 0; j < target.size(); ++j) sum += weight[j] * std::abs(target[j] - s * first[j] - t * second[j]);
        return sum;
    }
    /// The least error on a fine net over the allowed factors.
    double least(double min_sum, double max_sum) const {
        constexpr int kSteps = 400;
        double best = error(min_sum, 0);
        for (int i = 0; i <= kSteps; ++i)
            for (int k = 0; k <= kSteps; ++k) {
                const double sum = min_sum + (max_sum - min_sum) * i / kSteps, share = static_cast<double>(k) / kSteps;
                best = std::min(best, error(sum * (1 - share), sum * share));
            }
        return best;
    }
};

TEST(AbsoluteFit, IsAsLowAsAnyPairOfFactors) {
    AbsoluteScratch scratch;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const Problem problem(seed);
        const AbsoluteFit fit = fit_absolute(problem.view(), 0, 2, scratch);
        EXPECT_GE(fit.first, 0);
        EXPECT_GE(fit.second, 0);
        EXPECT_NEAR(fit.error, problem.error(fit.first, fit.second), 1e-5);
        EXPECT_LE(fit.error, problem.least(0, 2) + 1e-5) << seed;
    }
}

TEST(AbsoluteFit, KeepsTheSumInItsBounds) {
    AbsoluteScratch scratch;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const Problem problem(seed);
        const AbsoluteFit fit = fit_absolute(problem.view(), 0.3f, 0.5f, scratch);
        EXPECT_GE(fit.first + fit.second, 0.3f - 1e-6f);
        EXPECT_LE(fit.first + fit.second, 0.5f + 1e-6f);
        EXPECT_LE(fit.error, problem.least(0.3, 0.5) + 1e-5) << seed;
    }
}

TEST(AbsoluteFit, TakesBasesThatAreOne) {
    Problem problem(7);
    problem.second = problem.first;
    AbsoluteScratch scratch;
    const AbsoluteFit fit = fit_absolute(problem.view(), 0, 10, scratch);
    EXPECT_LE(fit.error, problem.least(0, 10) + 1e-5);
}

}  // namespace
}  // namespace burnish
