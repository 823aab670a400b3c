// Which way is which: the identities of the lat-long conventions, and real files that show the same light twice.
#include "core/data.h"
#include "light_pictures.h"

#include <burnish/light/environment.h>
#include <burnish/light/latlong.h>

#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace burnish_test;

namespace {

using Convention = EnvironmentConvention;

/// A picture whose red and green are smooth functions of the place in it (periodic in u).
Color3f color_at(float u, float v) { return {0.5f + 0.5f * std::cos(2 * kPi * u), 0.5f + 0.5f * std::sin(2 * kPi * u), v}; }

Environment smooth(Convention convention, UpAxis up, float rotate_deg = 0, bool flip = false) {
    Image image(1024, 512, 3);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Color3f c = color_at((x + 0.5f) / image.width, (y + 0.5f) / image.height);
            std::copy_n(&c.x, 3, image.at(x, y));
        }
    }
    EnvironmentSettings settings;
    settings.convention = convention, settings.up = up, settings.rotate_deg = rotate_deg, settings.flip = flip;
    settings.face_size = 16;
    return Environment::from_image(image, settings, "smooth");
}

Color3f world_radiance(const Environment& light, const Vec3f& d) { return light.radiance(d * light.world_to_light()); }

/// Every world direction sees the picture at (u, v) = place(d).
template <class Place>
void expect_mapping(const Environment& light, Place&& place) {
    Directions random;
    for (int i = 0; i < 2000; ++i) {
        const Vec3f d = random.next();
        const auto [u, v] = place(d);
        ASSERT_LT((world_radiance(light, d) - color_at(u, v)).length(), 5e-3f) << d;
    }
}

std::pair<float, float> place(float u, float v) { return {u, v}; }

}  // namespace

TEST(LatLong, DirectionAndPlaceAreInverse) {
    Directions random;
    for (int i = 0; i < 100000; ++i) {
        const Vec3f d = random.next();
        ASSERT_LT((latlong_direction(latlong_coord(d)) - d).length(), 1e-6f);
    }
    EXPECT_EQ(latlong_coord({0, 1, 0}).y, 0.0f);
    EXPECT_FLOAT_EQ(latlong_coord({0, -1, 0}).y, 1.0f);
}

TEST(Orientation, OpenExrYUpHasZInTheMiddleAndXAtAQuarter) {
    expect_mapping(smooth(Convention::openexr, UpAxis::y),
                   [](const Vec3f& d) { return place(0.5f - std::atan2(d.x, d.z) / (2 * kPi), 0.5f - std::asin(d.y) / kPi); });
}

TEST(Orientation, BlenderZUpHasXInTheMiddleAndYAtAQuarter) {
    expect_mapping(smooth(Convention::blender, UpAxis::z),
                   [](const Vec3f& d) { return place(0.5f - std::atan2(d.y, d.x) / (2 * kPi), std::acos(d.z) / kPi); });
}

TEST(Orientation, BlenderYUpIsThreeJs) {
    expect_mapping(smooth(Convention::blender, UpAxis::y),
                   [](const Vec3f& d) { return place(std::atan2(d.z, d.x) / (2 * kPi) + 0.5f, std::acos(d.y) / kPi); });
}

TEST(Orientation, OpenExrYUpIsMitsuba) {
    expect_mapping(smooth(Convention::openexr, UpAxis::y),
                   [](const Vec3f& d) { return place(std::atan2(d.x, -d.z) / (2 * kPi), std::acos(d.y) / kPi); });
}

TEST(Orientation, BlenderIsOpenExrTurnedByAQuarter) {
    const Environment blender = smooth(Convention::blender, UpAxis::z), openexr = smooth(Convention::openexr, UpAxis::z, -90);
    const Environment blender_y = smooth(Convention::blender, UpAxis::y),
                      openexr_y = smooth(Convention::openexr, UpAxis::y, -90);
    Directions random;
    for (int i = 0; i < 1000; ++i) {
        const Vec3f d = random.next();
        ASSERT_LT((world_radiance(blender, d) - world_radiance(openexr, d)).length(), 1e-4f);
        ASSERT_LT((world_radiance(blender_y, d) - world_radiance(openexr_y, d)).length(), 1e-4f);
    }
}

