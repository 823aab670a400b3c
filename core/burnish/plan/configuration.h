// What a plan chooses from: ways to integrate a lobe, each more exact and mostly dearer than the one before it in its family.
#pragma once

#include <burnish/sampling/estimator.h>

#include <compare>
#include <vector>

namespace burnish {

struct Configuration {
    EstimatorKind estimator = EstimatorKind::regular;
    int samples = 19;  // lookups a lobe; `factored`: 1, whatever the lobes; `reference`: 0, by the tolerance of the settings

    auto operator<=>(const Configuration&) const = default;
};

/// factored, fitted 1 to 16, regular 4 to 61, filtered_importance 16 to 2048: all that error and cost models know of.
const std::vector<Configuration>& configurations();

/// The configuration that tells most about all others under a light, for little: nineteen regular lookups.
inline constexpr Configuration kProbe{EstimatorKind::regular, 19};

/// One for all lobes; only for distant light and what can_be_factored.
inline constexpr Configuration kFactored{EstimatorKind::factored, 1};

/// The job's settings with this estimator and count.
EstimatorSettings with(EstimatorSettings settings, const Configuration& configuration);
/// Those of an estimator that errs elsewhere than kProbe, near the horizon above all, and is ready at once.
EstimatorSettings other_probe(EstimatorSettings settings);

}  // namespace burnish
