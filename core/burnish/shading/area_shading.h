// Lamps sampled directly, where a lobe is smooth over them: its own values at the lamp's few nodes, in place of its taps.
//
// Taps see of a lamp what their Gaussians see, however sharp its edges; so their sum is as far from the truth as they are from the
// lobe. A lamp in a long tail, or one smaller than the gaps between the taps, shows it. There nodes do better:
//
//     L = (1 - q) taps  +  w sum over nodes k of  E_k (f(wo, wi_k) cos_i  -  (1 - q) sum over taps j of  weight_j K_j(wi_k))
//
// E_k: what node k sends; K_j: the taps' Gaussians. w and q fade from 1 to 0 as the nodes spread out over the lobe. Where both are 1 the
// nodes do all, and taps need not be looked up; where q has faded, they integrate what the taps leave out; where both are 0 they would
// miss the lobe's peak, and the taps do well alone.
#pragma once

#include <burnish/light/light_chain.h>
#include <burnish/material/parameters.h>
#include <burnish/surface/surface_batch.h>

#include <span>
#include <vector>

namespace burnish {

/// The taps of some pixels as rays, one after the other.
struct TapRaysView {
    std::span<const LightRay> rays;
    std::span<const Color3f> weights;
    std::span<const uint32_t> ends;  // of each pixel's rays
};

/// What a pixel gets beside its taps.
struct DirectLight {
    Color3f radiance{0, 0, 0};
    float bend = 0;      // bound of its luminance's second derivative with the reflected direction, per radian^2
    float nearness = 0;  // sum of luminance over distance, per scene unit
    float nodes = 0;     // evaluated
};

/// One a pixel. Empty where no lamp is among the lights, else `kept` is set: of each link of the chain, one after the other, what
/// is still to be taken of each ray.
std::vector<DirectLight> direct_light(const LobeParameters& lobe, const LightChain& lights, const SurfaceBatch& batch,
                                      const TapRaysView& taps, std::vector<float>& kept);

}  // namespace burnish
