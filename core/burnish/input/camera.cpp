#include <burnish/input/camera.h>

namespace burnish {

Vec3f Camera::forward() const {
    const Vec3f n = right.cross(up).normalized();
    return n.dot(axis) < 0 ? -n : n;
}

std::optional<Vec2f> Camera::project(const Vec3f& p) const {
    const Imath::V3d d(p - centre), r(right), u(up), a(axis);
    const double z = d.dot(r.cross(u)) / a.dot(r.cross(u));  // Cramer's rule for d = Z axis + Z sx right + Z sy up
    if (!(z > 0)) return std::nullopt;
    const double volume = z * r.dot(u.cross(a));
    return Vec2f(Imath::V2d(d.dot(u.cross(a)) / volume, d.dot(a.cross(r)) / volume));
}

Vec2f screen_point(int x, int y, const Window& display) {
    return {2.0f * (static_cast<float>(x - display.x) + 0.5f) / static_cast<float>(display.width) - 1.0f,
            1.0f - 2.0f * (static_cast<float>(y - display.y) + 0.5f) / static_cast<float>(display.height)};
}

}  // namespace burnish
