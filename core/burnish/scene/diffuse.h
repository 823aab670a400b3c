// The view-independent part of a picture: albedo, direct and bounced light, sky behind.
//
// Light is gathered once a pixel with few samples, interleaved: the 16 pixels of any 4 x 4 block use the 16 runs of one
// low-discrepancy set. Colour samples then average the 4 x 4 pixels around them that lie on the same smooth surface, so each
// has the whole set. Source: Keller & Heidrich 2001, "Interleaved Sampling", with its discontinuity test.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/input/frame.h>
#include <burnish/scene/irradiance.h>

namespace burnish {

struct DiffuseSettings {
    int antialias = 2;       // antialias^2 colour samples a pixel
    int bounce_samples = 2;  // rays a pixel that look for light from other objects, a power of two; 0 = direct light only
};

/// Adds to a frame of trace_gbuffer: diffuse_albedo, diffuse_direct and diffuse_indirect (irradiance / pi, not multiplied by
/// the albedo), alpha (1, the sky is opaque) and beauty = albedo * (direct + indirect) + sky; linear RGB, box filtered.
/// Throws Error(bad_argument) as IrradianceGatherer does. Same bits for any thread count.
void add_diffuse(AovFrame& frame, const Tracer& tracer, const DistantLight& light, const DiffuseSettings& settings,
                 const Progress& progress);

}  // namespace burnish
