// Two older ways to factor a BRDF, on the regular grid of a parametrisation with two maps: the matrix of its values at all pairs of
// texels as a sum of products of a column and a row (Factor 3.1.1, equation 18). Pairs below the surface have no value; products are
// fitted to the others.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/factor/factors.h>

namespace burnish {

enum class Decomposition {
    svd,  // the least sum of squares there is for so many terms: the singular value decomposition, where no value is missing
    normalised,  // the mean of all rows, scaled by the mean size of each; then the same again of what is left: quicker, less exact
};

struct DecomposeSettings {
    Decomposition method = Decomposition::svd;
    int size = 64;  // texels a side of a disc
    int terms = 1;
    float least_cosine = 0.02f;  // pairs nearer to the horizon count as below the surface
};

/// Terms after the first have signs. Throws Error(bad_argument) for a parametrisation without a grid of two maps, for sizes and terms out
/// of range, and for values that are not finite.
Factors decompose(const Parametrization& parametrization, const PairFunction& f, const DecomposeSettings& settings = {},
                  const Progress& progress = {});

}  // namespace burnish
