// How sharply filtered light bends: what interpolation between two lookups can miss.
//
// The fourth channel of a Gaussian stack's levels holds a bound of the second derivative of the mean of RGB along great circles,
// taken where the level's own Gaussian has been, so that one lookup reads light and bound together. It is the largest in a
// neighbourhood: what is read in direction d holds for all directions within kCurvatureReach of the level's width around d.
#pragma once

#include <burnish/light/filter/cube_stack.h>

namespace burnish {

inline constexpr float kCurvatureReach = 2.5f;  // sigmas

/// Sets the fourth channel of a level from its other three, borders included: mean of RGB per square radian. `sigma`: the
/// level's width, radian.
void set_curvature(float sigma, CubeLevel& level);

}  // namespace burnish
