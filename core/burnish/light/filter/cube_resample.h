// Pictures of light onto the faces of a cube, by area: a cube texel is the mean of the picture over its solid angle, so
// that a sun of one texel arrives with all its energy.
#pragma once

#include <burnish/base/image.h>

#include <array>

namespace burnish {

/// Six RGB faces of a lat-long picture (texels taken as constant). `face_size` must be even. A constant stays constant; the
/// total of radiance x solid angle is kept within 1e-3 even for a single bright texel.
std::array<Image, 6> latlong_to_cube(const Image& latlong, int face_size);

/// Six RGB faces resized; texels taken as constant, weighted by solid angle. Returns the faces as they are when the size fits.
std::array<Image, 6> resized_cube(const std::array<Image, 6>& faces, int face_size);

/// Six RGB faces of half the size, which must be even: means of four texels by the solid angles of their centres, faster than
/// resized_cube.
std::array<Image, 6> halved_cube(const std::array<Image, 6>& faces);

/// Face size for a lat-long `width` texels wide: at least its resolution at the face centres (width / 4), a power of two in
/// [16, 1024], 2048 from 8k on.
int cube_size_for_latlong(int width);
/// Face size for cube faces of `size`: the next power of two, in [16, 2048].
int cube_size_for_cube(int size);

}  // namespace burnish
