#include <burnish/light/area/seen_polygon.h>

#include <burnish/light/filter/light_curvature.h>
#include <burnish/sampling/spherical_triangle.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kFar = 5.5f;                      // deviations from where a Gaussian has nothing left, to a float
constexpr float kEdgeOn = 1e-5f;                  // height over size, from where a polygon is seen as a line
constexpr float kReach = 4.5f;                    // deviations up to where edges are followed
constexpr float kStep = 0.6f;                     // longest straight line on the map, radian
constexpr float kNarrowest = 1e-6f, kWidest = 3;  // radian
constexpr float kSteepest = 0.2420f;              // largest second derivative of the Gaussian integral, 1 / sqrt(2 pi e)

/// Share of a normal distribution beyond x deviations.
float beyond(float x) { return 0.5f * std::erfc(x * std::numbers::sqrt2_v<float> * 0.5f); }

/// T(h, k / h) for k <= h, by five Gauss-Legendre points.
float owen_narrow(float h, float k) {
    constexpr float kPlaces[] = {0.0469101f, 0.2307653f, 0.5f, 0.7692347f, 0.9530899f},
                    kWeights[] = {0.1184634f, 0.2393143f, 0.2844444f, 0.2393143f, 0.1184634f};
    if (h <= 0) return 0;
    const float a = k / h;
    float sum = 0;
    for (int i = 0; i < 5; ++i) {
        const float x = a * kPlaces[i], stretch = 1 + x * x;
        sum += kWeights[i] * std::exp(-0.5f * h * h * stretch) / stretch;
    }
    return sum * a / (2 * kPi);
}

/// Owen's T(h, k / h), h >= 0; odd in k, which may be infinite.
float owen(float h, float k) {
    if (h > kFar) return 0;
    const float reach = std::fabs(k);
    if (reach <= h) return std::copysign(owen_narrow(h, reach), k);
    const float q = beyond(h), wide = 0.5f * q;
    if (reach > kFar) return std::copysign(wide, k);
    const float r = beyond(reach);
    return std::copysign(wide + 0.5f * r - q * r - owen_narrow(reach, h), k);
}

/// Bound of the Gaussian integral's second derivative within the reach of kCurvatureReach about x deviations.
float steepest_about(float x) {
    const float nearest = std::max(x - kCurvatureReach, 0.0f);
    if (nearest <= 1) return kSteepest;
    return nearest * std::exp(-0.5f * nearest * nearest) *
           (0.5f * std::numbers::inv_sqrtpi_v<float> * std::numbers::sqrt2_v<float>);
}

/// What lies beyond the line from a to b, seen from the origin between its ends; negative where it runs clockwise.
float taken_away(const Vec2f& a, const Vec2f& b) {
    const Vec2f way = b - a;
    const float length = way.length();
    if (!(length > 0)) return 0;
    const float side = (a.x * b.y - a.y * b.x) / length, h = std::fabs(side);
    if (h > kFar) return 0;
    return std::copysign(owen(h, b.dot(way) / length) - owen(h, a.dot(way) / length), side);
}

/// Lambert's equal-area map of the sphere about d: distances are chords, 2 sin(angle / 2), in deviations.
class LambertMap {
public:
    LambertMap(const Vec3f& d, float sigma) : m_frame(Frame::around(d)), m_per_radian(1 / sigma) {}

    Vec2f operator()(const Vec3f& direction) const {
        const float half = 0.5f * (1 + direction.dot(m_frame.n)), scale = m_per_radian / std::sqrt(std::max(half, 1e-6f));
        return Vec2f(direction.dot(m_frame.t), direction.dot(m_frame.b)) * scale;
    }
    Vec3f direction(const Vec2f& place) const {
        const Vec2f chord = place / m_per_radian;
        const float c2 = std::min(chord.length2(), 4.0f), flat = std::sqrt(1 - 0.25f * c2);
        return (m_frame.t * chord.x + m_frame.b * chord.y) * flat + m_frame.n * (1 - 0.5f * c2);
    }
    /// Cosine of the angle to d so many deviations away.
    float cosine_at(float deviations) const {
        const float chord = std::min(deviations / m_per_radian, 2.0f);
        return 1 - 0.5f * chord * chord;
    }

private:
    Frame m_frame;
    float m_per_radian;
};

