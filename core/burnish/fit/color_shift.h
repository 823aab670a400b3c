// Whether a material's colour changes with the angle, as that of interference pigments does: no lobe of one tint shows that.
#pragma once

#include <burnish/material/measured/measured_brdf.h>
#include <burnish/material/parameters.h>

#include <span>

namespace burnish {

/// Share of the light to which the fit gives another colour, in [0, 1]: half of sum |c_data - c_fit| over the channels' shares c of
/// a pair, mean over the pairs by their light. The brightest hundredth of the pairs does not count: highlights would hide the rest.
/// 0 without light.
double color_shift(std::span<const BrdfSample> samples, const Material& fit);

/// Above it colours are off for the eye: 0.01 to 0.03 for lacquers of one colour, 0.26 for one that changes it.
inline constexpr double kVisibleColorShift = 0.15;

}  // namespace burnish
