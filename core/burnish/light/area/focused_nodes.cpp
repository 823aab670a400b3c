#include <burnish/light/area/focused_nodes.h>

#include <algorithm>

namespace burnish {
namespace {

/// Gauss-Legendre points of [0, 1].
struct Points {
    float place[4], weight[4];
};
constexpr Points kThree{{0.1127017f, 0.5f, 0.8872983f}, {5 / 18.0f, 8 / 18.0f, 5 / 18.0f}};
constexpr Points kFour{{0.0694318f, 0.3300095f, 0.6699905f, 0.9305682f}, {0.1739274f, 0.3260726f, 0.3260726f, 0.1739274f}};

constexpr float kDeepest = -0.5f;                // of Q: where a peak would be higher than its form allows
constexpr float kDeviationOfSide = 0.28867513f;  // of an even density, 1 / sqrt(12)

/// Distances from `centre` as tangents, in units of `scale`.
class Tangents {
public:
    Tangents(float centre, float scale, float low, float high) : m_centre(centre), m_scale(scale) {
        m_from = std::atan((low - centre) / scale);
        m_range = std::atan((high - centre) / scale) - m_from;
    }
    float tangent(const Points& points, int i) const { return std::tan(m_from + m_range * points.place[i]); }
    float place(float tangent) const { return m_centre + m_scale * tangent; }
    float width(const Points& points, int i, float tangent) const {
        return points.weight[i] * m_range * m_scale * (1 + tangent * tangent);
    }

private:
    float m_centre, m_scale, m_from, m_range;
};

/// Where a line of constant x cuts the polygon.
struct Cut {
    float low = INFINITY, high = -INFINITY;

    Cut(std::span<const Vec2f> corners, float x) {
        for (size_t i = 0; i < corners.size(); ++i) {
            const Vec2f &a = corners[i], &b = corners[(i + 1) % corners.size()];
            if ((a.x <= x) == (b.x <= x)) continue;
            const float y = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
            low = std::min(low, y), high = std::max(high, y);
        }
    }
};

}  // namespace

void focus_nodes(std::span<const Vec3f> corners, const PlaneQuadratic& q, int side, std::vector<FocusedNode>& nodes) {
    const Points& points = side == 3 ? kThree : kFour;
    nodes.clear();
    std::vector<Vec2f> flat;
    float low = INFINITY, high = -INFINITY;
    for (const Vec3f& corner : corners) {
        flat.emplace_back(q.axis_x.dot(corner - q.origin), q.axis_y.dot(corner - q.origin));
        low = std::min(low, flat.back().x), high = std::max(high, flat.back().x);
    }
    // The least value of Q on a line of constant x is least + 2 b x + a x^2.
    const float a = std::max(q.xx - q.xy * q.xy / q.yy, 1e-6f * q.xx), b = q.bx - q.xy * q.by / q.yy;
    const float least = q.at_origin - q.by * q.by / q.yy;
    const Tangents outer(-b / a, std::sqrt((1 + std::max(least - b * b / a, kDeepest)) / a), low, high);
    for (int i = 0; i < side; ++i) {
        const float tangent_x = outer.tangent(points, i), x = outer.place(tangent_x), width = outer.width(points, i, tangent_x);
        const Cut cut(flat, x);
        if (!(cut.low < cut.high)) continue;
        const float on_line = 1 + std::max(least + (2 * b + a * x) * x, kDeepest);
        const Tangents inner(-(q.by + q.xy * x) / q.yy, std::sqrt(on_line / q.yy), cut.low, cut.high);
        for (int j = 0; j < side; ++j) {
            const float tangent_y = inner.tangent(points, j), height = inner.width(points, j, tangent_y);
            nodes.push_back({q.origin + q.axis_x * x + q.axis_y * inner.place(tangent_y), q.axis_x * (width * kDeviationOfSide),
                             q.axis_y * (height * kDeviationOfSide), width * height});
        }
    }
}

}  // namespace burnish
