// What a material reflects of distant light, as a function of normal and view: the samples that lighting is factored from.
//
//     L(n, wo) = integral over wi of  f(wo, wi) Li(wi) max(n . wi, 0)                                          (Factor 61)
//
// Directions are light axes and the environment's gain is left out, so that maps made from them serve the light however it is turned,
// scaled or tinted. Only isotropic materials have such a function: others depend on the tangent, too.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/factor/factors.h>
#include <burnish/light/environment.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/estimator.h>

#include <vector>

namespace burnish {

/// Which pairs there are. `uniform`: all of a grid (as the source has it); `projected`: drawn as often as they are seen, n . wo dn dwo of
/// whatever is convex, seen from all sides; no two of the same normal, so that maps are told everywhere.
enum class ViewWeight { uniform, projected };

struct LightingSampling {
    int size =
        26;  // texels a side of the two discs that a grid's normals and views are taken from: 26 makes 400 000 pairs, grid or not
    ViewWeight weight = ViewWeight::projected;
    EstimatorSettings estimator;
    bool suns = true;  // else the light without its bright discs, for shaders that add these themselves (disc_light.h)
};

/// The i-th pair of (n, wo) as they are seen: normals evenly all around, views by their cosine.
DirectionPair seen_pair(uint32_t i, uint32_t seed);

/// Throws Error(bad_argument) where `material` has no such function: an anisotropic lobe, or one that layers change.
void require_factorable(const Material& material);

/// Of pairs with n . wo > 0, in the same order for any thread count; their weights are 1. Progress under "lighting". Throws as
/// require_factorable; Error(cancelled).
std::vector<FactorSample> lighting_samples(const Material& material, const Environment& light, const LightingSampling& sampling,
                                           const Progress& progress = {});

/// Where most of the light comes from (Factor 66), suns included; light axes, unit. The z axis where it comes from everywhere.
Vec3f dominant_direction(const Environment& light);

}  // namespace burnish
