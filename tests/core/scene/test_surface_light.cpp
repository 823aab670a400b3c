// Light maps over texture coordinates: their orientation, their averages, and what leaves fronts and backs.
#include <burnish/base/error.h>
#include <burnish/scene/map_pyramid.h>
#include <burnish/scene/surface_light.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr int kSize = 64;

/// Linear in place: red rises with u, green with v.
Image ramp() {
    Image image(kSize, kSize, 3);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            image.at(x, y)[0] = (static_cast<float>(x) + 0.5f) / kSize;
            image.at(x, y)[1] = 1 - (static_cast<float>(y) + 0.5f) / kSize;
            image.at(x, y)[2] = 2;
        }
    return image;
}

/// A square of 4 x 4 scene units that faces up, with uv 0 to 1 along x and y.
Scene square() {
    Scene scene;
    scene.objects.push_back({"square", "", make_plane(2, 2), 1, 1, Color3f(0.5f, 0.25f, 1), 1, Color3f(3, 2, 1)});
    return scene;
}

Hit hit_at(const Tracer& tracer, float x, float y, float from = 1) { return *tracer.closest({x, y, from}, {0, 0, -from}); }

void expect_near(const Color3f& a, const Color3f& b, float tolerance) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance) << "channel " << k;
}

TEST(SurfaceLight, ReadsMapsWithURightAndVUp) {
    const Scene scene = square();
    const Tracer tracer(scene);
    const SurfaceLight light(scene, {.radiance = ramp()});
    for (const Vec2f& p : {Vec2f(-1, -1.5f), Vec2f(0.3f, 1.2f), Vec2f(1.7f, 0.01f)})
        for (const float diameter : {0.0f, 0.2f, 0.35f})
            expect_near(light.radiance(hit_at(tracer, p.x, p.y), diameter), {(p.x + 2) / 4, (p.y + 2) / 4, 2}, 2e-3f);
}

TEST(SurfaceLight, IsAlbedoTimesIrradianceAndEmissionOnTheFrontOnly) {
    const Scene scene = square();
    const Tracer tracer(scene);
    const Hit front = hit_at(tracer, 0, 0), back = hit_at(tracer, 0, 0, -1);
    EXPECT_TRUE(front.front);
    EXPECT_FALSE(back.front);
    const SurfaceLight plain(scene, {});
    expect_near(plain.radiance(front), {3, 2, 1}, 0);
    expect_near(plain.radiance(back), {0, 0, 0}, 0);
    const SurfaceLight lit(scene, {.irradiance = ramp()});
    expect_near(lit.radiance(front), {3 + 0.25f, 2 + 0.125f, 1 + 2}, 1e-5f);
    expect_near(lit.radiance(back), {0.25f, 0.125f, 2}, 1e-5f);
    const SurfaceLight mapped(scene, {.irradiance = ramp(), .albedo = ramp()});
    expect_near(mapped.radiance(back), {0.25f, 0.25f, 4}, 1e-5f);
    const SurfaceLight baked(scene, {.radiance = Image(8, 8, 3, 2.5f)});
    expect_near(baked.radiance(back), {0, 0.5f, 1.5f}, 1e-5f);
}

TEST(SurfaceLight, WideLookupsAverageADisc) {
    Image noise(kSize, kSize, 3);
    uint32_t state = 1;
    for (float& value : noise.data) value = static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / (1 << 24);
    const MapPyramid map(noise, 2);
    const float diameter = map.widest();
    double error = 0, spread = 0;
    for (int y = 16; y < 48; ++y)
        for (int x = 16; x < 48; ++x) {
            double sum = 0, area = 0;
            for (int j = y - 8; j <= y + 8; ++j)
                for (int i = x - 8; i <= x + 8; ++i)
                    if ((i - x) * (i - x) + (j - y) * (j - y) < diameter * diameter / 4) sum += noise.at(i, j)[0], ++area;
            const float u = (static_cast<float>(x) + 0.5f) / kSize, v = 1 - (static_cast<float>(y) + 0.5f) / kSize;
            error += std::pow(map.at({u, v}, diameter)[0] - sum / area, 2.0);
            spread += std::pow(sum / area - 0.5, 2.0);
        }
    EXPECT_LT(error, 0.6 * spread);
}

TEST(SurfaceLight, AnyPlaceAndWidthIsSafe) {
    const MapPyramid map(ramp(), 9);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const float a : {nan, inf, -inf, 1e30f, -5.0f, 0.5f})
        for (const float width : {nan, inf, 0.0f, 1e9f, 3.0f}) {
            const Color3f value = map.at({a, -a}, width);
            EXPECT_NEAR(value[2], 2, 1e-5f);
            EXPECT_TRUE(is_finite(value));
        }
}

TEST(SurfaceLight, SaysHowWideItsLookupsReach) {
    const Scene scene = square();
    const Tracer tracer(scene);
    EXPECT_NEAR(SurfaceLight(scene, {.radiance = ramp(), .halvings = 2}).widest(hit_at(tracer, 0, 0)), 8 * 4.0f / kSize, 1e-5f);
    const SurfaceLight smaller(scene, {.irradiance = Image(kSize / 2, kSize / 2, 3), .albedo = ramp()});
    EXPECT_NEAR(smaller.widest(hit_at(tracer, 0, 0)), 4 * 4.0f / (kSize / 2), 1e-5f);
    EXPECT_EQ(SurfaceLight(scene, {}).widest(hit_at(tracer, 0, 0)), 0);
}

TEST(SurfaceLight, RefusesMapsThatAreNotRgb) {
    const Scene scene = square();
    EXPECT_THROW(SurfaceLight(scene, {.irradiance = Image(4, 4, 4)}), Error);
}

}  // namespace
}  // namespace burnish
