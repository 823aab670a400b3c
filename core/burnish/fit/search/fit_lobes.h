// Lobes of any model fitted to a measurement: the search of Walkthrough 3.4, for reflection and transmission, in colour.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/fit/fit_settings.h>
#include <burnish/material/measured/measured_brdf.h>

#include <span>

namespace burnish {

/// The material of least L1 error (Walkthrough 3.7) with no more lobes than the data needs, of settings.model or, where there is none,
/// of whichever of kurt, beckmann and ggx is best for its number of parameters. Grey data give shape and strength; a table in colour
/// tints them. Same result for any number of threads. Throws Error(bad_argument) for bounds that cannot be and for a table without
/// a valid sample, Error(cancelled). `normalised_l2` only of dense isotropic tables.
FitResult fit_lobes(const MeasuredBrdf& measured, const FitSettings& settings, const Progress& progress);

/// The same from pairs. `isotropic`: lobes are round unless bounds name "mx" or "my".
FitResult fit_lobes(std::span<const BrdfSample> samples, bool isotropic, const FitSettings& settings, const Progress& progress);

/// The error of any material, both sides together, mean of the channels (Walkthrough 3.7).
double l1_error(const MeasuredBrdf& measured, const Material& material);

}  // namespace burnish
