// Pixel filters: how a renderer weighs what it samples around the centre of a pixel. Finer samples become pixels by the weights
// of the filter that the beauty was rendered with, so that overlay and beauty have the same edges.
#pragma once

#include <burnish/input/renderer.h>

#include <string_view>
#include <vector>

namespace burnish {

/// `automatic`: the renderer's default, where it is known, else `box`.
enum class FilterKind { automatic, box, triangle, gaussian, blackman_harris };

/// Filters in x and y are the same and multiply. Widths mean what they do in renderers: box, triangle and Gaussian end half a
/// width away from the centre, where the Gaussian is two standard deviations out; Cycles' Blackman-Harris a whole width away.
struct PixelFilter {
    FilterKind kind = FilterKind::automatic;
    float width = 0;  // pixels; 0 = the usual one of the kind: 1, 2, 2, 1.5

    /// Distance from the centre of a pixel to where the filter ends, in pixels.
    double reach() const;
    /// Share of the filter left of `x` pixels from the centre of the pixel, in [0, 1].
    double share_below(double x) const;
};

std::string_view filter_name(FilterKind kind);

/// The filter with nothing left open.
PixelFilter settled(PixelFilter filter, Renderer renderer);

/// The samples in a row that a pixel is made of, `factor` of which are its own.
struct FilterTaps {
    int reach = 0;               // samples taken on either side of the pixel's own
    std::vector<float> weights;  // from the leftmost on; sum 1
};

/// A sample weighs what the filter has over the part of a pixel it stands for. `filter` must be settled.
FilterTaps filter_taps(const PixelFilter& filter, int factor);

}  // namespace burnish
