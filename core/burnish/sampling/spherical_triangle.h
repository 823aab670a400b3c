// A triangle as the unit sphere about a point sees it: its solid angle, and directions drawn uniformly over it.
//
// Sampling by Arvo 1995, "Stratified sampling of spherical triangles": a share u.x of the area is cut off at one edge, then a
// share u.y of the way along the cut is gone. In double precision, which holds down to triangles of 1e-8 steradian.
#pragma once

#include <burnish/base/types.h>

namespace burnish {

class SphericalTriangle {
public:
    /// Unit directions of the corners, in any order.
    SphericalTriangle(const Vec3f& a, const Vec3f& b, const Vec3f& c);

    /// Steradian, [0, 2 pi]; by van Oosterom & Strackee 1983, exact for the smallest ones too.
    double solid_angle() const { return m_solid_angle; }
    /// A unit direction, u in [0, 1)^2; any one of the triangle where it is degenerate.
    Vec3f sample(const Vec2f& u) const;

private:
    Imath::V3d m_a, m_b, m_c;
    double m_solid_angle;
};

}  // namespace burnish
