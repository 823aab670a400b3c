// Light of traced scenes against closed forms and brute force: what rays meet, cones with small lamps in them, draws of lamps.
#include "../chi_square.h"
#include "../scene/scene_files.h"

#include <burnish/base/error.h>
#include <burnish/light/traced/traced_light.h>
#include <burnish/sampling/sequence.h>

#include <Imath/half.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

/// Horizontal rectangle at height z that shines with grey `radiance`, downwards if asked.
Object panel(float half, const Vec3f& centre, float radiance, bool down) {
    Matrix44f turn, place;
    if (down) turn.setEulerAngles(Vec3f(kPi, 0, 0));
    place.setTranslation(centre);
    Object object{"panel", "", transformed(make_plane(half, half), turn * place), 1, 1, Color3f(0.0f)};
    object.emission = Color3f(radiance);
    return object;
}

TracedLight light_of(std::vector<Object> objects, int rays = 4) {
    return TracedLight(std::make_shared<const LitScene>(Scene{std::move(objects)}, LightMaps()), rays);
}

Incident lookup(const TracedLight& light, const LightRay& ray) {
    Incident found;
    light.lookup({&ray, 1}, {&found, 1});
    return found;
}

Vec3f direction(const Vec2f& u, float least_z) {
    const float z = least_z + (1 - least_z) * u.x, r = std::sqrt(1 - z * z), phi = 2 * kPi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), z};
}

Vec3f rounded(const Vec3f& p) { return {Imath::half(p.x), Imath::half(p.y), Imath::half(p.z)}; }

/// Mean over the cone of a downward panel of radiance 1, by the midpoint rule over its area; nothing stands between.
double share_of_panel(const LightRay& ray, float half, const Vec3f& centre) {
    constexpr int kSteps = 400;
    const double step = 2.0 * half / kSteps, sigma2 = ray.sigma * ray.sigma;
    const double norm = 1 / (2 * kPi * sigma2 * -std::expm1(-2 / sigma2));
    double sum = 0;
    for (int j = 0; j < kSteps; ++j)
        for (int i = 0; i < kSteps; ++i) {
            const Imath::V3d way(centre.x - half + (i + 0.5) * step - ray.p.x, centre.y - half + (j + 0.5) * step - ray.p.y,
                                 centre.z - ray.p.z);
            const double distance = way.length(), cosine = way.z / distance;
            sum += norm * std::exp((way.dot(Imath::V3d(ray.d)) / distance - 1) / sigma2) * cosine / (distance * distance);
        }
    return sum * step * step;
}

}  // namespace

TEST(TracedLight, RaysThroughAPaneMeetWhatIsBehindIt) {
    Object pane{"pane", "", make_box({1, 1, 0.05f}, 0.01f, 1), 2, 2, Color3f(0.5f)};
    const TracedLight light = light_of({pane, panel(1, {0, 0, -2}, 3, false)});
    const Vec3f on(0, 0, 0.05f), up(0, 0, 1), down(0, 0, -1);
    EXPECT_EQ(light.exact({on, up, down, 0, -1}).radiance, Color3f(3.0f));
    EXPECT_GT(lookup(light, {on, up, down, 0.05f, -1}).radiance.x, 2.9f);
    EXPECT_EQ(light.exact({on, up, down, 0, 1}).radiance, Color3f(0.0f)) << "the pane's own far side is in the way";
}

TEST(TracedLight, ExactReadsWhatTheRayMeetsAndCoversNothingElse) {
    const TracedLight light = light_of({panel(1, {0, 0, 2}, 3, true)});
    const ExactLight hit = light.exact({{0, 0, 0}, {0, 0, 1}, {0, 0, 1}});
    EXPECT_EQ(hit.radiance, Color3f(3.0f));
    EXPECT_EQ(hit.cover, 1);
    const ExactLight back = light.exact({{0, 0, 4}, {0, 0, -1}, {0, 0, -1}});
    EXPECT_EQ(back.radiance, Color3f(0.0f));
    EXPECT_EQ(back.cover, 1);
    const ExactLight miss = light.exact({{0, 0, 0}, {0, 0, 1}, Vec3f(1, 0, 1).normalized()});
    EXPECT_EQ(miss.cover, 0);
    EXPECT_EQ(miss.radiance, Color3f(0.0f));
}

TEST(TracedLight, CoverIsTheShareOfTheConeThatMeetsTheScene) {
    Object half_sky = panel(50, {50, 0, 1}, 0, true);
    half_sky.emission = Color3f(1, 1, 1);
    const TracedLight light = light_of({half_sky}, 64);
    for (const float sigma : {0.02f, 0.2f}) {
        const Incident found = lookup(light, {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, sigma});
        EXPECT_NEAR(found.cover, 0.5f, 0.04f);
        EXPECT_NEAR(found.radiance.x, 0.5f, 0.06f);
        EXPECT_NEAR(found.nearness, 1, 0.1f);
        EXPECT_GT(found.bend, 0.24f / (sigma * sigma));
    }
}

