// What holds maps together where samples do not: every texel near the mean of its neighbours (the Laplacian of Factor 36, 37), and what
// lies beyond the rim of one of two discs equal to what it repeats of the other.
// Internal.
#pragma once

#include <burnish/factor/sample_lookups.h>

#include <Eigen/SparseCore>

namespace burnish {

/// L^T L of the rows L that should be zero, over all texels of `factors` in the order of SampleLookups. A texel's diagonal is about 1
/// for its Laplacian times `smoothness` squared, and 1 for its seam.
Eigen::SparseMatrix<float, Eigen::RowMajor> map_smoothness(const Factors& factors, float smoothness);

}  // namespace burnish
