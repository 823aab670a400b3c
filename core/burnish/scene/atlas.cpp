#include <burnish/base/error.h>
#include <burnish/scene/atlas.h>

#include <Imath/ImathBox.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace burnish {
namespace {

constexpr float kFacing = 0.7f;   // least cosine between the normals of a chart's triangle and its first one
constexpr float kFlat = 0.9962f;  // of those that may lie anywhere; others must be near, lest a chart overlaps itself
constexpr float kNear = 0.25f;    // of the object's diagonal

struct Chart {
    size_t object;
    std::vector<uint32_t> triangles;
    Vec3f x, y;  // unit, in the plane of the chart
    Vec2f low, extent;
    Vec2f place{0, 0};  // of the upper left corner in the map, texels
};

struct Bits {
    std::array<uint32_t, 3> xyz;
    explicit Bits(const Vec3f& p) : xyz{bits(p.x), bits(p.y), bits(p.z)} {}
    static uint32_t bits(float v) { return std::bit_cast<uint32_t>(v == 0 ? 0.0f : v); }
    bool operator==(const Bits&) const = default;
};
struct BitsHash {
    size_t operator()(const Bits& b) const {
        return (b.xyz[0] * 73856093ull) ^ (b.xyz[1] * 19349663ull) ^ (b.xyz[2] * 83492791ull);
    }
};

/// For every vertex the number of its place.
std::vector<uint32_t> welded(const Mesh& mesh) {
    std::unordered_map<Bits, uint32_t, BitsHash> places;
    std::vector<uint32_t> place;
    for (const Vertex& vertex : mesh.vertices)
        place.push_back(places.emplace(Bits(vertex.p), static_cast<uint32_t>(places.size())).first->second);
    return place;
}

/// Triangles by the places they touch.
class Neighbours {
public:
    explicit Neighbours(const Mesh& mesh) : m_mesh(mesh), m_place(welded(mesh)), m_begin(m_place.size() + 2) {
        for (const auto& triangle : mesh.triangles)
            for (const uint32_t i : triangle) ++m_begin[m_place[i] + 2];
        std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
        m_triangles.resize(3 * mesh.triangles.size());
        for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (const uint32_t i : mesh.triangles[t]) m_triangles[m_begin[m_place[i] + 1]++] = t;
    }
    template <class Visit>
    void visit(uint32_t triangle, const Visit& visit) const {
        for (const uint32_t i : m_mesh.triangles[triangle])
            for (uint32_t k = m_begin[m_place[i]]; k < m_begin[m_place[i] + 1]; ++k) visit(m_triangles[k]);
    }

private:
    const Mesh& m_mesh;
    std::vector<uint32_t> m_place, m_begin, m_triangles;
};

Vec3f corner(const Mesh& mesh, uint32_t triangle, size_t i) { return mesh.vertices[mesh.triangles[triangle][i]].p; }

Vec3f normal_of(const Mesh& mesh, uint32_t t) {
    return (corner(mesh, t, 1) - corner(mesh, t, 0)).cross(corner(mesh, t, 2) - corner(mesh, t, 0)).normalized();
}

/// Triangles without are hit by nothing and need no place.
bool has_area(const Mesh& mesh, uint32_t t) { return normal_of(mesh, t).length2() > 0; }

float diagonal(const Mesh& mesh) {
    Imath::Box3f box;
    for (const Vertex& vertex : mesh.vertices) box.extendBy(vertex.p);
    return mesh.vertices.empty() ? 0.0f : box.size().length();
}

/// Turns the chart so that its rectangle is the smallest that has a side along an edge of the first triangle.
void frame(Chart& chart, const Mesh& mesh, const Vec3f& normal) {
    float least = std::numeric_limits<float>::infinity();
    for (size_t edge = 0; edge < 3; ++edge) {
        const uint32_t first = chart.triangles[0];
        const Frame axes = Frame::along(normal, corner(mesh, first, (edge + 1) % 3) - corner(mesh, first, edge));
        Imath::Box2f box;
        for (const uint32_t t : chart.triangles)
            for (size_t i = 0; i < 3; ++i) box.extendBy({corner(mesh, t, i).dot(axes.t), corner(mesh, t, i).dot(axes.b)});
        const Vec2f extent = box.size();
        if (extent.x * extent.y >= least) continue;
        least = extent.x * extent.y;
        chart.x = axes.t, chart.y = axes.b, chart.low = box.min, chart.extent = extent;
    }
    if (chart.extent.x >= chart.extent.y) return;  // lying charts make low shelves
    const Vec3f x = chart.x;
    chart.x = chart.y, chart.y = -x;
    chart.low = {chart.low.y, -chart.low.x - chart.extent.x};
    std::swap(chart.extent.x, chart.extent.y);
}

void find_charts(const Scene& scene, size_t object, std::vector<Chart>& charts) {
    const Mesh& mesh = scene.objects[object].mesh;
    const Neighbours neighbours(mesh);
    const float near = kNear * diagonal(mesh);
    std::vector<char> taken(mesh.triangles.size(), 0);
    for (uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (taken[seed] || !has_area(mesh, seed)) continue;
        const Vec3f n = normal_of(mesh, seed), centre = corner(mesh, seed, 0);
        Chart chart{object, {seed}, {}, {}, {}, {}};
        taken[seed] = 1;
        for (size_t i = 0; i < chart.triangles.size(); ++i)
            neighbours.visit(chart.triangles[i], [&](uint32_t t) {
                const float facing = taken[t] || !has_area(mesh, t) ? 0.0f : normal_of(mesh, t).dot(n);
                if (!(facing > kFacing) || (facing < kFlat && (corner(mesh, t, 0) - centre).length() > near)) return;
                taken[t] = 1;
                chart.triangles.push_back(t);
            });
        frame(chart, mesh, n);
        charts.push_back(std::move(chart));
    }
}

/// Texels that a chart takes along x or y.
int texels(float extent, float density) { return static_cast<int>(std::ceil(extent * density)) + 1 + 2 * kAtlasMargin; }

/// Puts the charts, tallest first, on shelves; false when they do not fit.
bool place(std::vector<Chart>& charts, float density, int size) {
    int x = 0, y = 0, shelf = 0;
    for (Chart& chart : charts) {
        const int width = texels(chart.extent.x, density), height = texels(chart.extent.y, density);
        if (x + width > size) x = 0, y += shelf, shelf = 0;
        if (width > size || y + height > size) return false;
        chart.place = {static_cast<float>(x + kAtlasMargin) + 0.5f, static_cast<float>(y + kAtlasMargin) + 0.5f};
        x += width, shelf = std::max(shelf, height);
    }
    return true;
}

/// The greatest density at which the charts fit, to 1 %.
float densest(std::vector<Chart>& charts, int size) {
    double area = 0;
    for (const Chart& chart : charts) area += static_cast<double>(chart.extent.x) * chart.extent.y;
    float density = area > 0 ? static_cast<float>(size / std::sqrt(area)) : 1.0f;
    for (int step = 0; step < 2000 && !place(charts, density, size); ++step) density *= 0.99f;
    if (!place(charts, density, size))
        throw Error(ErrorCode::bad_argument, "the scene's surfaces fall into " + std::to_string(charts.size()) +
                                                 " charts, too many for a light map of " + std::to_string(size) +
                                                 " texels a side; make it larger");
    return density;
}

constexpr std::array<uint32_t, 3> kNoTriangle{0, 0, 0};

/// The meshes with the charts' texture coordinates, triangles in their old order.
void apply(Scene& scene, const std::vector<Chart>& charts, float density, int size) {
    std::vector<std::vector<Vertex>> vertices(scene.objects.size());
    std::vector<std::vector<std::array<uint32_t, 3>>> triangles(scene.objects.size());
    for (size_t i = 0; i < scene.objects.size(); ++i) triangles[i].resize(scene.objects[i].mesh.triangles.size(), kNoTriangle);
    for (const Chart& chart : charts) {
        const Mesh& mesh = scene.objects[chart.object].mesh;
        std::unordered_map<uint32_t, uint32_t> copies;
        for (const uint32_t t : chart.triangles)
            for (size_t k = 0; k < 3; ++k) {
                const uint32_t old = mesh.triangles[t][k];
                const auto [at, fresh] = copies.emplace(old, static_cast<uint32_t>(vertices[chart.object].size()));
                triangles[chart.object][t][k] = at->second;
                if (!fresh) continue;
                Vertex vertex = mesh.vertices[old];
                const Vec2f from_low = Vec2f(vertex.p.dot(chart.x), vertex.p.dot(chart.y)) - chart.low;
                const Vec2f texel = chart.place + Vec2f(from_low.x, chart.extent.y - from_low.y) * density;
                vertex.uv = {texel.x / static_cast<float>(size), 1 - texel.y / static_cast<float>(size)};
                vertices[chart.object].push_back(vertex);
            }
    }
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        std::erase(triangles[i], kNoTriangle);
        scene.objects[i].mesh.vertices = std::move(vertices[i]);
        scene.objects[i].mesh.triangles = std::move(triangles[i]);
    }
}

}  // namespace

float lay_out_atlas(Scene& scene, int size) {
    std::vector<Chart> charts;
    for (size_t i = 0; i < scene.objects.size(); ++i) find_charts(scene, i, charts);
    std::ranges::stable_sort(charts, [](const Chart& a, const Chart& b) { return a.extent.y > b.extent.y; });
    const float density = densest(charts, size);
    apply(scene, charts, density, size);
    return density;
}

}  // namespace burnish