TEST(TracedLight, RaysNeitherMeetTheSurfaceTheyLeaveNorStartBehindIt) {
    for (const float height : {0.0f, 0.1234f, 3.777f}) {
        const TracedLight light = light_of({panel(60, {0, 0, height}, 1, false), panel(4000, {0, 0, height + 2}, 2, true)});
        for (uint32_t i = 0; i < 2000; ++i) {
            const Vec2f at = owen_sobol(i, 1);
            const Vec3f p(40 * at.x - 20, 40 * at.y - 20, height), d = direction(owen_sobol(i, 2), 2e-3f);
            for (const Vec3f& from : {p, rounded(p)}) {
                ASSERT_EQ(light.exact({from, {0, 0, 1}, d}).radiance.x, 2) << from << d;
                ASSERT_EQ(light.exact({from, {0, 0, 1}, {d.x, d.y, -d.z}}).cover, 0) << from << d;
            }
        }
    }
}

TEST(TracedLight, ConesFindSmallLampsInThem) {
    const float half = 0.1f;
    const Vec3f centre(0.3f, 0.2f, 2);
    const TracedLight light = light_of({panel(50, {0, 0, 0}, 0, false), panel(half, centre, 1, true)});
    for (const float sigma : {0.03f, 0.1f, 0.3f, 0.6f}) {
        double sum = 0, expected = 0, error = 0;
        for (uint32_t i = 0; i < 300; ++i) {
            const Vec2f u = owen_sobol(i, 4), v = owen_sobol(i, 5);
            const Vec3f target = centre + Vec3f(u.x - 0.5f, u.y - 0.5f, 0) * (3 * sigma);
            const Vec3f p(v.x, v.y, 0);
            const LightRay ray{p, {0, 0, 1}, (target - p).normalized(), sigma};
            const double found = lookup(light, ray).radiance.x, share = share_of_panel(ray, half, centre);
            sum += found, expected += share, error += (found - share) * (found - share);
        }
        EXPECT_NEAR(sum / expected, 1, 0.05) << sigma;
        EXPECT_LT(std::sqrt(error / 300), 0.2 * expected / 300) << sigma;
    }
}