TEST(Orientation, RotationTurnsTheLookupAsBlendersMappingNode) {
    const float a = 30 * kPi / 180;
    expect_mapping(smooth(Convention::blender, UpAxis::z, 30), [&](const Vec3f& d) {
        const Vec3f t(std::cos(a) * d.x - std::sin(a) * d.y, std::sin(a) * d.x + std::cos(a) * d.y, d.z);
        return place(0.5f - std::atan2(t.y, t.x) / (2 * kPi), std::acos(t.z) / kPi);
    });
}

TEST(Orientation, FlipMirrorsThePictureAndTheDeterminant) {
    expect_mapping(smooth(Convention::blender, UpAxis::z, 0, true),
                   [](const Vec3f& d) { return place(0.5f + std::atan2(d.y, d.x) / (2 * kPi), std::acos(d.z) / kPi); });
    for (const Convention convention : {Convention::blender, Convention::openexr}) {
        for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
            EXPECT_NEAR(smooth(convention, up, 77).world_to_light().determinant(), 1.0f, 1e-6f);
            EXPECT_NEAR(smooth(convention, up, 77, true).world_to_light().determinant(), -1.0f, 1e-6f);
        }
    }
}

TEST(Orientation, AutomaticIsOpenExrForYUpAndBlenderForZUp) {
    const auto same = [](const Environment& a, const Environment& b) { return a.world_to_light() == b.world_to_light(); };
    EXPECT_TRUE(same(smooth(Convention::automatic, UpAxis::automatic), smooth(Convention::openexr, UpAxis::y)));
    EXPECT_TRUE(same(smooth(Convention::automatic, UpAxis::y), smooth(Convention::openexr, UpAxis::y)));
    EXPECT_TRUE(same(smooth(Convention::automatic, UpAxis::z), smooth(Convention::blender, UpAxis::z)));
}

/// The picture and the filtered cube agree in every orientation: the pyramid is in light axes too.
TEST(Orientation, PyramidAndPictureShowTheSameLight) {
    EnvironmentSettings settings;
    settings.convention = Convention::blender, settings.up = UpAxis::z, settings.rotate_deg = 200;
    Image image(256, 128, 3);
    for (size_t i = 0; i < image.pixel_count(); ++i) {
        const Color3f c = color_at((i % 256 + 0.5f) / 256, (static_cast<int>(i / 256) + 0.5f) / 128);
        std::copy_n(&c.x, 3, image.at(i));
    }
    const Environment light = Environment::from_image(image, settings, "smooth");
    Directions random;
    for (int i = 0; i < 5000; ++i) {
        const Vec3f d = random.next();
        if (std::fabs(d.y) > 0.99f) continue;  // the picture has a pole there
        ASSERT_LT((light.pyramid().lookup(d, 0) - light.radiance(d)).length(), 0.02f) << d;
    }
}

namespace {

/// Median and 99th percentile of |a - b| / (mean of the light) over random directions.
std::pair<float, float> difference(const Environment& a, const Environment& b, float level) {
    Directions random;
    std::vector<float> errors;
    double mean = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f d = random.next();
        const Color3f one = a.pyramid().lookup(d, level), other = b.pyramid().lookup(d, level);
        errors.push_back((one - other).length());
        mean += other.length() / 20000;
    }
    std::sort(errors.begin(), errors.end());
    return {errors[10000] / static_cast<float>(mean), errors[19800] / static_cast<float>(mean)};
}

}  // namespace

class OpenExrPairs : public testing::TestWithParam<const char*> {};

TEST_P(OpenExrPairs, LatLongAndCubeShowTheSameLight) {
    const std::string name = GetParam();
    const auto latlong = data_path("public/env/" + name + "LatLong.exr"), cube = data_path("public/env/" + name + "Cube.exr");
    if (!latlong || !cube) GTEST_SKIP() << "needs public/env of the test data, see BURNISH_DATA";
    EnvironmentSettings settings;
    settings.face_size = 256;
    settings.up = UpAxis::z;  // the envmap attribute wins: still OpenEXR's convention
    const Environment a = Environment::load(latlong->string(), settings), b = Environment::load(cube->string(), settings);
    EXPECT_EQ(a.world_to_light(), b.world_to_light());
    const auto [median, rare] = difference(a, b, 3.0f);
    RecordProperty("median", std::to_string(median));
    RecordProperty("rare", std::to_string(rare));
    EXPECT_LT(median, 0.02f);
    EXPECT_LT(rare, 0.4f);  // half a texel between the two, at small bright lamps

    settings.rotate_deg = 5;  // control: the test can tell a turn of five degrees
    settings.convention = Convention::openexr;
    Directions random;
    const Environment turned = Environment::load(latlong->string(), settings);
    double wrong = 0, right = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3f d = random.next();
        const Color3f truth = b.pyramid().lookup(d * b.world_to_light(), 3);
        wrong += (turned.pyramid().lookup(d * turned.world_to_light(), 3) - truth).length();
        right += (a.pyramid().lookup(d * a.world_to_light(), 3) - truth).length();
    }
    EXPECT_GT(wrong, 3 * right);
}