/// An edge on the map, as far as the Gaussian about d reaches: straight lines between points of the great circle, places on which
/// are angles from its point nearest to d.
class MappedEdge {
public:
    MappedEdge(const LambertMap& map, const Vec3f& d, const Vec3f& inward) : m_map(map) {
        const float sine = inward.dot(d), cosine = std::sqrt(std::max(1 - sine * sine, 1e-12f));
        m_foot = (d - inward * sine) / cosine, m_along = inward.cross(d) / cosine;
        m_reach = std::acos(std::min(map.cosine_at(kReach) / cosine, 1.0f));
    }

    void follow(const Vec3f& from, const Vec3f& to) {
        const float begin = place(from), end = place(to);
        nearest = m_map(at(begin <= 0 && end >= 0 ? 0 : std::fabs(begin) < std::fabs(end) ? begin : end));
        if (begin > end)  // round the far side
            add(begin, kPi), add(-kPi, end);
        else
            add(begin, std::min(end, 0.0f)), add(std::max(begin, 0.0f), end);
    }

    float lost = 0;    // of the Gaussian
    Vec2f nearest{0};  // point of the edge, deviations

private:
    float place(const Vec3f& corner) const { return std::atan2(corner.dot(m_along), corner.dot(m_foot)); }
    Vec3f at(float angle) const { return m_foot * std::cos(angle) + m_along * std::sin(angle); }
    void add(float from, float to) {
        const float begin = std::max(from, -m_reach), end = std::min(to, m_reach);
        if (!(begin < end)) return;
        const int steps = static_cast<int>(std::ceil((end - begin) / kStep));
        Vec2f here = m_map(at(begin));
        for (int i = 1; i <= steps; ++i) {
            const Vec2f next = m_map(at(begin + (end - begin) * static_cast<float>(i) / static_cast<float>(steps)));
            lost += taken_away(here, next);
            here = next;
        }
    }

    const LambertMap& m_map;
    Vec3f m_foot, m_along;
    float m_reach;
};

}  // namespace

void SeenPolygon::look(const ConvexPolygon& polygon, const Vec3f& from, const Vec3f& up, bool both_sides) {
    m_edges.clear(), m_corners.clear(), m_solid_angle = 0;
    const float height = polygon.height(from);
    if (!(std::fabs(height) > kEdgeOn * polygon.size) || (height < 0 && !both_sides)) return;
    polygon.above(from, up, m_corners);
    const size_t count = m_corners.size();
    if (height > 0) std::reverse(m_corners.begin(), m_corners.end());  // who looks at its front sees it turn the other way
    for (Vec3f& corner : m_corners) corner = (corner - from).normalized();
    for (size_t i = 0; i < count; ++i) {
        const Vec3f &begin = m_corners[i], &end = m_corners[(i + 1) % count], across = begin.cross(end - begin);
        if (across.length2() > 0) m_edges.push_back({begin, end, across.normalized()});
    }
    for (size_t i = 1; i + 1 < count; ++i)
        m_solid_angle += static_cast<float>(SphericalTriangle(m_corners[0], m_corners[i], m_corners[i + 1]).solid_angle());
}

GaussianPart SeenPolygon::gaussian(const Vec3f& d, float width) const {
    GaussianPart part;
    if (m_edges.empty()) return part;
    const float sigma = std::clamp(width, kNarrowest, kWidest), narrow = 1 / (sigma * sigma);
    const LambertMap map(d, sigma);
    bool inside = true;
    float lost = 0, bend = 0, nearest = INFINITY;
    for (const Edge& edge : m_edges) {
        MappedEdge mapped(map, d, edge.inward);
        mapped.follow(edge.begin, edge.end);
        const float distance = mapped.nearest.length();
        lost += mapped.lost, bend += steepest_about(distance);
        inside = inside && edge.inward.dot(d) >= 0;
        if (distance < nearest) nearest = distance, part.nearest = map.direction(mapped.nearest);
    }
    if (inside) part.nearest = d;
    part.share = std::clamp(((inside ? 1.0f : 0.0f) - lost) / -std::expm1(-2 * narrow), 0.0f, 1.0f);
    if (!inside && nearest > kFar + kCurvatureReach) return {};
    const float most = m_solid_angle * narrow / (2 * kPi);  // of the peak's height all over
    part.bend = narrow * std::min(bend, most);
    part.reach =
        inside ? std::min(1.0f, most) : std::min(beyond(std::max(nearest - kCurvatureReach, 0.0f)) * 2, std::min(1.0f, most));
    return part;
}

}  // namespace burnish
