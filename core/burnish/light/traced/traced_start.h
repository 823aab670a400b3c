// Where the rays of a shaded point start, and a few points of the scene's lamps as they are seen from there.
#pragma once

#include <burnish/light/traced/lit_scene.h>

#include <span>
#include <vector>

namespace burnish {

/// A point of a lamp that is seen.
struct SeenLamp {
    Vec3f d;           // unit, towards it
    Color3f radiance;  // of the part of the lamp that the point stands for
    float density;     // with which such points are drawn, times their number, per steradian
    float nearness;    // 1 / distance
};

class TracedStart {
public:
    /// On the surface that the scene has at the ray's point, or near it: positions of a render may be rounded to half floats.
    TracedStart(const LitScene& scene, const LightRay& ray);

    bool is_of(const LightRay& ray) const {
        return ray.p == m_p && ray.ng == m_ng && ray.ng.dot(ray.d) * m_side >= 0 && (ray.side < 0) == m_passes;
    }
    /// Of a ray towards d: off the surface, to the side that the rays leave by.
    Vec3f origin() const { return m_origin; }
    /// Unit normal on that side.
    Vec3f up() const { return m_ng * m_side; }
    /// The object that rays pass through, which they do not meet: thin things show what lies behind all of them. Else none.
    std::span<const int> hidden() const { return {&m_object, m_passes && m_object >= 0 ? size_t{1} : size_t{0}}; }
    /// The lamps' points in sight, traced when first asked for.
    std::span<const SeenLamp> lamps();

private:
    void see(const Lamps::Point& point);

    const LitScene& m_scene;
    Vec3f m_p, m_ng, m_origin;
    float m_side;
    bool m_passes;
    int m_object = -1;
    bool m_looked = false;
    std::vector<SeenLamp> m_lamps;
};

}  // namespace burnish
