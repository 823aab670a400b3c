// A factorisation at one size of maps: the maps, the samples, and what fits one to the other.
#pragma once

#include <burnish/factor/factorise.h>
#include <burnish/factor/map_smoothness.h>
#include <burnish/factor/texel_unknowns.h>

namespace burnish {

struct FactorLevel {
    Factors factors;
    std::span<const FactorSample> samples;
    SampleLookups lookups;
    ColorRow mean;  // of the samples
    TexelUnknowns unknowns;
    Eigen::SparseMatrix<float, Eigen::RowMajor> R;

    FactorLevel(const Parametrization& parametrization, std::span<const FactorSample> samples, const FactorGuide& guide,
                const FactoriseSettings& settings, int terms = 1);

    void set_texels(const Colors& x) { unknowns.set_texels(factors, x); }
};

}  // namespace burnish
