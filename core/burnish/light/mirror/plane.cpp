#include <burnish/light/mirror/plane.h>

#include <algorithm>

namespace burnish {

bool lies_on(const Plane& plane, const Vec3f& p, const Vec3f& n, float tolerance) {
    constexpr float kLeastCos = 0.8f;
    const Vec3f normal = plane.normal.normalized(), from_point = p - plane.point;
    const float size = std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z), from_point.length()});
    return std::fabs(from_point.dot(normal)) <= tolerance * size && std::fabs(n.dot(normal)) >= kLeastCos;
}

}  // namespace burnish
