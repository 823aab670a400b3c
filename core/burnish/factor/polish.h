// Fits the product itself, as it is looked up: Gauss-Newton on the texels. Taking logarithms is linear and finds the factors at once, but
// it takes blends of logarithms for logarithms of blends, and counts ratios where differences or what a display shows may count.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/factor/blend_system.h>
#include <burnish/factor/factor_measure.h>
#include <burnish/factor/texel_unknowns.h>

namespace burnish {

struct Polish {
    std::span<const FactorSample> samples;
    const SampleLookups& lookups;
    const TexelUnknowns& unknowns;
    const Eigen::SparseMatrix<float, Eigen::RowMajor>& R;
    MeasuredResidual measure;

    /// The unknowns from x on; the error with what smoothness takes never rises.
    Colors operator()(Colors x, const Progress& progress) const;

private:
    using Sums = Eigen::Array<double, 1, 4>;
    Sums error(const Colors& x, const Colors& weight) const;
    BlendSystem linearised(const Colors& x) const;
    Colors taken(const Colors& x, const Colors& change, const Colors& weight, Sums& least) const;
};

}  // namespace burnish
