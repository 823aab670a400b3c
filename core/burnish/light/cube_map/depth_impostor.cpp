#include <burnish/light/cube_map/depth_impostor.h>

namespace burnish {
namespace {

constexpr float kSegment = 2 * DistanceMap::kReach;  // radian of the arc, skipped or followed
constexpr float kBreak = 1.3f;                       // from one texel to the next: the surface ends there
constexpr float kLeastCosine = 1e-3f;                // beyond, the rest of the arc goes in one direction
constexpr int kSecants = 8;
constexpr float kClose = 1e-5f;

/// An angle seen from the centre, between -pi / 2 and pi / 2; 0 is where the ray is nearest.
struct Angle {
    float cosine, sine;

    static Angle of(float radian) { return {std::cos(radian), std::sin(radian)}; }
    /// Turned on, not beyond `last`.
    Angle turned(const Angle& by, const Angle& last) const {
        const Angle next{cosine * by.cosine - sine * by.sine, sine * by.cosine + cosine * by.sine};
        return next.sine >= last.sine || next.cosine < 0 ? last : next;
    }
    Angle halfway(const Angle& to) const {
        const float c = cosine + to.cosine, s = sine + to.sine, length = std::sqrt(c * c + s * s);
        return {c / length, s / length};
    }
};

/// A ray from o along d in the map's axes.
struct Arc {
    Vec3f o, d, side;    // side: unit, from the centre to the nearest point
    float reach, along;  // distance of the nearest point from the centre; from there to o

    Arc(const Vec3f& origin, const Vec3f& direction) : o(origin), d(direction), along(origin.dot(direction)) {
        const Vec3f nearest = o - d * along;
        reach = nearest.length();
        side = reach > 0 ? nearest / reach : Frame::around(d).t;
        reach = std::max(reach, 1e-6f * std::max(o.length(), 1e-6f));
    }
    Angle start() const {
        const float length = std::sqrt(reach * reach + along * along);
        return {reach / length, along / length};
    }
    Vec3f toward(const Angle& angle) const { return side * angle.cosine + d * angle.sine; }
    float distance(const Angle& angle) const { return reach * angle.sine / angle.cosine - along; }
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
    bool is_behind(const Angle& angle) const { return m_map.nearer(m_arc.toward(angle)) * m_arc.reach > angle.cosine; }
    /// Whether the arc from one to the other is in front of all that is about it.
    bool is_clear(const Angle& from, const Angle& to) const {
        return m_map.bound(m_arc.toward(from.halfway(to))) * m_arc.reach < std::min(from.cosine, to.cosine);
    }
    /// Where the excess changes its sign between two distances.
    float root(float near, float far) const;
    /// Follows the arc step by step; true when it met a surface, then at m_met.
    bool follow(const Angle& from, const Angle& to);
    /// The rest of the arc.
    bool meets_far_away();

    const DistanceMap& m_map;
    const Arc& m_arc;
    bool m_hidden = false, m_at_outline = false;
    float m_met = 0;
    std::optional<float> m_outline;
};

std::optional<float> March::meet() {
    static const Angle segment = Angle::of(kSegment), last{kLeastCosine, std::sqrt(1 - kLeastCosine * kLeastCosine)};
    m_hidden = excess(0) > 0;
    for (Angle here = m_arc.start(); here.sine < last.sine;) {
        const Angle next = here.turned(segment, last);
        if (is_clear(here, next))
            m_hidden = false;
        else if (follow(here, next))
            return m_met;
        here = next;
    }
    if (!m_hidden && meets_far_away()) return m_met;
    m_at_outline = m_outline.has_value();
    return m_outline;
}

bool March::follow(const Angle& from, const Angle& to) {
    const Angle step = Angle::of(kSegment / static_cast<float>(std::clamp(m_map.size() / 32, 4, 32)));
    for (Angle before = from; before.sine < to.sine;) {
        const Angle here = before.turned(step, to);
        const bool behind = is_behind(here);
        if (behind && !m_hidden) {
            m_met = root(std::max(m_arc.distance(before), 0.0f), m_arc.distance(here));
            if (m_map.jump(m_arc.at(m_met)) < kBreak) return true;
            if (!m_outline) m_outline = m_met;
        }
        m_hidden = behind, before = here;
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
