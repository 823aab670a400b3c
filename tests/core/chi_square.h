// Pearson's chi-square test that a sampler draws from the density it claims: for directions, colours, anything with a map
// to the unit square.
#pragma once

#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <optional>
#include <vector>

struct SquarePoint {
    double a, b;
};

struct ChiSquare {
    double statistic = 0;
    int degrees = 0;
    double p_value = 1;  // chance of a statistic this large when sampler and density agree
    double mass = 0;     // integral of the density over the square
};

/// `draw()` gives an independent point of the unit square, or nothing for a draw that falls outside; `density({a, b})` is per
/// unit area of the square. What the density lacks to 1 is expected outside. Cells that expect fewer than 5 points are
/// pooled (Cochran's rule). Each of the cells x cells cells is integrated with 16 x 16 midpoints.
template <class Draw, class Density>
ChiSquare chi_square(int points, int cells, Draw draw, Density density) {
    constexpr int kSub = 16;
    const double step = 1.0 / (cells * kSub);
    std::vector<double> expected(static_cast<size_t>(cells * cells) + 1), observed(expected.size());
    ChiSquare result;
    for (int i = 0; i < cells * kSub; ++i)
        for (int j = 0; j < cells * kSub; ++j) {
            const double mass = density(SquarePoint{(i + 0.5) * step, (j + 0.5) * step}) * step * step;
            expected[static_cast<size_t>(i / kSub * cells + j / kSub)] += points * mass;
            result.mass += mass;
        }
    expected.back() = points * std::max(0.0, 1 - result.mass);
    const auto cell = [&](double x) { return std::min(static_cast<int>(x * cells), cells - 1); };
    for (int n = 0; n < points; ++n) {
        const std::optional<SquarePoint> p = draw();
        ++(p ? observed[static_cast<size_t>(cell(p->a) * cells + cell(p->b))] : observed.back());
    }
    double pooled_expected = 0, pooled_observed = 0;
    const auto add = [&](double e, double o) { result.statistic += (o - e) * (o - e) / e, ++result.degrees; };
    for (size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= 5)
            add(expected[i], observed[i]);
        else
            pooled_expected += expected[i], pooled_observed += observed[i];
    }
    if (pooled_expected >= 1)
        add(pooled_expected, pooled_observed);
    else if (pooled_observed > 10)
        result.statistic = 1e9;  // points where the density has none
    result.degrees = std::max(1, result.degrees - 1);
    const boost::math::chi_squared distribution(result.degrees);
    result.p_value = boost::math::cdf(boost::math::complement(distribution, result.statistic));
    return result;
}