TEST(TracedLight, LampsAreHiddenByWhatStandsBefore) {
    const TracedLight light = light_of({panel(0.1f, {0, 0, 2}, 50, true), panel(0.5f, {0, 0, 1}, 0, true)});
    EXPECT_EQ(lookup(light, {{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, 0.1f}).radiance.x, 0);
    EXPECT_GT(lookup(light, {{2, 0, 0}, {0, 0, 1}, Vec3f(-1, 0, 1).normalized(), 0.1f}).radiance.x, 0.1f);
}

TEST(TracedLight, SamplesDrawLampsWithTheDensityThatExactTells) {
    const TracedLight light =
        light_of({panel(20, {0, 0, 0}, 0, false), panel(0.5f, {0, 0, 2}, 5, true), panel(0.5f, {0, 0, 4}, 10, true)});
    ASSERT_TRUE(light.can_sample());
    const Vec3f p(0, 0, 0), ng(0, 0, 1);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    // A chart of directions: places on the plane z = 2 within 1 of its middle.
    const auto draw = [&]() -> std::optional<SquarePoint> {
        const LightDraw drawn = light.sample(p, Vec2f(uniform(random), uniform(random)));
        EXPECT_FLOAT_EQ(drawn.pdf, light.exact({p, ng, drawn.d}).pdf);
        const Vec3f at = drawn.d * (2 / drawn.d.z);
        return SquarePoint{0.5 + 0.5 * at.x, 0.5 + 0.5 * at.y};
    };
    const auto density = [&](const SquarePoint& s) {
        const Vec3f way(static_cast<float>(2 * s.a - 1), static_cast<float>(2 * s.b - 1), 2);
        const double distance = way.length(), cosine = way.z / distance;
        return 4 * cosine / (distance * distance) * light.exact({p, ng, way.normalized()}).pdf;
    };
    const ChiSquare test = chi_square(20000, 24, draw, density);
    EXPECT_GT(test.p_value, 1e-3) << test.statistic << " of " << test.degrees;
    EXPECT_NEAR(test.mass, 1, 2e-3);
}

TEST(TracedLight, LampsShineFromTheirFrontsOnly) {
    const TracedLight light = light_of({panel(20, {0, 0, 0}, 0, false), panel(0.5f, {0, 0, 2}, 5, true)});
    EXPECT_EQ(light.sample({0, 0, 3}, {0.5f, 0.5f}).pdf, 0);
    EXPECT_EQ(light.exact({{0, 0, 3}, {0, 0, 1}, {0, 0, -1}}).pdf, 0);
    EXPECT_FALSE(light_of({panel(1, {0, 0, 0}, 1, false)}).can_sample());
}

TEST(TracedLight, LampsAreFoundInLightMaps) {
    Image map(64, 64, 3, 0.1f);
    for (int y = 0; y < 32; ++y) std::fill_n(map.at(0, y), 3 * 64, 7.0f);
    Object dark = panel(2, {0, 0, 2}, 0, true), bright = panel(0.5f, {4, 0, 2}, 0, true);
    for (Vertex& vertex : dark.mesh.vertices) vertex.uv.y *= 0.4f;
    for (Vertex& vertex : bright.mesh.vertices) vertex.uv.y = 0.6f + 0.3f * vertex.uv.y;
    const auto scene = std::make_shared<const LitScene>(Scene{{dark, bright}}, LightMaps{.radiance = map});
    const Vec3f d = TracedLight(scene, 4).sample({0, 0, 0}, {0.3f, 0.7f}).d, at = d * (2 / d.z);
    EXPECT_NEAR(at.x, 4, 0.5f);
    EXPECT_NEAR(at.y, 0, 0.5f);
    for (const Lamps::Point& point : scene->lamps().points()) EXPECT_NEAR(point.radiance.x, 7, 1e-4f);
}

TEST(TracedLight, GivesARayTheSameBitsInAnyBatch) {
    const TracedLight light =
        light_of({panel(5, {0, 0, 0}, 0.5f, false), panel(0.2f, {0, 0, 2}, 9, true), panel(5, {0, 0, 3}, 1, true)});
    std::vector<LightRay> rays;
    for (uint32_t i = 0; i < 200; ++i) {
        const Vec2f u = owen_sobol(i / 4, 1);
        const Vec3f d = direction(owen_sobol(i, 2), 0.01f);
        rays.push_back({{u.x, u.y, 0}, {0, 0, 1}, i % 4 == 3 ? -d : d, 0.02f + 0.2f * u.x});
    }
    std::vector<Incident> together(rays.size());
    light.lookup(rays, together);
    for (size_t i = 0; i < rays.size(); ++i) {
        const Incident alone = lookup(light, rays[i]);
        EXPECT_EQ(alone.radiance, together[i].radiance);
        EXPECT_EQ(alone.bend, together[i].bend);
        EXPECT_EQ(alone.nearness, together[i].nearness);
        EXPECT_EQ(alone.cover, together[i].cover);
    }
}

TEST(TracedLight, RefusesUnknownNumbersOfRays) {
    const auto scene = std::make_shared<const LitScene>(Scene{{panel(1, {0, 0, 0}, 1, false)}}, LightMaps());
    EXPECT_THROW(TracedLight(scene, 0), Error);
    EXPECT_THROW(TracedLight(scene, 65), Error);
}

TEST(LitScene, ConvertsColoursOfMaterials) {
    const Scratch folder;
    TracedSettings settings;
    settings.scene = burnish_test::written(folder, "lamp.glb", burnish_test::square_glb());
    const LitScene scene(settings, [](Image& picture) { std::swap(picture.at(0)[0], picture.at(0)[2]); });
    const ExactLight found = TracedLight(std::make_shared<const LitScene>(settings), 1, Color3f(2.0f))
                                 .exact({{0.5f, 0.5f, 3}, {0, 0, -1}, {0, 0, -1}});
    EXPECT_EQ(found.radiance, Color3f(16, 8, 4));
    EXPECT_EQ(scene.light().radiance(*scene.tracer().closest({0.5f, 0.5f, 3}, {0, 0, -1})), Color3f(2, 4, 8));
}

TEST(LitScene, RefusesScenesWithoutLight) {
    const Scratch folder;
    nlohmann::json dark = burnish_test::square_gltf();
    dark["materials"][0].erase("emissiveFactor");
    TracedSettings settings;
    settings.scene = burnish_test::written(folder, "dark.glb", burnish_test::glb(dark.dump(), burnish_test::square_buffer()));
    try {
        const LitScene scene(settings);
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_argument);
        EXPECT_NE(std::string(error.what()).find("the scene has no light"), std::string::npos);
    }
}

TEST(RayBundle, SpreadsAsMuchAsTheGaussian) {
    for (const int rays : {1, 2, 4, 7, 16, 64}) {
        const RayBundle bundle(rays);
        double square = 2 * bundle.part() * bundle.part();
        for (const Vec2f& place : bundle.places()) square += place.length2() / static_cast<double>(rays);
        EXPECT_NEAR(square, 2, 1e-4) << rays;
    }
}

TEST(RayBundle, ConesHaveMassOneAboveTheHorizon) {
    const Vec3f up(0, 0, 1);
    for (const float sigma : {0.1f, 0.5f})
        for (const float height : {1.0f, 0.3f, 0.0f}) {
            const Cone cone(Vec3f(std::sqrt(1 - height * height), 0, height), up, sigma);
            constexpr uint32_t kCount = 1 << 18;
            double mass = 0;
            for (uint32_t i = 0; i < kCount; ++i)
                mass += cone.density(cone.squares(direction(hammersley(i, kCount), 0))) * 2 * kPi / kCount;
            EXPECT_NEAR(mass, 1, 5e-3) << sigma << " " << height;
        }
}
