// The `filtered_importance` estimator (Colbert & Krivanek 2007): few importance samples, each lookup filtered over the solid
// angle 1 / (n pdf) it stands for. All pixels share one Hammersley set, so the image is free of noise.
#pragma once

#include <burnish/material/lobe.h>
#include <burnish/sampling/sequence.h>
#include <burnish/shading/shading_point.h>
#include <burnish/shading/tap.h>

#include <span>

namespace burnish {

/// wi, or the direction just above the horizon where it is below: what a tap without weight takes its level from.
inline Vec3f lifted(const Vec3f& wi, float side_sign) {
    constexpr float kLowest = 2 * kMinCosine;
    return wi.z * side_sign >= kLowest ? wi : Vec3f(wi.x, wi.y, kLowest * side_sign).normalized();
}

/// Writes one tap per sample, taps.size() samples. `level_of(Omega)` gives the level that filters over Omega steradian.
template <class LobeType, class LevelOf>
void importance_taps(const LobeType& lobe, const ShadingPoint& point, const LevelOf& level_of, std::span<Tap> taps) {
    const uint32_t samples = static_cast<uint32_t>(taps.size());
    for (uint32_t i = 0; i < samples; ++i) {
        const Vec3f wi = lobe.sample(point.wo, hammersley(i, samples)), above = lifted(wi, lobe.side_sign);
        const float cos_i = wi.z * lobe.side_sign, pdf = lobe.pdf(point.wo, above);
        const float share = std::min(1 / (static_cast<float>(samples) * pdf), 4 * kPi);  // the whole sphere at the most
        taps[i] = {wi, level_of(share), Color3f(0, 0, 0)};
        if (cos_i > 0 && pdf > 0) taps[i].weight = lobe.eval(point.wo, wi) * (cos_i * share);
    }
}

}  // namespace burnish
