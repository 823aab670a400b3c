// A few places on an area light with weights that integrate over it what varies slowly, picture and all.
//
// Places are Gauss-Legendre points of quadrilaterals that the polygon is cut into. Where the lamp is a picture, a place weighs
// what the picture has of its Lagrange polynomial: the rule is exact for picture times polynomial, however busy the picture
// (product integration, Young 1954). So no lookups are left to be made when it is used.
#pragma once

#include <burnish/light/area/area_picture.h>
#include <burnish/light/area/convex_polygon.h>

#include <span>
#include <vector>

namespace burnish {

struct AreaNode {
    Vec3f p;        // world
    Color3f power;  // sum of power * g(p) over the nodes = integral of radiance * g over the area
    float radius;   // of a disc as large as the part it stands for, scene units
};

/// The nodes of a convex polygon of even radiance, appended.
void add_area_nodes(std::span<const Vec3f> corners, const Color3f& radiance, std::vector<AreaNode>& nodes);

/// `picture`: over a parallelogram; null = none.
std::vector<AreaNode> area_nodes(const ConvexPolygon& polygon, const Color3f& radiance, const AreaPicture* picture);

}  // namespace burnish
