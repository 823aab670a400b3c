// A lobe's shape on samples: the two functions that its p is linear in once its shape is fixed.
//
// Schlick's Fresnel is linear in r0, so ks F(r0) is a mixture of F at both ends of r0's range with weights >= 0: the search over ks
// and r0 that would cost n^2 evaluations a shape is a small problem of absolute errors instead (absolute_fit.h).
#pragma once

#include <burnish/fit/search/lobe_space.h>
#include <burnish/fit/search/transfer_samples.h>

namespace burnish {

/// p of the lobe at strength 1 with r0 at the lower and upper end of its range.
struct LobeBasis {
    std::vector<float> low, high;
};

/// For the samples [begin, end).
void lobe_basis(const LobeParameters& lobe, const NumberRange& r0, const TransferSamples& samples, size_t begin, size_t end,
                LobeBasis& basis);

/// Strength and r0 of what weighs the basis with `low` and `high`.
void set_weights(float low, float high, const LobeSpace& space, LobeParameters& lobe);

}  // namespace burnish
