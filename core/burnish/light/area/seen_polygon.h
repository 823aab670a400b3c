// A flat convex polygon as a point sees it: corners are directions, edges great circles.
//
// How much of a spherical Gaussian lies in it is found on Lambert's equal-area map about the Gaussian, where that is a plane one.
// Corners, and the points of the edges nearest to the Gaussian's centre, are mapped, and straight lines drawn between them. By
// Green's theorem every line then takes away the Gaussian's share behind it, between its ends, which is Owen's T (1956):
//
//     share = [d inside] - sum over lines of +-(T(h, b / h) - T(h, a / h)),   T(h, x) = 1/2pi int_0^x exp(-h^2 (1 + t^2) / 2) / (1 + t^2) dt
//
// h: distance of the line from the centre, a and b: places of its ends along it, all in deviations.
#pragma once

#include <burnish/light/area/convex_polygon.h>

#include <vector>

namespace burnish {

/// What a Gaussian about some direction has of a polygon.
struct GaussianPart {
    float share = 0;         // of the Gaussian inside, [0, 1]
    float bend = 0;          // bound of the second derivative of `share` along great circles, per radian^2, within
                             // kCurvatureReach widths of d
    float reach = 0;         // bound of `share` itself, there, too
    Vec3f nearest{0, 0, 1};  // the direction inside that is nearest to d: d itself if it is inside
};

class SeenPolygon {
public:
    /// From a point above its plane, or, if `both_sides`, below. From in the plane there is nothing to be seen. Only the part above
    /// the point's own horizon is, the plane across unit vector `up`.
    void look(const ConvexPolygon& polygon, const Vec3f& from, const Vec3f& up, bool both_sides);

    bool is_visible() const { return !m_edges.empty(); }
    /// Steradian.
    float solid_angle() const { return m_solid_angle; }

    /// Of a Gaussian exp((cos - 1) / sigma^2) about d.
    GaussianPart gaussian(const Vec3f& d, float sigma) const;

private:
    struct Edge {
        Vec3f begin, end;  // unit; counter-clockwise round the polygon
        Vec3f inward;      // unit normal of the great circle
    };
    std::vector<Vec3f> m_corners;  // directions
    std::vector<Edge> m_edges;
    float m_solid_angle = 0;
};

}  // namespace burnish
