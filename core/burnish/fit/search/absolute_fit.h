// Two factors that fit a target best in the sum of absolute errors, exactly.
//
// The error is convex and piecewise linear in (s, t). Its minimum is a vertex where two samples are met exactly, and a vertex is
// the minimum once neither of its two edges leads down. So: go along an edge (one sample stays exact) to the weighted median of
// where the others become exact, which swaps one sample of the pair, until an edge leads nowhere.
// Source: Bloomfield & Steiger 1980, "Least absolute deviations curve-fitting", for two unknowns.
#pragma once

#include <burnish/fit/search/weighted_median.h>

namespace burnish {

/// Samples to fit to, all of one length. `weight` is each sample's share of the error.
struct AbsoluteProblem {
    std::span<const float> target, first, second, weight;
};

struct AbsoluteFit {
    float first = 0, second = 0;  // factors, >= 0
    double error = 0;             // sum weight |target - first a - second b|
};

/// What `fit_absolute` works in, kept from one call to the next.
struct AbsoluteScratch {
    std::vector<WeightedValue> quotients;
    std::vector<float> residual, direction;
};

/// The factors >= 0, their sum in [min_sum, max_sum], of least error. Bases must be >= 0; one may be 0 or a multiple of the other.
AbsoluteFit fit_absolute(const AbsoluteProblem& problem, float min_sum, float max_sum, AbsoluteScratch& scratch);

}  // namespace burnish
