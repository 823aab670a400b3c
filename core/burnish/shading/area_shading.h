// What a lobe's few taps leave out under area lights: the difference between lobe and taps, integrated over the lamp itself.
//
// Each tap sees its Gaussian's share of a lamp, however sharp the lamp's edges; so their sum is as far from the truth as the taps
// are from the lobe, and a lamp in a long tail, or one as small as the gaps between the taps, shows it. There the lobe is smooth
// over the lamp, and the lamp's own few nodes integrate what is missing:
//
//     L += w  sum over nodes k of  power_k cos_k / r_k^2  (f(wo, wi_k) cos_i  -  sum over taps j of  weight_j K_j(wi_k))
//
// w fades from 1 to 0 where nodes would lie too far apart for the lobe to be resolved: there the taps do well alone.
#pragma once

#include <burnish/light/light_chain.h>
#include <burnish/shading/tap_rays.h>

#include <span>

namespace burnish {

/// Adds to the overlay of pixels [begin, end) of a batch, whose taps are `taps`; to `samples`, the nodes that were evaluated.
void add_area_residuals(const LobeParameters& lobe, const LightChain& lights, const SurfaceBatch& batch, size_t begin,
                        size_t end, const TapRays& taps, std::span<Color3f> overlay, std::span<float> samples);

}  // namespace burnish