INSTANTIATE_TEST_SUITE_P(All, OpenExrPairs, testing::Values("Orientation", "StageEnv", "WavyLines"));

TEST(Orientation, BackgroundOfACyclesRenderIsTheEnvironment) {
    const auto render = data_path("cycles/spheres/spheres.exr"), picture = data_path("cycles/spheres/env_courtyard.exr");
    const auto json = data_path("cycles/spheres/spheres.json");
    if (!render || !picture || !json) GTEST_SKIP() << "needs cycles/spheres of the test data, see BURNISH_DATA";
    const auto scene = nlohmann::json::parse(std::ifstream(*json));
    EnvironmentSettings settings;
    settings.convention = Convention::blender, settings.up = UpAxis::z;
    settings.rotate_deg = scene["environment"]["mapping_node"]["rotation_z_deg"];
    const Environment light = Environment::load(picture->string(), settings);

    const OIIO::ImageBuf image(render->string());
    const auto& names = image.spec().channelnames;
    const auto channel = [&](const std::string& name) {
        return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    const int depth = channel("ViewLayer.Depth.Z"),
              env[3] = {channel("ViewLayer.Env.R"), channel("ViewLayer.Env.G"), channel("ViewLayer.Env.B")};
    ASSERT_LT(std::max({depth, env[0], env[1], env[2]}), image.nchannels());
    const auto& m = scene["camera"]["matrix_world"];
    const int width = image.spec().width, height = image.spec().height;
    const float tx = std::tan(0.5f * kPi / 180 * scene["camera"]["fov_x_deg"].get<float>()), ty = tx * height / width;

    int checked = 0, off = 0;
    double sum = 0, mean = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (image.getchannel(x, y, 0, depth) < 1e9f) continue;
            const float c[3] = {(2 * (x + 0.5f) / width - 1) * tx, (1 - 2 * (y + 0.5f) / height) * ty, -1};
            Vec3f d;
            for (int k = 0; k < 3; ++k)
                d[k] = m[k][0].get<float>() * c[0] + m[k][1].get<float>() * c[1] + m[k][2].get<float>() * c[2];
            const Color3f radiance = world_radiance(light, d.normalized());
            Color3f truth;
            for (int k = 0; k < 3; ++k) truth[k] = image.getchannel(x, y, 0, env[k]);
            const float error = (radiance - truth).length() / std::max(truth.length(), 0.05f);
            ++checked;
            // A few background pixels see a sliver of an object in a sample beside their centre.
            if (error > 4e-3f)
                ++off;
            else
                sum += error;
            mean += truth.length();
        }
    }
    ASSERT_GT(checked, 10000);
    ASSERT_GT(mean / checked, 0.05);
    RecordProperty("mean_relative_error", std::to_string(sum / checked));
    RecordProperty("share_off", std::to_string(static_cast<double>(off) / checked));
    EXPECT_LT(off, checked / 500);
    EXPECT_LT(sum / checked, 1e-3);
}

TEST(Orientation, SixFilesNamedInAZUpWorldMatchTheirPanorama) {
    const auto faces = data_path("cycles/room/cube_px.exr"), panorama = data_path("cycles/room/equirect.exr");
    if (!faces || !panorama) GTEST_SKIP() << "needs cycles/room of the test data, see BURNISH_DATA";
    EnvironmentSettings settings;
    settings.up = UpAxis::z, settings.face_size = 256;
    const std::string pattern = (faces->parent_path() / "cube_{face}.exr").string();
    const Environment cube = Environment::load(pattern, settings), latlong = Environment::load(panorama->string(), settings);
    EXPECT_TRUE(cube.warnings().empty()) << cube.warnings().front();
    Directions random;
    double error = 0, mean = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec3f d = random.next();
        const Color3f a = cube.pyramid().lookup(d * cube.world_to_light(), 2),
                      b = latlong.pyramid().lookup(d * latlong.world_to_light(), 2);
        error += (a - b).length(), mean += b.length();
    }
    RecordProperty("relative_difference", std::to_string(error / mean));
    EXPECT_LT(error / mean, 0.02);
}
