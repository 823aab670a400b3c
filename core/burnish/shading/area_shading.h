// Lamps sampled directly: the lobe's own values at a few nodes of the lamp, in place of its taps or to correct them.
//
// Taps see of a lamp what their Gaussians see, however sharp its edges; so their sum is as far from the truth as they are from the
// lobe. A lamp in a long tail, or one smaller than the gaps between the taps, shows it. There nodes do better:
//
//     N = sum over nodes k of  E_k f(wo, wi_k) cos_i,     R = the same of what the taps leave out, f cos_i - sum_j weight_j K_j
//
// E_k: what node k sends; K_j: the taps' Gaussians. How they go together depends on the lobe's tail and on the lamp; q and w fade from 1
// to 0 as the lamp's own nodes (area_nodes.h) spread out over the lobe:
//
//     Gaussian tail             L = (1 - q) (taps + w R) + q N: taps are nearly the lobe
//     long tail, even lamp      L = N, of nodes that gather at the lobe's peak (focused_nodes.h), for any width
//     long tail, picture        L = q N + (1 - q) N_focused of an even lamp, times the colour that the taps see
#pragma once

#include <burnish/light/light_chain.h>
#include <burnish/shading/tap_rays.h>

#include <vector>

namespace burnish {

/// What a pixel gets beside its taps.
struct DirectLight {
    Color3f radiance{0, 0, 0};
    float bend = 0;      // bound of its luminance's second derivative with the reflected direction, per radian^2
    float nearness = 0;  // sum of nearness * nearness_weight
    float nodes = 0;     // evaluated
};

/// One for each of pixels [begin, end) of a batch, whose taps are `taps`. Empty where no lamp is among the lights, else `kept` is set:
/// of each link of the chain, one after the other, what is still to be taken of each ray.
std::vector<DirectLight> direct_light(const LobeParameters& lobe, const LightChain& lights, const SurfaceBatch& batch,
                                      size_t begin, size_t end, const TapRays& taps, std::vector<float>& kept);

}  // namespace burnish
