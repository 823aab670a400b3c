// Where a ray ends on a proxy, and how the map's centre sees a cone about it.
//
// A cone of rays from p about d paints a patch of the proxy, which the centre sees under other angles. To first order the
// directions turn as  delta' = t / t' P' (delta - d (n . delta) / (n . d)),  P' the projection across d'. Its singular values
// are how the cone is stretched along two axes: an ellipse of directions. Where it is longer than kRound times its breadth, two
// round cones beside each other stand for it, with its second moments.
#pragma once

#include <burnish/light/light_ray.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace burnish {

struct RayEnd {
    uint32_t ray;       // place in the batch
    float share;        // of the ray's cone; those of one ray add up to 1
    Vec3f from_centre;  // to the point that is met; the ray's own direction where that is nowhere
    Vec3f n;            // unit normal of the proxy there, either side
    float distance;     // along the ray, >= 0; infinity = nowhere

    static RayEnd nowhere(uint32_t ray, const Vec3f& d, float share = 1) {
        return {ray, share, d, -d, std::numeric_limits<float>::infinity()};
    }
    bool is_somewhere() const { return distance < std::numeric_limits<float>::infinity(); }
};

/// A cone as the centre sees it: one round cone, or two of half the weight.
struct SeenCone {
    Vec3f middle;          // unit
    Vec3f apart{0, 0, 0};  // the two cones are about middle + apart and middle - apart; 0 = one
    float sigma;           // radian
    float bend = 1;        // what the light's second derivatives along d' are multiplied by, for those along d

    SeenCone(const LightRay& ray, const RayEnd& end);
    bool is_one() const { return apart == Vec3f(0, 0, 0); }
};

inline SeenCone::SeenCone(const LightRay& ray, const RayEnd& end) : middle(end.from_centre), sigma(ray.sigma) {
    constexpr float kRound = 1.2f, kLeast = 1e-3f, kMost = 1e3f;  // beyond, the first order says nothing
    if (!end.is_somewhere()) return;
    const float far2 = std::max(end.from_centre.length2(), 1e-30f);
    middle /= std::sqrt(far2);
    // A cone meets no surface flatter than its own width lets it.
    const float cos_own = end.n.dot(ray.d), least = std::max(ray.sigma, kLeast);
    const float steep = std::copysign(std::sqrt(cos_own * cos_own + least * least), cos_own);
    const Frame frame = Frame::around(ray.d);
    const auto turned = [&](const Vec3f& axis) {
        const Vec3f on_surface = axis - ray.d * (end.n.dot(axis) / steep);
        return on_surface - middle * on_surface.dot(middle);
    };
    const Vec3f t = turned(frame.t), b = turned(frame.b);
    const float tb = t.dot(b), difference = 0.5f * (t.length2() - b.length2()), mean = 0.5f * (t.length2() + b.length2());
    const float spread = std::sqrt(difference * difference + tb * tb), scale2 = end.distance * end.distance / far2;
    const float along2 = mean + spread, across2 = std::max(mean - spread, 1e-6f * mean);
    const float apart2 = std::max(along2 - kRound * kRound * across2, 0.0f);
    sigma = std::clamp(ray.sigma * std::sqrt(scale2 * std::sqrt((along2 - apart2) * across2)), kLeast * ray.sigma,
                       kMost * ray.sigma);
    bend = std::min(scale2 * along2, kMost * kMost);
    if (apart2 * scale2 * ray.sigma * ray.sigma < 1e-10f) return;
    const Vec3f axis = difference >= 0 ? t * (spread + difference) + b * tb : t * tb + b * (spread - difference);
    apart = axis * (ray.sigma * std::sqrt(scale2 * apart2) / axis.length());
}

}  // namespace burnish
