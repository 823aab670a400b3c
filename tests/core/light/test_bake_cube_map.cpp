// Cube maps of a scene: texels against rays traced by hand, and as Environment reads the file back.
#include <burnish/base/parallel.h>
#include <burnish/light/cube_map/bake_cube_map.h>
#include <burnish/light/environment.h>
#include <burnish/output/envmap_writer.h>
#include <burnish/sampling/sequence.h>
#include <burnish/scene/gbuffer.h>

#include <OpenImageIO/imageio.h>
#include <core/scratch.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

/// Inside a big ball whose light is smooth, beside a lamp that is hidden or not.
struct Dome {
    Scene scene;
    CubeMapView view{{0.5f, -1, 0.25f}, 32, 8, UpAxis::z, {}};
    LightMaps maps;

    Dome() {
        Matrix44f aside;
        aside.setTranslation(Vec3f(1.5f, -1, 0.25f));
        scene.objects.push_back({"dome", "", make_sphere(8, 256), 1, 1, Color3f(1.0f), 1});
        scene.objects.push_back(
            {"lamp", "", transformed(make_sphere(0.3f, 64), aside), 2, 2, Color3f(0.0f), 1, Color3f(50.0f)});
        maps.irradiance = Image(64, 32, 3);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x)
                for (int c = 0; c < 3; ++c)
                    maps.irradiance.at(x, y)[c] =
                        2 + std::sin(0.3f * static_cast<float>(x + 7 * c)) * std::cos(0.2f * static_cast<float>(y));
    }
};

TEST(BakeCubeMap, EnvironmentReadsBackWhatRaysSee) {
    for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
        Dome dome;
        dome.view.up = up, dome.view.hidden = {1}, dome.view.face_size = 128;
        const Tracer tracer(dome.scene);
        const SurfaceLight light(dome.scene, dome.maps);
        const Scratch scratch;
        write_cube_map(scratch.file("cube.exr"), bake_cube_map(tracer, light, dome.view, {}));
        EnvironmentSettings settings;
        settings.up = up;
        const Environment map = Environment::load(scratch.file("cube.exr"), settings);
        for (uint32_t i = 0; i < 1000; ++i) {
            const Vec2f u = owen_sobol(i, 5);
            const float z = 2 * u.x - 1, r = std::sqrt(1 - z * z), phi = 2 * kPi * u.y;
            const Vec3f d(r * std::cos(phi), r * std::sin(phi), z);
            const auto hit = tracer.closest(dome.view.centre, d, 0, kInfinitelyFar, dome.view.hidden);
            ASSERT_TRUE(hit);
            const Color3f expected = light.radiance(*hit), found = map.radiance(d * map.world_to_light());
            if (std::abs(hit->uv.x - 0.5f) > 0.47f || std::abs(hit->uv.y - 0.5f) > 0.45f) continue;  // the map's seam and poles
            ASSERT_NEAR(found.x, expected.x, 0.03 * expected.x + 0.01) << d.x << ' ' << d.y << ' ' << d.z;
            ASSERT_NEAR(found.z, expected.z, 0.03 * expected.z + 0.01);
        }
    }
}

TEST(BakeCubeMap, DistancesAreThoseOfTheMiddlesAndCoverIsWhatIsHit) {
    Dome dome;
    dome.scene.objects.erase(dome.scene.objects.begin());  // the lamp alone, under nothing
    const Tracer tracer(dome.scene);
    const CubeMapPicture picture = bake_cube_map(tracer, SurfaceLight(dome.scene, {}), dome.view, {});
    const int n = dome.view.face_size;
    double cover = 0;
    for (int y = 0; y < 6 * n; ++y)
        for (int x = 0; x < n; ++x) {
            const float* texel = picture.rgba.at(x, y);
            ASSERT_NEAR(texel[0], 50 * texel[3], 1e-4);
            if (y >= n) {
                ASSERT_EQ(texel[3], 0);
                ASSERT_EQ(*picture.distance.at(x, y), kMissDepth);
                continue;
            }
            cover += texel[3];
            const Vec3f d = Vec3f(1, (static_cast<float>(n) - 2 * (static_cast<float>(y) + 0.5f)) / static_cast<float>(n),
                                  (2 * (static_cast<float>(x) + 0.5f) - static_cast<float>(n)) / static_cast<float>(n))
                                .normalized();
            const float square = d.x * d.x - 1 + 0.09f;  // a ball of radius 0.3 at distance 1 along +X
            if (std::abs(square) < 2e-3f) continue;
            if (square > 0)
                ASSERT_NEAR(*picture.distance.at(x, y), d.x - std::sqrt(square), 1e-3 / std::sqrt(square));
            else
                ASSERT_EQ(*picture.distance.at(x, y), kMissDepth);
        }
    const double radius = 0.3 / std::sqrt(1 - 0.09) * n / 2;  // of its disc on the face, texels
    EXPECT_NEAR(cover, kPi * radius * radius, 0.02 * kPi * radius * radius);
}

TEST(BakeCubeMap, TheFileHoldsMapDistancesAndCentre) {
    const Dome dome;
    const Tracer tracer(dome.scene);
    const CubeMapPicture picture = bake_cube_map(tracer, SurfaceLight(dome.scene, dome.maps), dome.view, {});
    const Scratch scratch;
    write_cube_map(scratch.file("cube.exr"), picture);
    const auto in = OIIO::ImageInput::open(scratch.file("cube.exr"));
    ASSERT_TRUE(in);
    EXPECT_EQ(in->spec().get_string_attribute("textureformat"), "CubeFace Environment");
    const auto* centre = in->spec().find_attribute("burnish:centre");
    ASSERT_TRUE(centre);
    EXPECT_EQ(static_cast<const float*>(centre->data())[1], -1);
    const int z = in->spec().channelindex("Z");
    ASSERT_GE(z, 0);
    Image distance(picture.distance.width, picture.distance.height, 1);
    ASSERT_TRUE(in->read_image(0, 0, z, z + 1, OIIO::TypeFloat, distance.data.data()));
    EXPECT_EQ(distance.data, picture.distance.data);
}

TEST(BakeCubeMap, ThreadsDoNotChangeABitAndACallbackStopsIt) {
    const Dome dome;
    const Tracer tracer(dome.scene);
    const SurfaceLight light(dome.scene, dome.maps);
    const CubeMapPicture all = bake_cube_map(tracer, light, dome.view, {});
    const ThreadLimit limit(1);
    const CubeMapPicture one = bake_cube_map(tracer, light, dome.view, {});
    EXPECT_EQ(all.rgba.data, one.rgba.data);
    EXPECT_EQ(all.distance.data, one.distance.data);
    const Progress stop([](const std::string&, float done) { return done < 0.3f; });
    EXPECT_THROW(bake_cube_map(tracer, light, dome.view, stop), Error);
}

}  // namespace
}  // namespace burnish
