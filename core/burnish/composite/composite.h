// The overlay into the picture: diffuse or beauty plus overlay, with the pixel's coverage, gain, tint and mask.
#pragma once

#include <burnish/base/image.h>
#include <burnish/base/types.h>
#include <burnish/input/frame.h>

namespace burnish {

/// `add`: over the beauty, or over the diffuse part where there is no beauty. `replace`: the rendered specular is taken
/// out of the beauty first. `difference`: new minus old material's overlay is added to the beauty.
enum class CompositeMode { add, replace, difference };

struct CompositeSettings {
    CompositeMode mode = CompositeMode::add;
    float gain = 1.0f;      // multiplies the overlay
    Color3f tint{1, 1, 1};  // multiplies the overlay
};

/// How much of each pixel counts, row by row, in [0, 1]; 0 where nothing was shaded.
struct Cover {
    PixelVector<float> overlay;   // share of the pixel that the overlay lies over: keeps edges premultiplied
    PixelVector<float> specular;  // share of the rendered specular that `replace` takes out; empty: as `overlay`
    Image kd;                     // RGB, diffuse reflectance; may be empty unless needs_kd
};

struct Composite {
    Image beauty;   // RGBA, associated alpha, linear
    Image overlay;  // RGB as added: gain, tint, mask and coverage applied
    Image diffuse;  // RGB, only where the base is the diffuse part; else empty
};

/// `overlay`: linear RGB, not yet multiplied by its cover; used up. `old_overlay`: for `difference`. Pixels that nothing covers
/// stay as they were rendered. Throws Error(missing_channel) when the mode's layers are absent.
Composite composite(const AovFrame& frame, const Cover& cover, Image overlay, const Image* old_overlay,
                    const CompositeSettings& settings);

/// Whether the diffuse part is made as kd/pi * E * albedo, from an irradiance layer.
bool needs_kd(const AovFrame& frame);

/// The rendered specular radiance: albedo * (direct + indirect) for Cycles, direct + indirect for the others.
/// Throws Error(missing_channel) when there is none.
Image rendered_specular(const AovFrame& frame);

}  // namespace burnish
