// Planes around the centre of a cube map (walls, floor, ceiling; the six sides of a box): a ray ends on the nearest it leaves by.
//
// The room is on the centre's side of every plane. With h the distance from p to a plane and g = n / h, n pointing out, the ray
// meets it at 1 / t = g . d: nearer planes are larger ones, planes that the ray moves away from negative, and 0 stands for
// infinity. The largest is continuous in d, so one ray's end never jumps. A cone that straddles the edge between two planes is
// shared out by how much of it meets which (their difference is linear in d, so the edge is a straight line across the cone):
// lookups of wide cones do not jump either. For p on a plane or beyond it |h| stands for h, and never less than kNearest of the
// centre's distance: a wall that should have been ahead is as far ahead as it is behind.
#pragma once

#include <burnish/light/cube_map/ray_end.h>
#include <burnish/light/light_settings.h>

#include <span>
#include <vector>

namespace burnish {

class BoundingPlanes {
public:
    /// Throws Error(bad_argument) for no planes, a plane without a normal, or one that the centre lies on.
    BoundingPlanes(std::span<const Plane> planes, const Vec3f& centre);
    /// Throws Error(bad_argument) for a box without a volume, axes that are not perpendicular unit vectors, or a centre outside.
    BoundingPlanes(const OrientedBox& box, const Vec3f& centre);

    void ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const;

    static constexpr float kNearest = 1e-3f;

private:
    struct Wall {
        Vec3f n;         // unit, away from the centre
        float distance;  // from the centre, > 0
    };
    /// g: of each wall, see above.
    static bool straddles(const LightRay& ray, std::span<const Vec3f> g, size_t nearest);
    void share_out(const LightRay& ray, uint32_t index, std::span<const Vec3f> g, std::vector<RayEnd>& out) const;
    Vec3f reciprocal(const Wall& wall, const Vec3f& p) const;
    RayEnd end(const LightRay& ray, uint32_t index, size_t wall, float per_distance, float share) const;

    std::vector<Wall> m_walls;  // the last one stands for infinity: no normal
    Vec3f m_centre;
};

}  // namespace burnish
