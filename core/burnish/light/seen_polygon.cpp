#include <burnish/light/seen_polygon.h>

#include <burnish/light/light_curvature.h>
#include <burnish/sampling/spherical_triangle.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kFar = 5.5f;          // deviations from where a Gaussian has nothing left, to a float
constexpr float kEdgeOn = 1e-5f;      // height over size, from where a polygon is seen as a line
constexpr float kChord = 2.2f;        // deviations
constexpr float kNarrowest = 1e-6f;   // radian
constexpr float kSteepest = 0.2420f;  // largest second derivative of the Gaussian integral, 1 / sqrt(2 pi e)

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
        const float chord = std::min(deviations / m_per_radian, std::numbers::sqrt2_v<float>);
        return 1 - 0.5f * chord * chord;
    }

private:
    Frame m_frame;
    float m_per_radian;
};

/// An edge on the map: straight lines from its point nearest to d to both sides. As great circles bend there, a line has the
/// direction of the chord up to where most of the Gaussian is.
struct MappedEdge {
    float lost = 0;    // of the Gaussian
    Vec2f nearest{0};  // deviations

    MappedEdge(const LambertMap& map, const Vec3f& d, const Vec3f& from, const Vec3f& to, const Vec3f& inward) {
        const Vec3f along = inward.cross(d);
        const float sine = inward.dot(d), cosine2 = std::max(1 - sine * sine, 1e-12f);
        const Vec3f foot = (d - inward * sine) / cosine2;  // along and foot span the great circle, d . foot = 1
        const float behind = along.dot(from), ahead = along.dot(to);
        const bool passes = behind < 0 && ahead > 0;
        nearest = map(passes ? foot / foot.length() : behind >= 0 ? from : to);
        if (nearest.length2() > kFar * kFar) return;
        const float turn = map.cosine_at(std::max(kChord, nearest.length() + 0.5f));
        const auto line_to = [&](const Vec3f& corner, float side) {
            const Vec2f end = map(corner) - nearest;
            if (corner.dot(d) >= turn) return nearest + end;
            const float aside = std::copysign(std::sqrt(std::max(cosine2 - turn * turn, 0.0f)) / cosine2, side);
            const Vec2f chord = map(foot * turn + along * aside) - nearest;
            return nearest + chord * (end.length() / std::max(chord.length(), 1e-6f));
        };
        if (behind < 0) lost += taken_away(line_to(from, behind), nearest);
        if (ahead > 0) lost += taken_away(nearest, line_to(to, ahead));
    }
};

}  // namespace

void SeenPolygon::look(const ConvexPolygon& polygon, const Vec3f& from, bool both_sides) {
    m_edges.clear(), m_solid_angle = 0;
    const float height = polygon.height(from);
    if (!(std::fabs(height) > kEdgeOn * polygon.size) || (height < 0 && !both_sides)) return;
    const size_t count = polygon.corners.size();
    std::vector<Edge>& edges = m_edges;
    edges.resize(count);
    for (size_t i = 0; i < count; ++i)  // clockwise seen from the light's back is counter-clockwise for who looks at its front
        edges[i].begin = (polygon.corners[height > 0 ? count - 1 - i : i] - from).normalized();
    for (size_t i = 0; i < count; ++i) {
        edges[i].end = edges[(i + 1) % count].begin;
        edges[i].inward = edges[i].begin.cross(edges[i].end - edges[i].begin).normalized();
    }
    for (size_t i = 1; i + 1 < count; ++i)
        m_solid_angle += static_cast<float>(SphericalTriangle(edges[0].begin, edges[i].begin, edges[i].end).solid_angle());
}

GaussianPart SeenPolygon::gaussian(const Vec3f& d, float width) const {
    GaussianPart part;
    if (m_edges.empty()) return part;
    const float sigma = std::max(width, kNarrowest), narrow = 1 / (sigma * sigma);
    const LambertMap map(d, sigma);
    bool inside = true;
    float lost = 0, bend = 0, nearest = INFINITY;
    for (const Edge& edge : m_edges) {
        const MappedEdge mapped(map, d, edge.begin, edge.end, edge.inward);
        const float distance = mapped.nearest.length();
        lost += mapped.lost, bend += steepest_about(distance);
        inside = inside && edge.inward.dot(d) >= 0;
        if (distance < nearest) nearest = distance, part.nearest = map.direction(mapped.nearest);
    }
    if (inside) part.nearest = d;
    part.share = std::clamp((inside ? 1.0f : 0.0f) - lost, 0.0f, 1.0f);
    part.bend = narrow * std::min(bend, m_solid_angle * narrow / (2 * kPi));
    return part;
}

}  // namespace burnish
