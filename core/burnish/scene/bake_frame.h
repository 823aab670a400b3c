// The light of a scene's surfaces as a camera sees it: what a renderer would call the diffuse passes of the frame.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/frame.h>
#include <burnish/scene/surface_light.h>
#include <burnish/scene/view.h>

namespace burnish {

enum class LightParts { together, apart };

/// Adds beauty (linear RGB, premultiplied) and alpha (the share of the pixel that sees a surface) to a frame that trace_gbuffer
/// made of the same view; `apart` also diffuse_albedo and irradiance (E, not divided by pi), both means over the surfaces in the
/// pixel. `samples` rays a pixel, box filtered, each reading the light as wide as its share of the pixel. Same bits for any thread
/// count.
void add_seen_light(AovFrame& frame, const Tracer& tracer, const View& view, const SurfaceLight& light, int samples,
                    LightParts parts, const Progress& progress);

}  // namespace burnish
