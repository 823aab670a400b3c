#include <burnish/fit/slices/bounded_least_squares.h>
#include <burnish/fit/slices/least_squares.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace burnish;

namespace {

double error(const BoundedLeastSquares& problem, const Eigen::VectorXd& x) {
    return x.dot(problem.H * x) - 2 * problem.g.dot(x);
}

/// Two unknowns, correlated, at least 0, their sum at most 1.
BoundedLeastSquares triangle(double g0, double g1) {
    BoundedLeastSquares problem{Eigen::MatrixXd(2, 2), Eigen::VectorXd(2), Eigen::MatrixXd(3, 2), Eigen::VectorXd(3)};
    problem.H << 2, 0.8, 0.8, 1;
    problem.g << g0, g1;
    problem.bounds << 1, 0, 0, 1, -1, -1;
    problem.limits << 0, 0, -1;
    return problem;
}

}  // namespace

TEST(BoundedLeastSquares, FindsWhatASearchOfAllPointsFinds) {
    for (const auto& [g0, g1] : {std::pair(0.7, 0.4), {3.0, 0.2}, {-1.0, 0.5}, {2.0, 2.0}, {-1.0, -1.0}, {0.1, 3.0}}) {
        const BoundedLeastSquares problem = triangle(g0, g1);
        const Eigen::VectorXd x = solve(problem);
        EXPECT_TRUE((problem.bounds * x - problem.limits).minCoeff() > -1e-9);
        double least = 1e30;
        for (int i = 0; i <= 400; ++i)
            for (int j = 0; i + j <= 400; ++j) least = std::min(least, error(problem, Eigen::Vector2d(i / 400.0, j / 400.0)));
        EXPECT_LE(error(problem, x), least + 1e-12) << g0 << " " << g1;
        EXPECT_NEAR(error(problem, x), least, 1e-4) << g0 << " " << g1;
    }
}

TEST(BoundedLeastSquares, UnknownsWithoutInfluenceAreZero) {
    BoundedLeastSquares problem = triangle(0.7, 0);
    problem.H << 2, 0, 0, 0;
    const Eigen::VectorXd x = solve(problem);
    EXPECT_NEAR(x[0], 0.35, 1e-9);
    EXPECT_EQ(x[1], 0);
}

TEST(LeastSquares, RecoversNumbersOfManyMagnitudesAndKeepsFixedOnes) {
    const SearchRange ranges[] = {{1e-3, 10, true}, {0, 2}, {3, 3}};
    const auto curve = [](double a, double p, double q, double t) { return std::exp(-t / a) * std::pow(1 + t, -p) + q; };
    const auto residuals = [&](std::span<const double> x, std::vector<double>& r) {
        r.clear();
        for (int k = 0; k < 60; ++k) {
            const double t = 1e-3 * std::pow(1.15, k);
            r.push_back(curve(x[0], x[1], x[2], t) - curve(0.2, 0.7, 3, t));
        }
    };
    const std::vector<double> found = least_squares(ranges, {0.3, 1, 3}, residuals);
    EXPECT_NEAR(found[0], 0.2, 1e-6);
    EXPECT_NEAR(found[1], 0.7, 1e-5);
    EXPECT_EQ(found[2], 3);
}

TEST(LeastSquares, GoesToTheEndOfARangeWhereTheBestIsBeyond) {
    const SearchRange range[] = {{0, 1}};
    const std::vector<double> found = least_squares(range, {0.5}, [](std::span<const double> x, std::vector<double>& r) {
        r = {x[0] - 3, 0.1};
    });
    EXPECT_NEAR(found[0], 1, 1e-6);
}
