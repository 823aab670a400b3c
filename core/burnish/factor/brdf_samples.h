// Samples of BRDFs to factor: at the directions of texels, so that maps are sampled evenly (Factor 4.2), or as somebody measured them.
#pragma once

#include <burnish/factor/factors.h>
#include <burnish/material/measured/measured_brdf.h>

#include <vector>

namespace burnish {

struct BrdfSampling {
    int size = 32;  // texels a side of the discs that directions are taken from: 32 makes some 400 000 pairs
    float least_cosine =
        0.02f;  // directions nearer to the horizon are left out: BRDFs go to extremes there, and nothing is seen
};

/// Of f(wi, wo). Throws Error(bad_argument) for sizes out of range, and for a parametrisation of something else.
std::vector<FactorSample> brdf_samples(const Parametrization& parametrization, const PairFunction& f,
                                       const BrdfSampling& sampling = {});

/// The pairs that were measured. Those of isotropic materials `turns` times, turned about the normal: measurements seldom do.
std::vector<FactorSample> measured_samples(const MeasuredBrdf& brdf, int turns = 8);

}  // namespace burnish
