// The overlay into the picture, pixel by pixel, with the widest vectors the processor has.
#pragma once

#include <burnish/base/types.h>

#include <cstddef>

namespace burnish {

/// Pixels in a row. Colours have three channels but `beauty`, which has four.
struct OverlayRow {
    float* overlay;                    // in: as shaded; out: as added
    const float* old_overlay;          // taken off the overlay; or null
    const float *base, *removed;       // what the overlay goes over, and what is taken out of that, or null
    const float *coverage, *replaced;  // one channel: shares of the overlay, and of what is taken out
    const float *mask, *alpha;         // one channel; may be null, which is 1
    float* beauty;                     // out
};

/// overlay <- (overlay - old) scale coverage mask and beauty <- base + overlay - removed replaced mask, for `count` pixels; a mask
/// that is not finite is 0. The same bits on every processor.
void add_overlay(const OverlayRow& row, const Color3f& tint, float gain, size_t count);

}  // namespace burnish
