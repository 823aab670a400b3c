// From a measurement to a material of a few numbers, with its error known.
//
// Dense isotropic tables are fitted slice by slice (slices/slice_fit.h), everything else by search over all pairs (search/fit_lobes.h).
#pragma once

#include <burnish/base/progress.h>
#include <burnish/fit/fit_settings.h>
#include <burnish/material/measured/measured_brdf.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace burnish {

/// The fits that were tried, in the order of their trying, and which of them to take.
struct FitComparison {
    std::vector<FitResult> tried;
    size_t chosen = 0;

    const FitResult& best() const { return tried[chosen]; }
};

/// With settings.model that model alone, else the ones that may suit the data; of those the one with the fewest numbers whose
/// error more numbers would not lower by enough. Throws Error(bad_argument) for bounds of unknown parameters and for data without
/// a valid pair; Error(cancelled).
FitComparison fit_material(const MeasuredBrdf& data, const FitSettings& settings, const Progress& progress);

/// What to keep of a fit: material, errors, what else was tried, residuals by angle, and curves of data and fit (fit_curves.h).
nlohmann::json fit_report(const MeasuredBrdf& data, const FitComparison& comparison);

}  // namespace burnish
