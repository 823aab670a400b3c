#include <burnish/light/area/area_nodes.h>

#include <algorithm>
#include <array>

namespace burnish {
namespace {

constexpr int kMost = 3;  // points along a side

/// Gauss-Legendre points of [0, 1].
struct Points {
    int count;
    std::array<float, kMost> place, weight;
};
constexpr std::array<Points, kMost> kPoints{{{1, {0.5f}, {1}},
                                             {2, {0.2113249f, 0.7886751f}, {0.5f, 0.5f}},
                                             {3, {0.1127017f, 0.5f, 0.8872983f}, {5 / 18.0f, 8 / 18.0f, 5 / 18.0f}}}};

/// Of each quadrilateral of a polygon: the more of them, the fewer.
const Points& points_for(size_t corners) {
    const size_t pieces = (corners - 1) / 2;
    return kPoints[pieces == 1 ? kMost - 1 : pieces <= 4 ? 1 : 0];
}

/// The polynomial that is 1 at one of the points and 0 at the others.
float lagrange(const Points& points, int of, float x) {
    float value = 1;
    for (int i = 0; i < points.count; ++i)
        if (i != of) value *= (x - points.place[i]) / (points.place[of] - points.place[i]);
    return value;
}

/// Its integral over cell `cell` of `cells` equal ones.
float lagrange_mean(const Points& points, int of, int cell, int cells) {
    const Points& two = kPoints[1];
    float sum = 0;
    for (int i = 0; i < two.count; ++i)
        sum += two.weight[i] * lagrange(points, of, (static_cast<float>(cell) + two.place[i]) / static_cast<float>(cells));
    return sum / static_cast<float>(cells);
}

/// Mean of picture times polynomial, for the polynomial of point (i, j).
Color3f weight_in(const AreaPicture& picture, const Points& points, int i, int j) {
    const Image& rgb = picture.rgb();
    std::vector<float> columns(static_cast<size_t>(rgb.width));
    for (int x = 0; x < rgb.width; ++x) columns[static_cast<size_t>(x)] = lagrange_mean(points, i, x, rgb.width);
    Imath::V3d sum(0, 0, 0);
    for (int y = 0; y < rgb.height; ++y) {
        Imath::V3d row(0, 0, 0);
        for (int x = 0; x < rgb.width; ++x) {
            const float* texel = rgb.at(x, y);
            row += Imath::V3d(texel[0], texel[1], texel[2]) * columns[static_cast<size_t>(x)];
        }
        sum += row * lagrange_mean(points, j, rgb.height - 1 - y, rgb.height);
    }
    return Color3f(Vec3f(sum));
}

/// The points of one quadrilateral a b c d, which may have c = d.
struct Quadrilateral {
    Vec3f a, b, c, d;

    void add(const Points& points, const Color3f& radiance, std::vector<AreaNode>& nodes) const {
        for (int j = 0; j < points.count; ++j)
            for (int i = 0; i < points.count; ++i) {
                const float u = points.place[i], v = points.place[j];
                const Vec3f along = (b - a) * (1 - v) + (c - d) * v, across = (d - a) * (1 - u) + (c - b) * u;
                const float area = along.cross(across).length() * points.weight[i] * points.weight[j];
                const Vec3f p = a + (b - a) * (u * (1 - v)) + (c - a) * (u * v) + (d - a) * ((1 - u) * v);
                nodes.push_back({p, radiance * area, std::sqrt(area / kPi)});
            }
    }
};

}  // namespace

void add_area_nodes(std::span<const Vec3f> corners, const Color3f& radiance, std::vector<AreaNode>& nodes) {
    const Points& points = points_for(corners.size());
    for (size_t i = 1; i + 1 < corners.size(); i += 2) {
        const Vec3f& last = corners[std::min(i + 2, corners.size() - 1)];
        Quadrilateral{corners[0], corners[i], corners[i + 1], last}.add(points, radiance, nodes);
    }
}

std::vector<AreaNode> area_nodes(const ConvexPolygon& polygon, const Color3f& radiance, const AreaPicture* picture) {
    std::vector<AreaNode> nodes;
    add_area_nodes(polygon.corners, radiance, nodes);
    if (!picture) return nodes;
    const Points& points = points_for(polygon.corners.size());
    for (int j = 0; j < points.count; ++j)
        for (int i = 0; i < points.count; ++i)
            nodes[static_cast<size_t>(j * points.count + i)].power =
                radiance * weight_in(*picture, points, i, j) * polygon.area;
    return nodes;
}

}  // namespace burnish
