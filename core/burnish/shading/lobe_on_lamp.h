// Where on a lamp's plane a lobe peaks, and how fast it falls from there: the quadratic form that focused nodes need.
//
// Slopes of the half vector, in the lobe's widths, are taken as linear in the place on the plane, about the lamp's place that is nearest
// to the mirror direction. The lamp's own falling off with the distance is part of the form, which matters from close by.
#pragma once

#include <burnish/light/area/convex_polygon.h>
#include <burnish/light/area/focused_nodes.h>
#include <burnish/shading/shading_point.h>

#include <span>

namespace burnish {

/// `corners`: the lamp's part above the horizon, three or more; p: the shaded point, not in the lamp's plane.
PlaneQuadratic lobe_on_lamp(const ShadingPoint& point, float side_sign, const Vec3f& p, const ConvexPolygon& lamp,
                            std::span<const Vec3f> corners);

}  // namespace burnish
