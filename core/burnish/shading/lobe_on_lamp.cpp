#include <burnish/shading/lobe_on_lamp.h>

#include <burnish/shading/half_slopes.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kFlattest = 0.02f;  // cosine: flatter mirror directions meet the plane as that one would
constexpr float kStep = 0.01f;      // of the distance: for differences of slopes

/// The place of a convex polygon that is nearest to a place on its plane.
Vec3f nearest_place(std::span<const Vec3f> corners, const Vec3f& normal, const Vec3f& place) {
    Vec3f best = place;
    float least = INFINITY;
    bool inside = true;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Vec3f &a = corners[i], way = corners[(i + 1) % corners.size()] - a;
        inside = inside && normal.dot(way.cross(place - a)) >= 0;
        const Vec3f on = a + way * std::clamp(way.dot(place - a) / std::max(way.length2(), 1e-20f), 0.0f, 1.0f);
        if ((place - on).length2() < least) least = (place - on).length2(), best = on;
    }
    return inside ? place : best;
}

/// Where the mirror direction meets the plane, or would if it were turned to it.
Vec3f mirrored_place(const ShadingPoint& point, float side_sign, const Vec3f& p, const Vec3f& normal, float height) {
    const Vec3f peak = point.frame.to_world({-point.wo.x, -point.wo.y, point.wo.z * side_sign});
    const float towards = -normal.dot(peak) * std::copysign(1.0f, height);
    const Vec3f aside = peak - normal * normal.dot(peak);
    return p - normal * height + aside * (std::fabs(height) / std::max(towards, kFlattest));
}

}  // namespace

PlaneQuadratic lobe_on_lamp(const ShadingPoint& point, float side_sign, const Vec3f& p, const ConvexPolygon& lamp,
                            std::span<const Vec3f> corners) {
    const float height = lamp.height(p);
    PlaneQuadratic q;
    q.origin = nearest_place(corners, lamp.normal, mirrored_place(point, side_sign, p, lamp.normal, height));
    q.axis_y = lamp.longest_edge(), q.axis_x = q.axis_y.cross(lamp.normal);
    const auto slopes = [&](const Vec3f& place) {
        Vec3f wi = point.frame.to_local((place - p).normalized());
        wi.z *= side_sign;
        return scaled_slopes(point, wi);
    };
    const float step = kStep * (q.origin - p).length();
    const auto change = [&](const Vec3f& axis) {
        return (slopes(q.origin + axis * step) - slopes(q.origin - axis * step)) / (2 * step);
    };
    const Vec2f s = slopes(q.origin), along = change(q.axis_x), across = change(q.axis_y);
    const Vec3f off = q.origin - (p - lamp.normal * height);
    const float per_distance2 = 1 / (height * height + off.length2());
    q.xx = along.length2() + per_distance2, q.yy = across.length2() + per_distance2, q.xy = along.dot(across);
    q.bx = s.dot(along) + off.dot(q.axis_x) * per_distance2, q.by = s.dot(across) + off.dot(q.axis_y) * per_distance2;
    q.at_origin = s.length2();
    return q;
}

}  // namespace burnish
