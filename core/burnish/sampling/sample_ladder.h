// How many lookups a pixel gets, from how much the light varies inside its lobe.
//
// With a fixed number of lookups to spend on an image, its squared error is least where each pixel gets as many as its standard
// deviation asks for, N ~ sigma (Neyman's allocation); relative to the pixel's mean, as the eye has it. Counts come from a ladder,
// as each of them is a table of its own.
#pragma once

#include <burnish/sampling/estimator.h>

#include <cstddef>
#include <vector>

namespace burnish {

inline constexpr int kFewestLookups = 4;  // of the ladder: they also make the prediction

/// Numbers of lookups, ascending: `most`, and each two thirds of the next down to kFewestLookups. most >= 1; not longer than
/// needed: {most} where that is no more than kFewestLookups.
std::vector<int> sample_ladder(int most);

/// Standard deviation of one importance sample of the lobe over its mean, from which on a pixel gets all lookups; by measurement
/// (docs/measured.md).
float full_deviation(EstimatorKind kind);

/// The lowest entry of the ladder that has, within a sixth, deviation / full times as many as the last.
size_t ladder_rung(const std::vector<int>& ladder, float deviation, float full);

}  // namespace burnish
