// How much of a fit's error no model can explain: the table's own noise.
#pragma once

#include <burnish/fit/search/transfer_samples.h>

namespace burnish {

/// The error of a perfect model, in the units of Walkthrough 3.7, from `model` (grey p) that need not be perfect: what a residual
/// differs by from the one of the nearest outgoing direction is noise, as models err alike there. Too high where the table is
/// coarser than a lobe.
double noise_level(const TransferSamples& samples, const std::vector<float>& model);

}  // namespace burnish
