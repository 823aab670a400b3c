#include <burnish/scene/atlas_texels.h>

#include <algorithm>

namespace burnish {
namespace {

struct Triangle {
    Vertex a, b, c;
    Vec2f at_a, at_b, at_c;  // in texels, y down
};

struct Barycentric {
    float b, c;
};

/// The point of segment pq nearest to x, as a share of the way.
float along(const Vec2f& p, const Vec2f& q, const Vec2f& x) {
    const float length2 = (q - p).length2();
    return length2 > 0 ? std::clamp((x - p).dot(q - p) / length2, 0.0f, 1.0f) : 0.0f;
}

/// The point of the triangle nearest to x in the map.
Barycentric nearest(const Triangle& t, const Vec2f& x) {
    const Vec2f ab = t.at_b - t.at_a, ac = t.at_c - t.at_a, ax = x - t.at_a;
    const float area = ab.cross(ac), b = ax.cross(ac) / area, c = ab.cross(ax) / area;
    if (b >= 0 && c >= 0 && b + c <= 1) return {b, c};
    const float on_ab = along(t.at_a, t.at_b, x), on_bc = along(t.at_b, t.at_c, x), on_ca = along(t.at_c, t.at_a, x);
    const Barycentric candidates[] = {{on_ab, 0}, {1 - on_bc, on_bc}, {0, 1 - on_ca}};
    const auto distance = [&](const Barycentric& p) { return (t.at_a + ab * p.b + ac * p.c - x).length2(); };
    return *std::ranges::min_element(candidates, {}, distance);
}

void cover(const Triangle& t, int object, int size, std::vector<AtlasTexel>& texels) {
    const Vec3f ng = (t.b.p - t.a.p).cross(t.c.p - t.a.p).normalized();
    if (ng.length2() == 0) return;
    const auto first = [&](float x) { return std::max(static_cast<int>(std::floor(x - 1)), 0); };
    const auto last = [&](float x) { return std::min(static_cast<int>(std::ceil(x + 1)), size - 1); };
    for (int y = first(std::min({t.at_a.y, t.at_b.y, t.at_c.y})); y <= last(std::max({t.at_a.y, t.at_b.y, t.at_c.y})); ++y)
        for (int x = first(std::min({t.at_a.x, t.at_b.x, t.at_c.x})); x <= last(std::max({t.at_a.x, t.at_b.x, t.at_c.x}));
             ++x) {
            const Vec2f middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const Barycentric at = nearest(t, middle);
            const float aside = (t.at_a + (t.at_b - t.at_a) * at.b + (t.at_c - t.at_a) * at.c - middle).length();
            AtlasTexel& texel = texels[static_cast<size_t>(y) * static_cast<size_t>(size) + static_cast<size_t>(x)];
            if (!(aside < texel.aside)) continue;
            const float a = 1 - at.b - at.c;
            texel = {object, t.a.p * a + t.b.p * at.b + t.c.p * at.c, (t.a.n * a + t.b.n * at.b + t.c.n * at.c).normalized(),
                     ng, aside};
        }
}

}  // namespace

std::vector<AtlasTexel> atlas_texels(const Scene& scene, int size) {
    std::vector<AtlasTexel> texels(static_cast<size_t>(size) * static_cast<size_t>(size));
    const auto scale = static_cast<float>(size);
    const auto place = [&](const Vertex& v) { return Vec2f(v.uv.x * scale, (1 - v.uv.y) * scale); };
    for (size_t i = 0; i < scene.objects.size(); ++i) {
        const Mesh& mesh = scene.objects[i].mesh;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vertex &va = mesh.vertices[a], &vb = mesh.vertices[b], &vc = mesh.vertices[c];
            cover({va, vb, vc, place(va), place(vb), place(vc)}, static_cast<int>(i), size, texels);
        }
    }
    return texels;
}

void fill_gaps(Image& map, const std::vector<AtlasTexel>& texels, int rings) {
    std::vector<char> known(texels.size());
    std::ranges::transform(texels, known.begin(), [](const AtlasTexel& texel) { return texel.object >= 0; });
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<char> before = known;
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x) {
                const size_t pixel = static_cast<size_t>(y) * map.width + x;
                if (before[pixel]) continue;
                Color3f sum(0.0f);
                int count = 0;
                for (int j = std::max(y - 1, 0); j <= std::min(y + 1, map.height - 1); ++j)
                    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, map.width - 1); ++i) {
                        if (!before[static_cast<size_t>(j) * map.width + i]) continue;
                        const float* from = map.at(i, j);
                        sum += Color3f(from[0], from[1], from[2]);
                        ++count;
                    }
                if (count == 0) continue;
                for (int k = 0; k < 3; ++k) map.at(pixel)[k] = sum[k] / static_cast<float>(count);
                known[pixel] = 1;
            }
    }
}

}  // namespace burnish
