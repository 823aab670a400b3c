// Diffuse light against closed forms: a constant sky over a plane, under a canopy, and between two surfaces.
#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/diffuse.h>
#include <burnish/scene/gbuffer.h>
#include <burnish/scene/procedural_sky.h>

#include <gtest/gtest.h>

#include <cstring>

namespace burnish {
namespace {

const Color3f kSky(0.5f, 1.0f, 2.0f);

/// A sky of constant radiance, sampled evenly over the sphere.
DistantLight constant_sky(int count) {
    DistantLight light;
    light.radiance = [](const Vec3f&) { return kSky; };
    for (int i = 0; i < count; ++i) {
        const Vec2f u = owen_sobol(static_cast<uint32_t>(i), 5);
        const float z = 2 * u.x - 1, r = std::sqrt(std::max(0.0f, 1 - z * z)), phi = 2 * kPi * u.y;
        light.samples.push_back({{r * std::cos(phi), r * std::sin(phi), z}, kSky * (4 * kPi / static_cast<float>(count))});
    }
    return light;
}

Object object(const std::string& name, Mesh mesh, const Vec3f& offset, float albedo) {
    Matrix44f move;
    move.setTranslation(offset);
    return {name, "", transformed(std::move(mesh), move), 1, 1, Color3f(albedo), 1};
}

Irradiance at_origin(const Scene& scene, int samples, int bounces) {
    const Tracer tracer(scene);
    const DistantLight light = constant_sky(samples);
    const IrradianceGatherer gatherer(tracer, light, bounces);
    const auto hit = tracer.closest({0, 0, 0.25f}, {0, 0, -1});
    return gatherer.gather(*hit, 0, IrradianceGatherer::kRuns);
}

TEST(Irradiance, OpenPlaneUnderAConstantSkyReceivesPiTimesItsRadiance) {
    Scene scene;
    scene.objects.push_back(object("floor", make_plane(10, 10), {0, 0, 0}, 0.5f));
    const Irradiance e = at_origin(scene, 4096, 4);
    EXPECT_NEAR(e.direct.x, kPi * kSky.x, 2e-3 * kPi);
    EXPECT_NEAR(e.direct.z, kPi * kSky.z, 8e-3 * kPi);
    EXPECT_EQ(e.indirect.x, 0);
}

TEST(Irradiance, ABallOverheadTakesItsFormFactor) {
    // A sphere of radius R straight above, centre at distance h, hides (R / h)^2 of the cosine-weighted sky.
    Scene scene;
    scene.objects.push_back(object("floor", make_plane(10, 10), {0, 0, 0}, 0.5f));
    scene.objects.push_back(object("ball", make_sphere(1, 256), {0, 0, 2}, 0.0f));
    const Irradiance e = at_origin(scene, 16384, 0);
    EXPECT_NEAR(e.direct.y / (kPi * kSky.y), 1 - 0.25f, 4e-3);
}

TEST(Irradiance, NothingComesBetweenTwoWidePlates) {
    Scene scene;
    scene.objects.push_back(object("floor", make_plane(1000, 1000), {0, 0, 0}, 0.5f));
    scene.objects.push_back(object("ceiling", make_plane(1000, 1000), {0, 0, 0.5f}, 0.8f));
    const Irradiance e = at_origin(scene, 1024, 4);
    EXPECT_NEAR(e.direct.y, 0, 1e-2);
    EXPECT_NEAR(e.indirect.y, 0, 1e-2);
}

TEST(Irradiance, AWallBesideTheFloorHidesHalfTheSkyAndSendsBackItsAlbedo) {
    // A wall of albedo a, as good as infinite, has form factor 1/2 and sees half the sky (the floor hides the rest): it
    // receives L pi / 2, sends back a L / 2, of which a L pi / 4 arrives.
    Scene scene;
    scene.objects.push_back(object("floor", make_plane(1000, 1000), {0, 0, 0}, 0.0f));
    Matrix44f upright;
    upright.setEulerAngles(Vec3f(0, kPi / 2, 0));
    scene.objects.push_back(object("wall", transformed(make_plane(1000, 1000), upright), {-1, 0, 0}, 0.8f));
    const Irradiance e = at_origin(scene, 65536, 1024);
    EXPECT_NEAR(e.direct.y, kPi * kSky.y / 2, 0.01);
    EXPECT_NEAR(e.indirect.y, 0.8f * kSky.y * kPi / 4, 0.01);
}

TEST(Irradiance, RunsAverageToTheWhole) {
    Scene scene;
    scene.objects.push_back(object("floor", make_plane(10, 10), {0, 0, 0}, 0.5f));
    scene.objects.push_back(object("ball", make_sphere(1, 64), {0.5f, 0, 1.5f}, 0.5f));
    const Tracer tracer(scene);
    const DistantLight light = constant_sky(256);
    const IrradianceGatherer gatherer(tracer, light, 2);
    const Hit hit = *tracer.closest({0, 0, 0.25f}, {0, 0, -1});
    Irradiance mean;
    for (int run = 0; run < IrradianceGatherer::kRuns; ++run) mean += gatherer.gather(hit, run, 1) * (1.0f / 16);
    const Irradiance whole = gatherer.gather(hit, 0, IrradianceGatherer::kRuns);
    EXPECT_NEAR(mean.direct.y, whole.direct.y, 1e-4);
    EXPECT_NEAR(mean.indirect.y, whole.indirect.y, 1e-4);
}

TEST(Irradiance, RefusesSampleCountsThatDoNotFormRuns) {
    const Scene scene;
    const Tracer tracer(scene);
    for (const int count : {0, 8, 48}) {
        const DistantLight light = constant_sky(count);
        EXPECT_THROW(IrradianceGatherer(tracer, light, 1), Error) << count;
    }
}

struct Picture {
    Scene scene;
    Camera camera;

