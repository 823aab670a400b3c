// Where in an image which wavelet bands are: the strength of the coefficients around each cell of a band.
//
// The wavelets are those of daubechies.h, but each step's are placed at all samples that it is given, not at every other one:
// a wave then has the same strength wherever its crests are. Only what is low both ways is thinned out for the next step.
// A coefficient counts by its share in the image's values, not by its energy (which grows with the wavelet's area), so that
// bands compare at a point: an edge is equally strong in all of them.
#pragma once

#include <burnish/base/image.h>

#include <vector>

namespace burnish {

/// What becomes of the squared coefficients around a cell: their weighted mean, or the largest.
enum class BandGather { mean, largest };

struct BandMaps {
    std::vector<Image> bands;  // finest first; band k has cells of 2^(k+1) texels
    Image below;               // variation of what is low in all bands, from a cell to those around it; cells of the last band
    Image level;               // its value

    int count() const { return static_cast<int>(bands.size()); }
};

/// Of a one-channel image, its sides multiples of 2^bands; indices wrap around.
BandMaps band_maps(const Image& image, int bands, BandGather gather);

}  // namespace burnish
