// Light maps against closed forms: form factors of a square lamp, and the light inside a closed shining ball.
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/scene/atlas.h>
#include <burnish/scene/atlas_texels.h>
#include <burnish/scene/bake_light_map.h>

#include <gtest/gtest.h>

#include <set>

namespace burnish {
namespace {

constexpr float kPanelHeight = 2, kPanelHalf = 0.5f;

Mesh turned_down(Mesh mesh, float z) {
    Matrix44f m;
    m.setEulerAngles(Vec3f(kPi, 0, 0));
    m[3][2] = z;
    return transformed(std::move(mesh), m);
}

/// A floor below a square lamp that shines down.
Scene floor_and_lamp() {
    Scene scene;
    scene.objects.push_back({"floor", "", make_plane(3, 2), 1, 1, Color3f(0.5f), 1});
    scene.objects.push_back(
        {"lamp", "", turned_down(make_plane(kPanelHalf, kPanelHalf), kPanelHeight), 2, 2, Color3f(0.0f), 1, {8, 4, 2}});
    return scene;
}

/// Form factor from a point of a horizontal plane to the parallel rectangle [0, a] x [0, b] at height h over it.
double corner_factor(double a, double b, double h) {
    const double x = a / h, y = b / h, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * std::numbers::pi);
}
double lamp_factor(double x, double y) {
    const auto signed_factor = [](double a, double b) {
        return std::copysign(1.0, a * b) * corner_factor(std::abs(a), std::abs(b), kPanelHeight);
    };
    const double r = kPanelHalf;
    return signed_factor(x + r, y + r) - signed_factor(x - r, y + r) - signed_factor(x + r, y - r) +
           signed_factor(x - r, y - r);
}

/// Calls `visit(texel, light)` for all texels that have a point of `object` in their middle.
template <class Visit>
int for_each_texel(const Scene& scene, const Image& map, int object, const Visit& visit) {
    const std::vector<AtlasTexel> texels = atlas_texels(scene, map.width);
    int count = 0;
    for (size_t i = 0; i < texels.size(); ++i) {
        if (texels[i].object != object || texels[i].aside > 0) continue;
        visit(texels[i], map.at(i));
        ++count;
    }
    return count;
}

TEST(LightMap, ASquareLampLightsAFloorByItsFormFactor) {
    Scene scene = floor_and_lamp();
    lay_out_atlas(scene, 96);
    const Tracer tracer(scene);
    const Image map = bake_light_map(tracer, {.size = 96, .lamp_samples = 64, .bounces = 0}, {});
    double squares = 0, worst = 0;
    const int count = for_each_texel(scene, map, 0, [&](const AtlasTexel& texel, const float* light) {
        const double factor = lamp_factor(texel.p.x, texel.p.y);
        const double error = light[0] / (8 * factor) - 1;
        squares += error * error, worst = std::max(worst, std::abs(error));
        EXPECT_FLOAT_EQ(light[2] * 4, light[0]);
    });
    EXPECT_GT(count, 2000);
    EXPECT_LT(std::sqrt(squares / count), 0.005);
    EXPECT_LT(worst, 0.03);
}

TEST(LightMap, LampsShineOnTheirFrontOnlyAndWhatIsHiddenCastsNoShadow) {
    Scene scene = floor_and_lamp();
    scene.objects.push_back({"ceiling", "", turned_down(make_plane(3, 2), kPanelHeight + 0.5f), 3, 1, Color3f(0.5f), 1});
    scene.objects.push_back({"shade", "", turned_down(make_plane(3, 2), 1), 4, 1, Color3f(0.5f), 1});
    lay_out_atlas(scene, 128);
    const Tracer tracer(scene);
    const auto brightest = [&](const Image& map, int object) {
        float most = 0;
        for_each_texel(scene, map, object, [&](const AtlasTexel&, const float* light) { most = std::max(most, light[0]); });
        return most;
    };
    LightMapSettings settings{.size = 128, .lamp_samples = 16, .bounces = 0};
    const Image dark = bake_light_map(tracer, settings, {});
    EXPECT_EQ(brightest(dark, 0), 0);
    EXPECT_EQ(brightest(dark, 2), 0);
    settings.hidden = {3};
    const Image lit = bake_light_map(tracer, settings, {});
    EXPECT_NEAR(brightest(lit, 0), 8 * lamp_factor(0, 0), 0.03 * 8 * lamp_factor(0, 0));
    EXPECT_EQ(brightest(lit, 2), 0);
}

TEST(LightMap, EveryBounceInAShiningBallAddsAPowerOfItsAlbedo) {
    Scene scene;
    Mesh inside = make_sphere(2, 128);
    for (auto& triangle : inside.triangles) std::swap(triangle[1], triangle[2]);
    for (Vertex& vertex : inside.vertices) vertex.n = -vertex.n;
    scene.objects.push_back({"ball", "", std::move(inside), 1, 1, Color3f(0.5f), 1, Color3f(3.0f)});
    lay_out_atlas(scene, 256);
    const Tracer tracer(scene);
    const Image map = bake_light_map(tracer, {.size = 256, .lamp_samples = 16, .bounce_samples = 4, .bounces = 3}, {});
    const float expected = 3 * (1 + 0.5f + 0.25f + 0.125f);
    double sum = 0;
    const int count = for_each_texel(scene, map, 0, [&](const AtlasTexel&, const float* light) { sum += light[1]; });
    EXPECT_GT(count, 5000);
    EXPECT_NEAR(sum / count, expected, 0.002 * expected);
}

TEST(LightMap, ThreadsDoNotChangeABitAndDarkScenesAreRefused) {
    Scene scene = floor_and_lamp();
    lay_out_atlas(scene, 64);
    const LightMapSettings settings{.size = 64, .lamp_samples = 4, .bounce_samples = 2, .bounces = 2};
    const Image all = bake_light_map(Tracer(scene), settings, {});
    const ThreadLimit limit(1);
    EXPECT_EQ(all.data, bake_light_map(Tracer(scene), settings, {}).data);
    scene.objects[1].emission = Color3f(0.0f);
    EXPECT_THROW(bake_light_map(Tracer(scene), settings, {}), Error);
}

/// Of every point of the scene, one place; and of every texel, at most one chart nearby.
TEST(Atlas, ChartsDoNotOverlapAndKeepTheirShape) {
    Scene scene;
    scene.objects.push_back({"knot", "", make_torus_knot(2, 3, 1, 0.3f, 128, 24), 1, 1, Color3f(0.5f), 1});
    scene.objects.push_back({"box", "", make_box({1, 0.5f, 0.25f}, 0.05f, 3), 2, 1, Color3f(0.5f), 1});
    const Scene before = scene;
    constexpr int kSize = 512;
    const float density = lay_out_atlas(scene, kSize);
    std::vector<int> owner(kSize * kSize, -1);
    int twice = 0, inside = 0;
    double area = 0, area_in_map = 0;
    for (size_t o = 0; o < scene.objects.size(); ++o) {
        const Mesh &mesh = scene.objects[o].mesh, &old = before.objects[o].mesh;
        ASSERT_EQ(mesh.triangles.size(), old.triangles.size());
        for (size_t t = 0; t < mesh.triangles.size(); ++t) {
            Vec2f uv[3];
            for (size_t k = 0; k < 3; ++k) {
                const Vertex& vertex = mesh.vertices[mesh.triangles[t][k]];
                ASSERT_EQ(vertex.p, old.vertices[old.triangles[t][k]].p);
                ASSERT_EQ(vertex.n, old.vertices[old.triangles[t][k]].n);
                uv[k] = vertex.uv * static_cast<float>(kSize);
                for (const float x : {uv[k].x, uv[k].y}) ASSERT_TRUE(x > kAtlasMargin && x < kSize - kAtlasMargin);
            }
            const auto& [a, b, c] = old.triangles[t];
            area += 0.5 * (old.vertices[b].p - old.vertices[a].p).cross(old.vertices[c].p - old.vertices[a].p).length();
            const double signed_area = 0.5 * (uv[1] - uv[0]).cross(uv[2] - uv[0]);
            ASSERT_GE(signed_area, 0);  // none turned over
            area_in_map += signed_area;
            const Vec2f middle = (uv[0] + uv[1] + uv[2]) / 3;
            int& texel = owner[static_cast<size_t>(middle.y) * kSize + static_cast<size_t>(middle.x)];
            const Vertex& vertex = mesh.vertices[mesh.triangles[t][0]];
            if (texel >= 0) {
                const Mesh& other = scene.objects[static_cast<size_t>(texel >> 16)].mesh;
                const Vertex& there = other.vertices[other.triangles[static_cast<size_t>(texel & 0xffff)][0]];
                twice += (there.p - vertex.p).length() > 8 / density;
            }
            texel = static_cast<int>(o << 16 | t);
            ++inside;
        }
    }
    EXPECT_GT(inside, 6000);
    EXPECT_EQ(twice, 0);
    EXPECT_GT(area_in_map / (density * density), 0.8 * area);
    EXPECT_LE(area_in_map / (density * density), 1.001 * area);
    EXPECT_THROW(lay_out_atlas(scene, 8), Error);
}

}  // namespace
}  // namespace burnish
