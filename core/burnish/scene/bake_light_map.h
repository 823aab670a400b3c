// A light map for a scene that has none: the light of its own lamps, directly and over matte bounces.
//
// Lamps are drawn by area, with shadow rays. Bounces are passes: each gathers what the pass before left on the surfaces, with few
// rays a texel, interleaved over blocks of 4 x 4 texels and averaged within them as in light_field.h.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/scene/surface_light.h>

#include <vector>

namespace burnish {

struct LightMapSettings {
    int size = 1024;         // texels along an edge
    int lamp_samples = 16;   // shadow rays a texel
    int bounce_samples = 8;  // rays a texel and bounce
    int bounces = 3;
    std::vector<int> hidden = {};  // indices into Scene::objects that cast no shadow: panes of glass
};

/// Irradiance / pi on the fronts, RGB, over texture coordinates that lay_out_atlas made for maps of this size. Surfaces that emit
/// are the lamps. Same bits for any thread count. Throws Error(bad_argument) when nothing in the scene emits.
Image bake_light_map(const Tracer& tracer, const LightMapSettings& settings, const Progress& progress);

}  // namespace burnish
