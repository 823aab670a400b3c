// Planes of mirrors and panes.
#pragma once

#include <burnish/light/light_settings.h>
#include <burnish/scene/view.h>

namespace burnish {

/// Whether a surface point with this unit normal belongs to the plane: no further from it than `tolerance` times the larger of
/// its coordinates and its distance from Plane::point (half floats keep 1/2000 of a coordinate), the normals within 37 degrees
/// of each other or of opposite (bumps), so that what stands on a floor is not the floor.
bool lies_on(const Plane& plane, const Vec3f& p, const Vec3f& n, float tolerance = 1e-3f);

/// The camera that sees in the plane's mirror image what `camera` sees in the mirror. It is no mirrored camera, but one that can
/// be built: pixel (x, y) of the one sees what pixel (width - 1 - x, y) of the other is reflected to.
inline Camera mirrored(const Camera& camera, const Plane& plane) {
    return mirrored(camera, HalfSpace{plane.point, plane.normal});
}

}  // namespace burnish
