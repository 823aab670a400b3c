// How far a factored function is from samples of what it stands for, as Factor 5.7 tells it.
#pragma once

#include <burnish/factor/factors.h>

#include <functional>
#include <span>

namespace burnish {

/// Over samples and channels alike, whatever samples weigh. Relative: to the sample; where that is 0, there is no relative error.
struct FactorError {
    double average_absolute = 0, max_absolute = 0;
    double average_relative = 0, max_relative = 0;
    double rms = 0;
};

/// `function` is called from several threads.
FactorError factor_error(const std::function<Color3f(const DirectionPair&)>& function, std::span<const FactorSample> samples);

}  // namespace burnish
