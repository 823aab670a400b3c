// A flat convex polygon in the world: the shape of an area light.
#pragma once

#include <burnish/base/types.h>

#include <vector>

namespace burnish {

struct ConvexPolygon {
    ConvexPolygon() = default;
    /// Three corners or more, in one plane, counter-clockwise seen from where `normal` points. Throws Error(bad_argument) for
    /// fewer, for corners that are not finite, not in one plane or not convex, and where there is no area.
    explicit ConvexPolygon(std::vector<Vec3f> corners);

    std::vector<Vec3f> corners;
    Vec3f normal{0, 0, 1};  // unit
    float area = 0;         // square scene units
    float size = 0;         // largest distance of a corner from the first, scene units

    /// Height of a point above the plane.
    float height(const Vec3f& p) const { return normal.dot(p - corners[0]); }
    /// Unit direction.
    Vec3f longest_edge() const;
    bool is_parallelogram() const;
    /// The corners of what lies above a plane through `from`, `up` its unit normal: none, or three and more.
    void above(const Vec3f& from, const Vec3f& up, std::vector<Vec3f>& cut) const;
};

}  // namespace burnish