    Picture() {
        scene.objects.push_back(object("floor", make_plane(100, 100), {0, 0, 0}, 0.4f));
        scene.objects.push_back(object("ball", make_sphere(1, 256), {0, 0, 1}, 0.8f));
        camera.centre = {0, -6, 2};
        camera.axis = Vec3f(0, 1, -0.2f).normalized();
        camera.right = {0.8f, 0, 0};
        camera.up = camera.right.cross(camera.axis) * 0.5f;
        camera.has_rays = true;
    }

    AovFrame render(int antialias) const {
        const Tracer tracer(scene);
        const DistantLight light = constant_sky(512);
        AovFrame frame = trace_gbuffer(tracer, camera, 128, 64, {});
        add_diffuse(frame, tracer, light, {antialias, 2}, {});
        return frame;
    }
};

TEST(Diffuse, BeautyIsAlbedoTimesLightPlusSky) {
    const AovFrame frame = Picture().render(1);
    for (size_t i = 0; i < frame.layer(Role::beauty).pixel_count(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float light = frame.layer(Role::diffuse_albedo).at(i)[c] *
                                (frame.layer(Role::diffuse_direct).at(i)[c] + frame.layer(Role::diffuse_indirect).at(i)[c]);
            const float sky = *frame.layer(Role::depth).at(i) == kMissDepth ? (&kSky.x)[c] : 0;
            ASSERT_NEAR(frame.layer(Role::beauty).at(i)[c], light + sky, 1e-5);
        }
}

TEST(Diffuse, FloorFarFromTheBallShowsAlbedoTimesSky) {
    const AovFrame frame = Picture().render(2);
    double sum = 0;
    int count = 0;
    for (size_t i = 0; i < frame.layer(Role::beauty).pixel_count(); ++i) {
        const float* p = frame.layer(Role::position).at(i);
        if (*frame.layer(Role::normal).at(i) != 0 || p[1] < 20 || p[1] > 60) continue;
        sum += frame.layer(Role::beauty).at(i)[1], ++count;
    }
    ASSERT_GT(count, 100);
    EXPECT_NEAR(sum / count, 0.4 * kSky.y, 0.004);
}

TEST(Diffuse, AntialiasedEdgeLiesBetweenItsTwoSides) {
    const Picture picture;
    const AovFrame frame = picture.render(4);
    size_t mixed = 0;
    for (const float albedo : frame.layer(Role::diffuse_albedo).data) {
        ASSERT_GE(albedo, 0.0f);
        ASSERT_LE(albedo, 0.8f + 1e-6f);
        mixed += albedo > 0.41f && albedo < 0.79f;
    }
    EXPECT_GT(mixed, 60u);
}

TEST(Diffuse, IsTheSameForAnyThreadCount) {
    const auto rendered = [](int threads) {
        const ThreadLimit limit(threads);
        return Picture().render(2).layer(Role::beauty).data;
    };
    const PixelVector<float> one = rendered(1), two = rendered(2);
    EXPECT_EQ(std::memcmp(one.data(), two.data(), one.size() * sizeof(float)), 0);
}

TEST(ProceduralSky, SunStandsFarAboveTheRest) {
    const ProceduralSky sky;
    const float sun = luminance(sky.radiance(ProceduralSky::sun_direction()));
    const float ground = luminance(sky.radiance({0, 0, -1}));
    EXPECT_GT(sun / luminance(sky.radiance({0, 0, 1})), 10000);
    EXPECT_GT(sun / ground, 10000);
}

TEST(ProceduralSky, GroundSendsBackWhatTheUpperHalfGives) {
    const ProceduralSky sky;
    const Image picture = sky.picture(1024, 2);
    Color3f e(0.0f);
    for (int y = 0; y < picture.height / 2; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float theta = kPi * (static_cast<float>(y) + 0.5f) / static_cast<float>(picture.height);
            const float* c = picture.at(x, y);
            e += Color3f(c[0], c[1], c[2]) * (std::cos(theta) * std::sin(theta) * 2 * kPi * kPi / (1024.0f * 512.0f));
        }
    const float z = -0.15f;  // below the haze, above the shade under the objects
    const Color3f ground = sky.radiance({std::sqrt(1 - z * z), 0, z}) * kPi / ProceduralSky::ground_albedo();
    EXPECT_NEAR(ground.x / e.x, 1, 0.01);
    EXPECT_NEAR(ground.z / e.z, 1, 0.01);
}

}  // namespace
}  // namespace burnish
