#include <burnish/material/measured/scattered_colors.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <limits>

namespace burnish {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<float, 2, bg::cs::cartesian>;
using Entry = std::pair<Point, size_t>;

constexpr unsigned kNearest = 9;       // the farthest of them only says where weights end
constexpr float kSame = 1e-6f;         // nearer points are the same to a float of size 1
constexpr float kLeastSpread = 1e-4f;  // of the nearest points across, over their spread along

/// Mean of the neighbours' places and its spread, for the plane through their colours.
struct Moments {
    Vec2f mean{0, 0};
    float xx = 0, xy = 0, yy = 0;

    explicit Moments(const std::vector<ScatteredColors::Neighbour>& neighbours) {
        for (const auto& n : neighbours) mean += n.offset * n.weight;
        for (const auto& n : neighbours) {
            const Vec2f d = n.offset - mean;
            xx += n.weight * d.x * d.x, xy += n.weight * d.x * d.y, yy += n.weight * d.y * d.y;
        }
    }
    float determinant() const { return xx * yy - xy * xy; }
    /// Whether the points lie on a line, or all in one place.
    bool is_flat() const { return !(determinant() > kLeastSpread * (xx + yy) * (xx + yy)); }
};

}  // namespace

struct ScatteredColors::Tree {
    bg::index::rtree<Entry, bg::index::linear<16>> points;
};

ScatteredColors::ScatteredColors(const std::vector<Vec2f>& points, const std::vector<Color3f>& colors) : m_colors(colors) {
    std::vector<Entry> entries;
    for (size_t i = 0; i < points.size(); ++i) entries.emplace_back(Point(points[i].x, points[i].y), i);
    m_tree = std::make_shared<Tree>(Tree{{entries.begin(), entries.end()}});
}

std::vector<ScatteredColors::Neighbour> ScatteredColors::neighbours(const Vec2f& point) const {
    std::vector<Neighbour> found;
    const Point around(point.x, point.y);
    for (auto near = m_tree->points.qbegin(bg::index::nearest(around, kNearest)); near != m_tree->points.qend(); ++near)
        found.push_back({near->second, Vec2f(near->first.get<0>(), near->first.get<1>()) - point, 0});
    const auto distance = [](const Neighbour& n) { return n.offset.length(); };
    float nearest = std::numeric_limits<float>::max(), farthest = 0, total = 0;
    for (const Neighbour& n : found) nearest = std::min(nearest, distance(n)), farthest = std::max(farthest, distance(n));
    for (Neighbour& n : found) {
        const float d = distance(n);
        if (nearest <= kSame)
            n.weight = d <= kSame ? 1.0f : 0.0f;
        else if (farthest - nearest <= kSame)
            n.weight = 1;
        else
            n.weight = std::pow((1 - d / farthest) * nearest / d, 2.0f);
        total += n.weight;
    }
    for (Neighbour& n : found) n.weight /= total;
    std::erase_if(found, [](const Neighbour& n) { return n.weight == 0; });
    return found;
}

Color3f ScatteredColors::at(const Vec2f& point) const {
    const std::vector<Neighbour> near = neighbours(point);
    Color3f mean(0), low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
    for (const Neighbour& n : near) {
        const Color3f& color = m_colors[n.index];
        mean += color * n.weight;
        for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], color[c]), high[c] = std::max(high[c], color[c]);
    }
    const Moments moments(near);
    if (moments.is_flat()) return mean;
    Color3f by_x(0), by_y(0);
    for (const Neighbour& n : near) {
        const Vec2f d = n.offset - moments.mean;
        by_x += m_colors[n.index] * (n.weight * d.x), by_y += m_colors[n.index] * (n.weight * d.y);
    }
    const float gx = (moments.xy * moments.mean.y - moments.yy * moments.mean.x) / moments.determinant();
    const float gy = (moments.xy * moments.mean.x - moments.xx * moments.mean.y) / moments.determinant();
    Color3f value = mean + by_x * gx + by_y * gy;  // the plane where the offset is 0
    for (int c = 0; c < 3; ++c) value[c] = std::clamp(value[c], low[c], high[c]);
    return value;
}

}  // namespace burnish
