#include <burnish/shading/lobe_image.h>

#include <algorithm>

namespace burnish {

DirectionSlopes direction_slopes(const Vec3f& wo, float sx, float sy) {
    const float cos_h = 1 / std::sqrt(1 + sx * sx + sy * sy);
    const Vec3f h = Vec3f(sx, sy, 1) * cos_h;
    const auto along = [&](const Vec3f& axis) {
        const Vec3f dh = (axis - h * h.dot(axis)) * cos_h;
        return (h * wo.dot(dh) + dh * wo.dot(h)) * 2.0f;
    };
    return {along({1, 0, 0}), along({0, 1, 0})};
}

Vec2f widening(const Vec3f& wo, float sigma) {
    const DirectionSlopes J = direction_slopes(wo, 0, 0);
    const float xx = J.x.dot(J.x), xy = J.x.dot(J.y), yy = J.y.dot(J.y), scale = 2 * sigma * sigma / (xx * yy - xy * xy);
    return {scale * yy, scale * xx};
}

LobeImage lobe_image(const Vec3f& wo, float mx, float my) {
    const DirectionSlopes J = direction_slopes(wo, 0, 0);
    const float sx = mx / std::sqrt(2.0f), sy = my / std::sqrt(2.0f);
    const Vec3f x = J.x * sx, y = J.y * sy;
    const float xx = x.dot(x), xy = x.dot(y), yy = y.dot(y);
    const float angle = 0.5f * std::atan2(2 * xy, xx - yy), c = std::cos(angle), s = std::sin(angle);
    const float root = std::sqrt(0.25f * (xx - yy) * (xx - yy) + xy * xy), mean = 0.5f * (xx + yy);
    return {std::sqrt(mean + root), std::sqrt(std::max(mean - root, 1e-4f * mean)), {c * sx, s * sy}};
}

}  // namespace burnish
