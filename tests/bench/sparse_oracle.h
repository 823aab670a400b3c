// What sparse shading could do at best if it knew the picture: the oracle that predictions are measured against.
#pragma once

#include <burnish/base/image.h>

namespace burnish {

/// Pixels that need shading when every tile of 16 x 16 takes the coarsest grid, of step 1, 2, 4, 8 or 16, whose bilinear
/// interpolation stays within `db` (display PSNR, over the tile's pixels in `mask`) of the picture itself.
size_t oracle_pixels(const Image& picture, const Image& mask, double db = 45);

/// As a display shows it: clamped and sRGB-encoded.
double encoded(double x);

}  // namespace burnish
