// What a user should know of a fit, in plain words.
#pragma once

#include <burnish/fit/search/lobe_mixture_fit.h>

#include <string>

namespace burnish {

/// Of one side, whose lobes are number `first` + 1 and on of the material: lobes that did not pay, light that no lobe explains, light
/// thrown back, numbers that the table does not tell apart.
std::vector<std::string> side_notes(const TransferSamples& samples, Side side, const SideFit& fit, size_t first);

}  // namespace burnish
