// Places on a flat polygon that gather where a peaked function is, for integrals of functions with long tails.
//
// The function is to go like (1 + Q)^-2, Q a quadratic form on the polygon's plane: a lobe with a long tail, or a lamp seen from close
// by. Integrals over lines, and then over these, become smooth when distances from the peak are taken as tangents of an angle:
// a few Gauss-Legendre points then do for a peak of any width, inside the polygon or out.
#pragma once

#include <burnish/light/area_nodes.h>

#include <span>
#include <vector>

namespace burnish {

/// Q(x, y) = xx x^2 + 2 xy x y + yy y^2 + 2 (bx x + by y) + at_origin, place = origin + x axis_x + y axis_y.
struct PlaneQuadratic {
    Vec3f origin, axis_x, axis_y;  // unit axes, perpendicular to each other
    float xx = 0, xy = 0, yy = 0, bx = 0, by = 0, at_origin = 0;
};

/// Sixteen nodes of a convex polygon, appended; fewer where it has no width.
void add_focused_nodes(std::span<const Vec3f> corners, const Color3f& radiance, const PlaneQuadratic& q,
                       std::vector<AreaNode>& nodes);

}  // namespace burnish
