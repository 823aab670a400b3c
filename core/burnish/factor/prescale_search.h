// The prescale factors and the scale that lose least to 8 bits, where the source leaves both to the eye (Factor 4.3.1).
#pragma once

#include <burnish/factor/quantise.h>

#include <span>

namespace burnish {

/// Of each term: chooses the weights, where `settings` have none, and z, where they have no white: those of the least product of average
/// relative and RMS error against the samples, of several terms against the term's own share of them, so that neither dark nor bright
/// is given up for little. The rest stays as it is. Throws Error(bad_argument) without samples, and as `quantise`.
std::vector<QuantiseSettings> best_prescale(const Factors& factors, const QuantiseSettings& settings,
                                            std::span<const FactorSample> samples);

}  // namespace burnish
