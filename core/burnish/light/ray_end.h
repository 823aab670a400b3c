// Where a ray ends on a proxy, and how the map's centre sees a cone about it.
//
// A cone of rays from p about d paints a patch of the proxy, which the centre sees under other angles. To first order the
// directions turn as  delta' = t / t' P' (delta - d (n . delta) / (n . d)),  P' the projection across d'. Its singular values
// say how the cone is stretched: their product is (t / t')^2 |n . d'| / |n . d|, the larger one bounds how fast the map passes by.
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

/// What seeing a cone from the centre multiplies its width and the light's second derivatives by.
struct ConeTurn {
    float width = 1, bend = 1;

    ConeTurn() = default;
    ConeTurn(const LightRay& ray, const RayEnd& end);
};

inline ConeTurn::ConeTurn(const LightRay& ray, const RayEnd& end) {
    constexpr float kLeast = 1e-3f, kMost = 1e3f;  // beyond, the first order says nothing
    if (!end.is_somewhere()) return;
    const float far2 = std::max(end.from_centre.length2(), 1e-30f);
    const Vec3f seen = end.from_centre / std::sqrt(far2);
    // A cone meets no surface flatter than its own width lets it.
    const float cos_own = end.n.dot(ray.d), least = std::max(ray.sigma, kLeast);
    const float steep = std::copysign(std::sqrt(cos_own * cos_own + least * least), cos_own);
    const Frame across = Frame::around(ray.d);
    const Vec3f t = across.t - ray.d * (end.n.dot(across.t) / steep), b = across.b - ray.d * (end.n.dot(across.b) / steep);
    const float t_seen = t.dot(seen), b_seen = b.dot(seen), scale2 = end.distance * end.distance / far2;
    const float tt = t.length2() - t_seen * t_seen, bb = b.length2() - b_seen * b_seen, tb = t.dot(b) - t_seen * b_seen;
    const float area2 = std::max(tt * bb - tb * tb, 0.0f), mean = 0.5f * (tt + bb);
    width = std::clamp(std::sqrt(scale2 * std::sqrt(area2)), kLeast, kMost);
    bend = std::min(scale2 * (mean + std::sqrt(std::max(mean * mean - area2, 0.0f))), kMost * kMost);
}

}  // namespace burnish
