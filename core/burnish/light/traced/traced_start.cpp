#include <burnish/light/traced/traced_start.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kHalfFloat = 1e-3f;     // how far positions may lie off the surface, of their size
constexpr float kFarFloat = 1e-5f;      // how far a ray starts off the surface, of the size of its place and of the scene
constexpr float kSameDistance = 1e-3f;  // a lamp's point is seen when its ray goes this near to it, of its distance

}  // namespace

TracedStart::TracedStart(const LitScene& scene, const LightRay& ray)
    : m_scene(scene), m_p(ray.p), m_ng(ray.ng), m_side(std::copysign(1.0f, ray.ng.dot(ray.d))), m_passes(ray.side < 0) {
    const float size = std::max({std::abs(ray.p.x), std::abs(ray.p.y), std::abs(ray.p.z)});
    const float off = kFarFloat * (size + scene.extent()), reach = kHalfFloat * size + off;
    const auto hit = scene.tracer().closest(ray.p + ray.ng * reach, -ray.ng, 0, 2 * reach);
    if (hit) m_object = hit->object;
    m_origin = hit ? hit->p + hit->ng * (m_side * off) : ray.p + ray.ng * (m_side * off);
}

std::span<const SeenLamp> TracedStart::lamps() {
    if (!m_looked)
        for (const Lamps::Point& point : m_scene.lamps().points()) see(point);
    m_looked = true;
    return m_lamps;
}

void TracedStart::see(const Lamps::Point& point) {
    const Vec3f way = point.p - m_origin;
    const float distance = way.length();
    if (!(way.dot(up()) > 0 && way.dot(point.n) < 0)) return;
    const Vec3f d = way / distance;
    if (m_scene.tracer().occluded(m_origin, d, distance * (1 - kSameDistance), hidden())) return;
    m_lamps.push_back({d, point.radiance, point.density * distance * distance / -d.dot(point.n), 1 / distance});
}

}  // namespace burnish
