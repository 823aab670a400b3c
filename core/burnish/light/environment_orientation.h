// The turn between the render's world and the picture: convention, up axis, rotation and flip as one matrix.
//
// Light axes are the picture's own: lat-long +Z in the middle, +X at u = 1/4, Y up; cube faces by OpenEXR's axes. With
// t = R(up axis, +rotation) d the turned lookup direction, (X, Y, Z) in light axes is
//
//     picture                up    X      Y      Z
//     lat-long, openexr      y     t.x    t.y    t.z
//     lat-long, openexr      z     t.x    t.z   -t.y     (the usual Z-up to Y-up change)
//     lat-long, blender      z     t.y    t.z    t.x     (u = 1/2 - atan2(t.y, t.x) / 2 pi)
//     lat-long, blender      y    -t.z    t.y    t.x     (three.js: u = atan2(t.z, t.x) / 2 pi + 1/2)
//     cube                   y     t.x    t.y    t.z
//     cube                   z     t.x    t.z   -t.y
//
// and a flip negates X.
#pragma once

#include <burnish/light/environment.h>

namespace burnish {

/// `convention` and `up` must not be automatic. The result is used as v * M.
Matrix33f world_to_light_matrix(EnvironmentConvention convention, UpAxis up, float rotate_deg, bool flip, bool is_cube);

}  // namespace burnish
