// How six cube faces, or a lat-long, can lie in one picture, told by the aspect ratio alone.
//
//     width : height   layout                       faces
//     1 : 6, 6 : 1     strip, down or to the right  px nx py ny pz nz
//     3 : 2            two rows, as OpenImageIO's   px py pz / nx ny nz
//     4 : 3            horizontal cross             . py . . / nx nz px pz / . ny . .
//     3 : 4            vertical cross               . py . / nx nz px / . ny . / . pz .   (pz turned by 180 degrees)
//     anything else    lat-long
//
// Faces are as in cube_pyramid.h, each seen from inside; in the crosses neighbours touch along their common edge, so the
// middle face is nz, the one whose right is +X (other programs call the same picture "front" or, left-handed, pz).
#pragma once

#include <burnish/base/image.h>

#include <array>
#include <string_view>

namespace burnish {

enum class EnvironmentLayout { latlong, vertical_strip, horizontal_strip, two_rows, horizontal_cross, vertical_cross };

EnvironmentLayout layout_of(int width, int height);
/// For people: "lat-long", "vertical strip of cube faces", ...
std::string_view layout_name(EnvironmentLayout layout);
/// Whether the faces stand in a fixed order rather than beside their neighbours: then their names follow the axes of the
/// world they were made in.
bool faces_are_named(EnvironmentLayout layout);

/// Cuts the picture (not lat-long) into the faces +X -X +Y -Y +Z -Z.
std::array<Image, 6> cut_faces(const Image& picture, EnvironmentLayout layout);

/// The inverse for the horizontal cross: faces of N x N x C to 4 N x 3 N x C, 0 around.
Image horizontal_cross(const std::array<Image, 6>& faces);

/// Faces named after the axes of a Z-up world, as the light's Y-up faces (x, y, z) -> (x, z, -y); no face needs turning.
std::array<Image, 6> from_z_up_names(std::array<Image, 6> faces);

}  // namespace burnish
