// The `fitted` estimator: a lobe as a few spherical Gaussians, each one lookup in the light's Gaussian stack.
//
// Where `regular` spreads equal lookups over the lobe, here directions, widths and weights are whatever fits the lobe best
// (gaussian_fit.h), for any model that can be evaluated, at some nodes of a tap table, in milliseconds for a round lobe; the
// other nodes and the pixels are interpolated. Four such lookups mostly do better than sixteen regular ones
// (docs/measured.md, which also says where not).
#pragma once

#include <burnish/light/gaussian_stack.h>
#include <burnish/shading/tap_table.h>

namespace burnish {

/// The table of a lobe that TapTable::covers, `taps` >= 1 lookups a pixel; levels are those of `light`.
TapTable fitted_table(const LobeParameters& lobe, int taps, const GaussianStack& light);

}  // namespace burnish
