// The linear least squares behind a factorisation, per channel:
//
//     minimise  sum over samples s of ( sum over factors j of  c_sj lookup_j(d x) - b_s )^2  +  x^T W R x
//
// x: all texels; d: a scale of each, and of the lookups c: both come from linearising; W: see `smoothness_weight`. Solved by conjugate gradients on the normal
// equations, of which no matrix is built: one pass over the samples both looks up and adds to texels. Chunks of samples add to sums of
// their own, so that results are the same bits for any thread count.
// Internal.
#pragma once

#include <burnish/factor/sample_lookups.h>

#include <Eigen/SparseCore>

namespace burnish {

struct BlendSystem {
    const SampleLookups& lookups;
    const Eigen::SparseMatrix<float, Eigen::RowMajor>& R;
    Colors c;  // samples * factors rows
    Colors b;  // samples
    Colors d;  // texels
};

/// The diagonal of the normal matrix without R, leaving out that a row may read a texel twice.
Colors sample_diagonal(const BlendSystem& system);

/// What rows of R are multiplied with: as much as the samples that read a texel count for, on average over its map.
Colors smoothness_weight(const SampleLookups& lookups, const Colors& sample_diagonal);

struct SolveLimits {
    int iterations;
    float tolerance;  // of the gradient's length (preconditioned), relative to that at the start
};

/// From x on. Channels that are zero everywhere stay as they are.
Colors solve(const BlendSystem& system, Colors x, const SolveLimits& limits);

}  // namespace burnish
