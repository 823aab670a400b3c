#include <burnish/surface/uv_tangent.h>

#include <array>

namespace burnish {
namespace {

/// Change of position and UV over one pixel step.
struct Difference {
    Vec3f p;
    Vec2f uv;
};

bool same_surface(const AovFrame& frame, size_t a, size_t b) {
    for (const Role role : {Role::object_id, Role::material_id}) {
        const auto ids = frame.layers.find(role);
        if (ids != frame.layers.end() && *ids->second.at(a) != *ids->second.at(b)) return false;
    }
    const Image& normal = frame.layers.at(Role::normal);
    const float *na = normal.at(a), *nb = normal.at(b);
    return na[0] * nb[0] + na[1] * nb[1] + na[2] * nb[2] > 0.5f;
}

/// Difference towards the neighbour at `step` (-1 or +1 times 1 or the row length), turned to the positive direction.
std::optional<Difference> difference(const AovFrame& frame, size_t pixel, long step) {
    const Image &position = frame.layers.at(Role::position), &uv = frame.layers.at(Role::uv);
    const size_t other = pixel + step;
    if (!same_surface(frame, pixel, other)) return std::nullopt;
    const float sign = step > 0 ? 1.0f : -1.0f;
    const float *p0 = position.at(pixel), *p1 = position.at(other), *t0 = uv.at(pixel), *t1 = uv.at(other);
    const Difference d{Vec3f(p1[0] - p0[0], p1[1] - p0[1], p1[2] - p0[2]) * sign, Vec2f(t1[0] - t0[0], t1[1] - t0[1]) * sign};
    const bool at_seam = std::abs(d.uv.x) > 0.5f || std::abs(d.uv.y) > 0.5f;
    return at_seam || !is_finite(d.p) ? std::nullopt : std::optional(d);
}

}  // namespace

std::optional<Vec3f> uv_tangent(const AovFrame& frame, size_t pixel) {
    const Image& position = frame.layers.at(Role::position);
    const long width = position.width, height = position.height;
    const long x = static_cast<long>(pixel) % width, y = static_cast<long>(pixel) / width;
    std::optional<Difference> dx, dy;
    if (x + 1 < width) dx = difference(frame, pixel, 1);
    if (!dx && x > 0) dx = difference(frame, pixel, -1);
    if (y + 1 < height) dy = difference(frame, pixel, width);
    if (!dy && y > 0) dy = difference(frame, pixel, -width);
    if (!dx || !dy) return std::nullopt;
    const float determinant = dx->uv.x * dy->uv.y - dy->uv.x * dx->uv.y;
    if (std::abs(determinant) < 1e-20f) return std::nullopt;
    return (dx->p * dy->uv.y - dy->p * dx->uv.y) * std::copysign(1.0f, determinant);
}

}  // namespace burnish
