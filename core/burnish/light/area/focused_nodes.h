// Places on a flat polygon that gather where a peaked function is, for integrals of functions with long tails.
//
// The function is to go like (1 + Q)^-2, Q a quadratic form on the polygon's plane: a lobe with a long tail, or a lamp seen from close
// by. Integrals over lines, and then over these, become smooth when distances from the peak are taken as tangents of an angle:
// a few Gauss-Legendre points then do for a peak of any width, inside the polygon or out.
#pragma once

#include <burnish/base/types.h>

#include <span>
#include <vector>

namespace burnish {

/// Q(x, y) = xx x^2 + 2 xy x y + yy y^2 + 2 (bx x + by y) + at_origin, place = origin + x axis_x + y axis_y.
struct PlaneQuadratic {
    Vec3f origin, axis_x, axis_y;  // unit axes, perpendicular to each other
    float xx = 0, xy = 0, yy = 0, bx = 0, by = 0, at_origin = 0;
};

/// A place and the part of the polygon that it stands for.
struct FocusedNode {
    Vec3f p;
    Vec3f along, across;  // deviations of a rectangle as large as the part, scene units
    float area;           // weight of the place: the integral of g is the sum of area * g(p)
};

/// `side` times as many nodes of a convex polygon, side 3 or 4; fewer where it has no width. Written over what is in `nodes`.
void focus_nodes(std::span<const Vec3f> corners, const PlaneQuadratic& q, int side, std::vector<FocusedNode>& nodes);

}  // namespace burnish
