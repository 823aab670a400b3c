// How finer AOVs lie over a frame: every pixel of the frame is factor x factor samples of theirs.
#pragma once

#include <burnish/input/frame.h>

namespace burnish {

struct SampleGrid {
    int factor = 1;
    int x = 0, y = 0;  // sample that is the upper left one of the frame's pixel (0, 0)

    int sample_count() const { return factor * factor; }
    /// The samples of these pixels, whether the finer frame has them or not.
    Window samples_of(const Window& pixels) const;
};

/// Display windows say what belongs to what. Throws Error(size_mismatch) when the finer one is not the same whole multiple of the
/// frame's across and down.
SampleGrid sample_grid(const AovFrame& frame, const AovFrame& fine);

/// Data windows may differ, by overscan or because a renderer cuts off empty borders: where the finer frame has no pixels there
/// are no surfaces. Throws Error(size_mismatch) when whole frames have nothing in common.
void check_samples(const SampleGrid& grid, const AovFrame& frame, const AovFrame& fine);

}  // namespace burnish
