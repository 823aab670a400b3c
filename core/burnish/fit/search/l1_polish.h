// All numbers of a mixture at once, from a good start to the bottom of the sum of absolute errors; and how well they are known there.
//
// Iteratively re-weighted least squares in Levenberg & Marquardt's form: residuals weigh w / max(|r|, epsilon), with epsilon a
// shrinking share of what residuals are like where p is as large. A step counts only if it lowers the true error, so the result is
// never worse than the start.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/fit/search/lobe_mixture.h>

namespace burnish {

/// The mixture moved downhill, `error` included. The same for any number of threads; throws Error(cancelled).
LobeMixture polished(LobeMixture mixture, const TransferSamples& samples, const std::vector<float>& target,
                     const Progress& progress);

/// Standard error of each of `unknowns(mixture)`, in the number's own units (of its logarithm for numbers searched in ratios), from how
/// far residuals scatter; infinite for one that changes nothing. Numbers that only count together have large ones.
std::vector<double> standard_errors(const LobeMixture& mixture, const TransferSamples& samples,
                                    const std::vector<float>& target);

}  // namespace burnish
