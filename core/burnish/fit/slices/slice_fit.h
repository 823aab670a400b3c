// Microfacet models fitted to a measurement by two slices of it, channel by channel, then to all of it: sgd, beckmann, ggx and abc.
//
//     slices    theta_d = 0 for kd and the shape, theta_h = 0 for strength and Fresnel: Bandwidth V.4.2
//     polish    all cells, from there and from a scan of all shapes; the lower error of V.5.3 is kept
//     masking   of sgd: lambda, c and k of its own instead of Smith's, where that lowers the error by 2 %
//     lobes     a second one where it pays: where error times numbers falls, of sgd where it leaves less than 6/11 of the error
//
// All models have the same freedom, a width and a generalised Schlick Fresnel (r0, f1) per channel. Data in half and difference angles
// is isotropic and of the upper side.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/fit/brdf_error.h>
#include <burnish/fit/fit_settings.h>

namespace burnish {

class MeasuredBrdf;

/// A fit and its error of V.5.3, in double, per channel.
struct SliceFit {
    FitResult result;
    BrdfError error;
    BrdfError slices;    // of the two slices alone
    BrdfError one_lobe;  // before a second lobe was tried
};

/// settings.model: sgd where there is none. At most two lobes; bounds of kd, ks, r0, f1 and the numbers of the shape (alpha, p; m; B, C),
/// for all lobes and channels alike. Same result for any number of threads. Throws Error(bad_argument) for other models and bounds and
/// for data without a trusted cell; Error(cancelled).
SliceFit fit_slices(const BrdfGrid& grid, const FitSettings& settings, const Progress& progress);

/// Of a table, on the grid of its cells: every theta_h and theta_d, every fifth phi_d.
SliceFit fit_slices(const MeasuredBrdf& measured, const FitSettings& settings, const Progress& progress);

}  // namespace burnish
