// Weighted sums over the same texels of all six faces, with the widest vectors that pay: six independent sums keep the
// processor busy, and a weight is made once for all of them.
#pragma once

#include <burnish/light/filter/cube_level.h>

#include <span>

namespace burnish {

using SixTexels = float[6][4];

/// Texels (x, y), (x + 1, y), ... of a face, whichever of the six.
struct TexelRun {
    int x, y, count;
};

/// Whether columns and rows are counted from the other end.
struct Mirror {
    bool x, y;
};

/// Adds to total[face] the texels of `runs`, mirrored, times `weights`: one a texel, run by run. Runs may hold border texels.
void add_runs(const CubeLevel& level, std::span<const TexelRun> runs, Mirror mirror, const float* weights, SixTexels& total);

}  // namespace burnish
