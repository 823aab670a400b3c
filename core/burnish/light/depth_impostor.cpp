#include <burnish/light/depth_impostor.h>

namespace burnish {
namespace {

constexpr float kSegment = 2 * DistanceMap::kReach;  // radian of the arc, skipped or followed
constexpr float kBreak = 1.3f;                       // from one texel to the next: the surface ends there
constexpr float kLastAngle = kPi / 2 - 1e-3f;        // of the arc, from the point nearest to the centre
constexpr int kSecants = 8;
constexpr float kClose = 1e-5f;

/// A ray from o along d in the map's axes, by its angle theta seen from the centre: 0 where it is nearest, pi / 2 far away.
struct Arc {
    Vec3f o, d, side;    // side: unit, from the centre to the nearest point
    float reach, along;  // distance of the nearest point from the centre; from there to o

    Arc(const Vec3f& origin, const Vec3f& direction) : o(origin), d(direction), along(origin.dot(direction)) {
        const Vec3f nearest = o - d * along;
        reach = nearest.length();
        side = reach > 0 ? nearest / reach : Frame::around(d).t;
        reach = std::max(reach, 1e-6f * std::max(o.length(), 1e-6f));
    }
    float start() const { return std::atan2(along, reach); }
    Vec3f toward(float theta) const { return side * std::cos(theta) + d * std::sin(theta); }
    float radius(float theta) const { return reach / std::cos(theta); }
    float distance(float theta) const { return reach * std::tan(theta) - along; }
    Vec3f at(float distance) const { return o + d * distance; }
};

/// One ray's way over the map.
class March {
public:
    March(const DistanceMap& map, const Arc& arc) : m_map(map), m_arc(arc) {}

    /// Distance to the surface it meets; the outline it vanished behind, else nothing.
    std::optional<float> meet();
    bool ends_at_outline() const { return m_at_outline; }

private:
    float excess(float distance) const { return m_map.nearer(m_arc.at(distance)) - 1; }
    float excess_at(float theta) const { return m_arc.radius(theta) * m_map.nearer(m_arc.toward(theta)) - 1; }
    /// Where the excess changes its sign between two distances.
    float root(float near, float far) const;
    /// Follows the arc step by step; true when it met a surface, then at m_met.
    bool follow(float from, float to);
    /// The rest of the arc beyond kLastAngle, which goes in one direction.
    bool meets_far_away();

    const DistanceMap& m_map;
    const Arc& m_arc;
    bool m_hidden = false, m_at_outline = false;
    float m_met = 0;
    std::optional<float> m_outline;
};

std::optional<float> March::meet() {
    const float start = m_arc.start();
    m_hidden = excess(0) > 0;
    for (float theta = start; theta < kLastAngle; theta += kSegment) {
        const float next = std::min(theta + kSegment, kLastAngle);
        const float farthest = std::max(m_arc.radius(theta), m_arc.radius(next));
        if (farthest * m_map.bound(m_arc.toward(0.5f * (theta + next))) < 1)
            m_hidden = false;
        else if (follow(theta, next))
            return m_met;
    }
    if (!m_hidden && meets_far_away()) return m_met;
    m_at_outline = m_outline.has_value();
    return m_outline;
}

bool March::follow(float from, float to) {
    const int steps = std::clamp(m_map.size() / 32, 4, 32);
    float before = from;
    for (int i = 1; i <= steps; ++i) {
        const float theta = from + (to - from) * static_cast<float>(i) / static_cast<float>(steps);
        const bool behind = excess_at(theta) > 0;
        if (behind && !m_hidden) {
            m_met = root(std::max(m_arc.distance(before), 0.0f), m_arc.distance(theta));
            if (m_map.jump(m_arc.at(m_met)) < kBreak) return true;
            if (!m_outline) m_outline = m_met;
        }
        m_hidden = behind, before = theta;
    }
    return false;
}

// Regula falsi, Illinois variant.
float March::root(float near, float far) const {
    float at_near = excess(near), at_far = excess(far), middle = far;
    for (int i = 0; i < kSecants; ++i) {
        middle = near + (far - near) * std::clamp(-at_near / std::max(at_far - at_near, 1e-20f), 0.0f, 1.0f);
        const float at_middle = excess(middle);
        if (std::fabs(at_middle) < kClose) break;
        if ((at_middle > 0) == (at_far > 0))
            far = middle, at_far = at_middle, at_near *= 0.5f;
        else
            near = middle, at_near = at_middle, at_far *= 0.5f;
    }
    return middle;
}

bool March::meets_far_away() {
    const float w = m_map.nearer(m_arc.d);
    if (!(w > 0)) return false;
    const float radius = 1 / w;
    m_met = std::sqrt(std::max(radius * radius - m_arc.reach * m_arc.reach, 0.0f)) - m_arc.along;
    return m_met > 0;
}

}  // namespace

void DepthImpostor::ends(std::span<const LightRay> rays, std::vector<RayEnd>& out) const {
    out.clear();
    const Matrix33f& to_map = m_distances->world_to_map();
    const Matrix33f to_world = to_map.transposed();
    for (uint32_t i = 0; i < rays.size(); ++i) {
        const LightRay& ray = rays[i];
        const Arc arc((ray.p - m_centre) * to_map, ray.d * to_map);
        March march(*m_distances, arc);
        const std::optional<float> distance = march.meet();
        if (!distance) {
            out.push_back(RayEnd::nowhere(i, ray.d));
            continue;
        }
        const Vec3f x = arc.at(*distance);
        const Vec3f n = march.ends_at_outline() ? -x : m_distances->gradient(x);
        out.push_back({i, 1.0f, x * to_world, n.normalized() * to_world, *distance});
    }
}

}  // namespace burnish
