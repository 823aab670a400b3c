#include <burnish/light/cube_map/bounding_planes.h>

#include <burnish/base/error.h>

#include <string>

namespace burnish {
namespace {

constexpr float kStraddle = 1.88f;  // sigmas: a cone further from an edge lies on one side of it

/// Share of a Gaussian beyond a straight edge at x sigmas: its cumulative distribution, but 0 and 1 beyond kStraddle.
float share_beyond(float x) {
    const float s = std::clamp(0.5f + 0.5f * x / kStraddle, 0.0f, 1.0f);
    return s * s * (3 - 2 * s);
}

[[noreturn]] void refuse(const std::string& problem) {
    throw Error(ErrorCode::bad_argument, "proxy of a cube map: " + problem);
}

std::string text(const Vec3f& v) {
    return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

void check_axes(const OrientedBox& box) {
    const Vec3f axes[3] = {box.x, box.y, box.z};
    for (int k = 0; k < 3; ++k) {
        const bool unit = std::fabs(axes[k].length() - 1) < 1e-3f;
        if (!unit || !(std::fabs(axes[k].dot(axes[(k + 1) % 3])) < 1e-3f))
            refuse("the box's axes must be unit vectors, perpendicular to each other; found " + text(box.x) + ", " +
                   text(box.y) + ", " + text(box.z));
        if (!(box.half[k] > 0 && std::isfinite(box.half[k])))
            refuse("the box's half edges must be greater than 0, found " + text(box.half));
    }
}

/// Outwards sides of a box.
std::vector<Plane> sides(const OrientedBox& box) {
    check_axes(box);
    const Vec3f axes[3] = {box.x, box.y, box.z};
    std::vector<Plane> planes;
    for (int k = 0; k < 3; ++k)
        for (const float side : {1.0f, -1.0f}) planes.push_back({box.centre + axes[k] * (side * box.half[k]), axes[k] * side});
    return planes;
}

}  // namespace

BoundingPlanes::BoundingPlanes(std::span<const Plane> planes, const Vec3f& centre) : m_centre(centre) {
    if (planes.empty()) refuse("no planes. Give one or more, or choose the infinite proxy.");
    for (const Plane& plane : planes) {
        const float length = plane.normal.length();
        if (!(length > 1e-20f && std::isfinite(length)) || !is_finite(plane.point))
            refuse("a plane needs a finite point and a normal that is not zero; found " + text(plane.point) + " and " +
                   text(plane.normal));
        const Vec3f n = plane.normal / length;
        const float distance = n.dot(plane.point - centre);
        if (!(std::fabs(distance) > 1e-6f * (plane.point - centre).length()))
            refuse("the plane through " + text(plane.point) + " goes through the map's centre " + text(centre) +
                   ", which sees nothing of it. Move either.");
        m_walls.push_back({distance < 0 ? -n : n, std::fabs(distance)});
    }
    m_walls.push_back({Vec3f(0, 0, 0), 1});
}

BoundingPlanes::BoundingPlanes(const OrientedBox& box, const Vec3f& centre) : BoundingPlanes(sides(box), centre) {
    const Vec3f from_middle = centre - box.centre, axes[3] = {box.x, box.y, box.z};
    for (int k = 0; k < 3; ++k)
        if (std::fabs(axes[k].dot(from_middle)) > box.half[k])
            refuse("the map's centre " + text(centre) + " lies outside the box about " + text(box.centre) +
                   ". Move either; the box should be the room that the map was taken in.");
}

void BoundingPlanes::ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const {
    out.clear();
    std::vector<Vec3f> g(m_walls.size());
    for (uint32_t index = 0; index < rays.size(); ++index) {
        const LightRay& ray = rays[index];
        if (index == 0 || ray.p != rays[index - 1].p)
            for (size_t i = 0; i < m_walls.size(); ++i) g[i] = reciprocal(m_walls[i], ray.p);
        size_t nearest = 0;
        for (size_t i = 1; i < m_walls.size(); ++i)
            if (g[i].dot(ray.d) > g[nearest].dot(ray.d)) nearest = i;
        if (straddles(ray, g, nearest))
            share_out(ray, index, g, out);
        else
            out.push_back(end(ray, index, nearest, g[nearest].dot(ray.d), 1));
    }
}

Vec3f BoundingPlanes::reciprocal(const Wall& wall, const Vec3f& p) const {
    const float ahead = std::fabs(wall.distance - wall.n.dot(p - m_centre));
    return wall.n / std::max(ahead, kNearest * wall.distance);
}

namespace {

/// How many sigmas the ray lies on the near side of the edge between two walls.
float sigmas_from_edge(const LightRay& ray, const Vec3f& near, const Vec3f& far) {
    const Vec3f g = near - far;
    const float gap = g.dot(ray.d), slope = std::sqrt(std::max(g.length2() - gap * gap, 0.0f));
    return gap / std::max(slope * ray.sigma, 1e-12f);
}

}  // namespace

bool BoundingPlanes::straddles(const LightRay& ray, std::span<const Vec3f> g, size_t nearest) {
    const float reach2 = kStraddle * kStraddle * ray.sigma * ray.sigma;
    for (size_t i = 0; i < g.size(); ++i) {
        const Vec3f edge = g[nearest] - g[i];
        const float gap = edge.dot(ray.d);
        if (i != nearest && gap * gap < reach2 * (edge.length2() - gap * gap)) return true;
    }
    return false;
}

void BoundingPlanes::share_out(const LightRay& ray, uint32_t index, std::span<const Vec3f> g, std::vector<RayEnd>& out) const {
    const size_t first = out.size();
    float total = 0;
    for (size_t i = 0; i < g.size(); ++i) {
        float share = 1;
        for (size_t j = 0; j < g.size() && share > 0; ++j)
            if (j != i) share *= share_beyond(sigmas_from_edge(ray, g[i], g[j]));
        if (share > 0) out.push_back(end(ray, index, i, g[i].dot(ray.d), share));
        total += share;
    }
    for (size_t k = first; k < out.size(); ++k) out[k].share /= total;
}

RayEnd BoundingPlanes::end(const LightRay& ray, uint32_t index, size_t wall, float per_distance, float share) const {
    constexpr float kInfinity = 1e-6f;  // of a wall's distance over that of a place on it: as good as parallel
    if (per_distance * m_walls[wall].distance < kInfinity) return RayEnd::nowhere(index, ray.d, share);
    const float distance = 1 / per_distance;
    return {index, share, ray.p + ray.d * distance - m_centre, m_walls[wall].n, distance};
}

}  // namespace burnish
