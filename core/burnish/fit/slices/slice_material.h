// From the numbers of three channels to a material that burnish shows. Internal.
#pragma once

#include <burnish/fit/slices/channel_problem.h>
#include <burnish/material/parameters.h>

namespace burnish {

/// One channel as a shape family fitted it.
struct FittedChannel {
    const ShapeFamily* family;  // sgd may have its masking free in one channel and not in another
    ChannelFit fit;
};

/// What a + e of a lobe of this shape is for strength 1 of its model.
double ks_unit(const ShapeFamily& family, Shape shape);

/// sgd has numbers of its own for each channel and so one lobe for all; other models get a lobe for each channel, tinted red, green
/// or blue. Lobes are in the order of their widths, narrow first, and ones without strength are left out.
Material slice_material(const std::array<FittedChannel, 3>& channels);

}  // namespace burnish
