// Environments as pictures again: conversion between layouts, levels of the pyramid to look at, and a short description.
// What `burnish envmap` prints and writes. Everything here shows the pyramid: load with Suns::keep for the whole picture.
#pragma once

#include <burnish/light/environment.h>

namespace burnish {

/// Lat-long of width x width / 2 RGB texels in light axes (OpenEXR's convention: +Z in the middle, Y up), filtered from the
/// pyramid to the texels' size. `width` is even, >= 2; gain is not applied. Throws Error(bad_argument).
Image to_latlong(const Environment& light, int width);

/// The six faces +X -X +Y -Y +Z -Z one below the other, face_size x 6 face_size RGB, as OpenEXR stores cube maps. A power of
/// two gives a level of the pyramid as it is where there is one. Throws Error(bad_argument).
Image to_cube_strip(const Environment& light, int face_size);

/// One level of the pyramid as a cross, 4 N x 3 N RGB, black around. Throws Error(bad_argument).
Image level_image(const CubePyramid& pyramid, int level);

struct EnvironmentSummary {
    Color3f mean;  // radiance averaged over the sphere
    float mean_luminance;
    float peak_luminance;     // of the brightest texel of the finest level
    Vec3f peak_direction;     // in light axes
    float bright_share;       // of the light that comes from the brightest 0.1 % of the sphere, [0, 1]
    int face_size;            // texels per cube face edge in use
    int suggested_face_size;  // from the picture's own resolution
};

/// Numbers of the finest level, gain not applied; suns that were taken out of it do not count (Suns::keep leaves them in). Layout, convention and up axis are in Environment::notes().
EnvironmentSummary summarize(const Environment& light);

}  // namespace burnish
