// A lobe on samples: one dispatch a batch, in the frame that its rotation turns.
#pragma once

#include <burnish/fit/search/transfer_samples.h>
#include <burnish/material/lobe.h>

namespace burnish {

/// Calls `use(j, p)` with the lobe's p, strength and tint left out, for the samples [begin, end).
template <class Use>
void for_each_transfer(const LobeParameters& lobe, const TransferSamples& samples, size_t begin, size_t end, const Use& use) {
    const float c = std::cos(lobe.rotation), s = std::sin(lobe.rotation);
    const auto turned = [&](const Vec3f& w) { return Vec3f(c * w.x + s * w.y, c * w.y - s * w.x, w.z); };
    visit_lobe(lobe, [&](const auto& model) {
        for (size_t j = begin; j < end; ++j)
            use(j, model.eval(turned(samples.wo[j]), turned(samples.wi[j])) * samples.cosine[j]);
    });
}

}  // namespace burnish
