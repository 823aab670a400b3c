// Sightings: which world point each pixel sees, sampled evenly from a position layer. What cameras are fitted to and
// checked against.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>
#include <burnish/input/row_strips.h>

#include <vector>

namespace burnish {

/// Scene units; renderers write 1e10 and more in position and depth where nothing was hit.
inline constexpr float kFarthest = 1e9f;

struct Sighting {
    size_t pixel;       // flat index into the layer
    Imath::V2d screen;  // of the pixel's middle, [-1, 1]^2 over the display window, y up
    Imath::V3d point;   // world space
};

/// True when `p` (3 floats) can be a surface point: finite, nearer than kFarthest and not the (0, 0, 0) renderers leave where
/// nothing was hit.
bool is_hit(const float* p);

/// At most `wanted` sightings, spread evenly over the pixels whose four neighbours are hits too: filtered position layers
/// mix surface and background at silhouettes. `valid` (1 channel, > 0 is valid) may be null. `rows`: which of the frame the
/// layers hold. Same input, same sightings.
std::vector<Sighting> sample_sightings(const Image& position, const Image* valid, const RowStrips& rows, const Window& display,
                                       size_t wanted);

}  // namespace burnish
