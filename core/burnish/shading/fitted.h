// The `fitted` estimator: a lobe as a few spherical Gaussians, each one lookup in the light's Gaussian stack.
//
// Where `regular` spreads equal lookups over the lobe, here directions, widths and weights are whatever fits the lobe best
// (gaussian_fit.h), for any model that can be evaluated, at some nodes of a tap table, in milliseconds for a round lobe; the
// other nodes and the pixels are interpolated. Four such lookups mostly do better than sixteen regular ones
// (docs/measured.md, which also says where not).
#pragma once

#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/sampling/estimator.h>
#include <burnish/shading/tap_table.h>

#include <functional>

namespace burnish {

/// Whether `fitted` shades this lobe, not `regular`. Fits cannot be made for every pixel, as anisotropy from a layer would need;
/// and nineteen regular lookups follow a very long lobe with a long tail better than a few Gaussians, so those are fitted only
/// where a number of lookups is asked for.
bool is_fitted(const LobeParameters& lobe, const EstimatorSettings& settings);

/// The settings that shade a lobe in the end: `fitted` or `regular` in its place, and the number of lookups.
EstimatorSettings settled(const LobeParameters& lobe, EstimatorSettings settings);

/// The table of a lobe that TapTable::covers, `taps` >= 1 lookups a pixel. level_of: what a Gaussian of this width, radian, is
/// called in the table.
TapTable fitted_table(const LobeParameters& lobe, int taps, const std::function<float(float sigma)>& level_of);

/// How many fits of one view fitted_table makes for a lobe.
int fit_count(const LobeParameters& lobe);

/// With the levels of a stack.
inline TapTable fitted_table(const LobeParameters& lobe, int taps, const GaussianStack& light) {
    return fitted_table(lobe, taps, [&](float sigma) { return light.level(sigma); });
}

}  // namespace burnish
