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
    const float *coverage, *replaced;  // one channel: shares of the pixel, of the overlay and of what is removed
    const float *mask, *alpha;         // one channel; may be null, which is 1
    float* beauty;                     // out
};

/// overlay <- (overlay - old) scale w and beauty <- base + overlay - removed v, for `count` pixels; w = coverage * mask, v = replaced * mask,
/// 0 where the mask is not finite. The same bits on every processor.
void add_overlay(const OverlayRow& row, const Color3f& tint, float gain, size_t count);

}  // namespace burnish
