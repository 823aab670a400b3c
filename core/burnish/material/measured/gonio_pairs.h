// From the rows of a goniometer's file to pairs of directions.
#pragma once

#include <burnish/material/measured/measured_brdf.h>

#include <optional>

namespace burnish {

/// Angles in radians, theta from the normal, theta_o > pi/2 below the surface; `value` is f in 1/sr, or f |cos theta_o|.
struct GonioRow {
    double theta_i, phi_i, theta_o, phi_o;
    Color3f value;
};

/// Nothing for a row whose directions are within half a degree of the horizon, where no goniometer sees the sample. Negative
/// values, the noise around black, become 0. `transfer`: the value is the transfer probability f |cos theta_o|.
std::optional<BrdfSample> gonio_sample(const GonioRow& row, bool transfer);

}  // namespace burnish
