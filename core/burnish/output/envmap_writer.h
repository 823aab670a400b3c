// Distant light as a picture: resampled to a layout and written so that every reader of EXR environment maps takes it.
#pragma once

#include <burnish/light/cube_map/bake_cube_map.h>
#include <burnish/light/environment.h>

#include <string>

namespace burnish {

enum class EnvmapLayout { latlong, cube };

/// RGB in OpenEXR's convention for a world with `up` up; rotation, flip, scale and tint of the light are in the pixels. Each
/// texel is the light filtered over its solid angle.
///
/// latlong: `size` x `size / 2`. cube: a vertical strip of six faces, `size` x `6 size`.
Image envmap_picture(const Environment& light, UpAxis up, EnvmapLayout layout, int size);

/// Writes an EXR (half, ZIP) with the `envmap` attribute, whole or not at all. Throws Error(write_failed | bad_argument).
void write_envmap(const std::string& file, const Image& picture, EnvmapLayout layout);

/// Writes a cube map with its distances: R, G, B, A (half) and Z (float), the `envmap` attribute, and where it was taken as the
/// attribute burnish:centre. Whole or not at all. Throws Error(write_failed | bad_argument).
void write_cube_map(const std::string& file, const CubeMapPicture& picture);

}  // namespace burnish
