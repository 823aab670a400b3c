#include <burnish/light/focused_nodes.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kPlaces[] = {0.0694318f, 0.3300095f, 0.6699905f, 0.9305682f};
constexpr float kWeights[] = {0.1739274f, 0.3260726f, 0.3260726f, 0.1739274f};
constexpr float kDeepest = -0.5f;  // of Q: where a peak would be higher than its form allows

/// Distances from `centre` as tangents, in units of `scale`.
struct Tangents {
    float centre, scale, from, range;

    Tangents(float c, float s, float low, float high) : centre(c), scale(s) {
        from = std::atan((low - c) / s);
        range = std::atan((high - c) / s) - from;
    }
    float tangent(int i) const { return std::tan(from + range * kPlaces[i]); }
    float place(float tangent) const { return centre + scale * tangent; }
    float weight(int i, float tangent) const { return kWeights[i] * range * scale * (1 + tangent * tangent); }
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

void add_focused_nodes(std::span<const Vec3f> corners, const Color3f& radiance, const PlaneQuadratic& q,
                       std::vector<AreaNode>& nodes) {
    std::vector<Vec2f> flat;
    float low = INFINITY, high = -INFINITY;
    for (const Vec3f& corner : corners) {
        flat.emplace_back(q.axis_x.dot(corner - q.origin), q.axis_y.dot(corner - q.origin));
        low = std::min(low, flat.back().x), high = std::max(high, flat.back().x);
    }
    // Q's least value on a line of constant x is q.at_origin - by^2 / yy + 2 b x + a x^2.
    const float a = std::max(q.xx - q.xy * q.xy / q.yy, 1e-6f * q.xx), b = q.bx - q.xy * q.by / q.yy;
    const float least = q.at_origin - q.by * q.by / q.yy;
    const Tangents outer(-b / a, std::sqrt((1 + std::max(least - b * b / a, kDeepest)) / a), low, high);
    for (int i = 0; i < 4; ++i) {
        const float tangent_x = outer.tangent(i), x = outer.place(tangent_x);
        const Cut cut(flat, x);
        if (!(cut.low < cut.high)) continue;
        const float on_line = 1 + std::max(least + (2 * b + a * x) * x, kDeepest);
        const Tangents inner(-(q.by + q.xy * x) / q.yy, std::sqrt(on_line / q.yy), cut.low, cut.high);
        for (int j = 0; j < 4; ++j) {
            const float tangent_y = inner.tangent(j), area = outer.weight(i, tangent_x) * inner.weight(j, tangent_y);
            nodes.push_back({q.origin + q.axis_x * x + q.axis_y * inner.place(tangent_y), radiance * area, std::sqrt(area / kPi)});
        }
    }
}

}  // namespace burnish
