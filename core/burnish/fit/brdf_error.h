// How far a model is from a measurement, in one number: the error of Bandwidth V.5.3.
//
//     E = sqrt(integral (m - f)^2 cos_i cos_o dwi dwo) / greatest albedo of m
//
// over both hemispheres, as far as the measurement is trusted (brdf_grid.h). For a grey diffuse material E is the relative error of kd;
// for a polished one, any misfit of the peak counts by how much brighter the peak is, and E is easily above 1.
#pragma once

#include <burnish/fit/brdf_grid.h>
#include <burnish/material/parameters.h>

namespace burnish {

struct BrdfError {
    Channels absolute;  // not normalised
    Channels albedo;    // greatest of the measurement

    /// One channel by its own albedo, 0 where nothing is reflected.
    double channel(int c) const { return albedo[c] > 0 ? absolute[c] / albedo[c] : 0; }
    double worst_channel() const;
    /// Root mean square of the channels by the greatest albedo of them all.
    double overall() const;
};

/// Of errors that are known channel by channel.
BrdfError brdf_error(const BrdfGrid& grid, const Channels& absolute);
/// Of any material, evaluated in float.
BrdfError brdf_error(const BrdfGrid& grid, const Material& material);

}  // namespace burnish
