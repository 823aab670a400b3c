// How far a factored function is from samples of what it stands for, as Factor 5.7 tells it.
#pragma once

#include <burnish/factor/factors.h>

#include <span>

namespace burnish {

/// Over samples and channels alike, whatever samples weigh. Relative: to the sample and `bias`; where that is 0, there is none.
struct FactorError {
    double average_absolute = 0, max_absolute = 0;
    double average_relative = 0, max_relative = 0;
    double rms = 0;
};

/// `bias`: of the mean of all samples, added to what errors are relative to, for functions that all but vanish somewhere.
FactorError factor_error(const PairFunction& function, std::span<const FactorSample> samples, float bias = 0);

}  // namespace burnish
