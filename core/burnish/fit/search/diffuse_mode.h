// kd from what most of a table shows: away from its lobes a material reflects kd / pi, so that is the commonest value.
//
// The histogram is over log f, smoothed, as measurements scatter in ratio; its mode is refined to the median of the values around it.
// A table without a diffuse part has no such value: its lobes' slopes cover many decades evenly, with much of the table below any
// of them, where a diffuse part would be a floor.
// Source: Walkthrough 3.4.1.
#pragma once

#include <burnish/fit/search/transfer_samples.h>

namespace burnish {

/// kd of each channel, in [0, 1]; 0 where there is no diffuse part to be seen.
Color3f diffuse_mode(const TransferSamples& samples);

}  // namespace burnish
