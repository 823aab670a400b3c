// The overlay into the picture: diffuse or beauty plus overlay, with the pixel's coverage, gain, tint and mask.
#pragma once

#include <burnish/base/image.h>
#include <burnish/input/assign.h>
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

struct Composite {
    Image beauty;   // RGBA, associated alpha, linear
    Image overlay;  // RGB as added: gain, tint, mask and coverage applied
    Image diffuse;  // RGB, only where the base is the diffuse part; else empty
};

/// `assignment`: its coverage is 0 where nothing was shaded, so that `replace` leaves those pixels as they were rendered.
/// `kd`: per rule, for the diffuse part kd/pi * E * albedo from an irradiance layer. `old_overlay`: for `difference`.
/// `overlay` is used up. Throws Error(missing_channel) when the mode's layers are absent.
Composite composite(const AovFrame& frame, const Assignment& assignment, Image overlay, const Image* old_overlay,
                    const std::vector<Color3f>& kd, const CompositeSettings& settings);

/// The rendered specular radiance: albedo * (direct + indirect) for Cycles, direct + indirect for the others.
/// Throws Error(missing_channel) when there is none.
Image rendered_specular(const AovFrame& frame);

}  // namespace burnish
