// Fills the pixels that were not shaded, from the corners of the cells they lie in.
//
// Coarse to fine, each step halves the grid: a new grid point is the mean of its two neighbours along a side, or of the sides above
// and below it, unless it was shaded. What a smaller neighbouring cell shades on a common side counts for both, so there is no
// crack between cells. Cells hold one material's valid pixels only (frequency/cell_turning.h), so nothing leaks over edges.
#pragma once

#include <burnish/base/image.h>
#include <burnish/shading/shading_plan.h>

namespace burnish {

/// Corners of the plan's cells hold their values; the other pixels of cells of two pixels and more get theirs. Bit-identical for
/// any thread count.
void upsample(const ShadingPlan& plan, Image& rgb);

}  // namespace burnish
