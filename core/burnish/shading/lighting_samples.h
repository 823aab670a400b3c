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

/// What a pair counts for. `uniform`: all the same (as the source has it); `projected`: as much as it is seen, n . wo dn dwo of
/// whatever is convex, seen from all sides.
enum class ViewWeight { uniform, projected };

struct LightingSampling {
    int size = 26;  // texels a side of the two discs that normals and views are taken from: 26 makes 400 000 pairs
    ViewWeight weight = ViewWeight::projected;
    EstimatorSettings estimator;
    bool suns = true;  // else the light without its bright discs, for shaders that add these themselves (disc_light.h)
};

/// Throws Error(bad_argument) where `material` has no such function: an anisotropic lobe, or one that layers change.
void require_factorable(const Material& material);

/// All pairs of texels with n . wo > 0, in the same order for any thread count. Progress under "lighting". Throws as
/// require_factorable; Error(cancelled).
std::vector<FactorSample> lighting_samples(const Material& material, const Environment& light, const LightingSampling& sampling,
                                           const Progress& progress = {});

/// Where most of the light comes from (Factor 66), suns included; light axes, unit. The z axis where it comes from everywhere.
Vec3f dominant_direction(const Environment& light);

}  // namespace burnish
