#include "light_pictures.h"

#include <burnish/light/filter/cube_resample.h>
#include <burnish/light/latlong.h>

#include <gtest/gtest.h>

using namespace burnish_test;

namespace {

double latlong_energy(const Image& image, int channel) {
    double sum = 0;
    for (int y = 0; y < image.height; ++y) {
        const double step = std::numbers::pi / image.height;
        const double omega = 2 * std::numbers::pi / image.width * (std::cos(step * y) - std::cos(step * (y + 1)));
        for (int x = 0; x < image.width; ++x) sum += omega * image.at(x, y)[channel];
    }
    return sum;
}

double cube_energy(const std::array<Image, 6>& faces, int channel) {
    const int n = faces[0].width;
    double sum = 0;
    for (const Image& face : faces) {
        for (int i = 0; i < n * n; ++i) sum += texel_solid_angle(i % n, i / n, n) * face.at(i)[channel];
    }
    return sum;
}

}  // namespace

TEST(CubeResample, KeepsTheEnergyOfASunOfOneTexelWhereverItStands) {
    Directions random(11);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        const int width = i % 2 ? 128 : 100, height = i % 2 ? 64 : 51;
        Image image(width, height, 3);
        const int x = static_cast<int>(random.uniform() * width),
                  y = i < 8 ? i % 4 : static_cast<int>(random.uniform() * height);
        image.at(x, y)[1] = 60000.0f;
        const auto faces = latlong_to_cube(image, i % 3 ? 32 : 64);
        const double error = std::fabs(cube_energy(faces, 1) / latlong_energy(image, 1) - 1);
        worst = std::max(worst, error);
        EXPECT_LT(error, 1e-3) << "sun at " << x << ", " << y << " of " << width << " x " << height;
    }
    RecordProperty("worst", std::to_string(worst));
}

TEST(CubeResample, PutsTheSunWhereItIs) {
    Image image(256, 128, 3);
    Directions random(2);
    for (int i = 0; i < 100; ++i) {
        const int x = static_cast<int>(random.uniform() * 256), y = static_cast<int>(random.uniform() * 128);
        std::fill(image.data.begin(), image.data.end(), 0.0f);
        image.at(x, y)[0] = 1.0f;
        const auto faces = latlong_to_cube(image, 64);
        Vec3f centre(0.0f);
        for (int face = 0; face < 6; ++face) {
            for (int t = 0; t < 64 * 64; ++t) {
                const auto energy = static_cast<float>(texel_solid_angle(t % 64, t / 64, 64)) * faces[face].at(t)[0];
                centre += energy * cube_direction(face, (t % 64 + 0.5f) / 64, (t / 64 + 0.5f) / 64);
            }
        }
        // Within three quarters of a cube texel, 2 / 64 wide.
        const Vec3f truth = latlong_direction({(x + 0.5f) / 256, (y + 0.5f) / 128});
        EXPECT_LT((centre.normalized() - truth).length(), 1.5f / 64) << x << ", " << y;
    }
}

TEST(CubeResample, KeepsAConstantAndLosesNoTexel) {
    for (const auto& [width, height] : {std::array{64, 32}, {1, 1}, {7, 3}, {1000, 500}, {2, 1}}) {
        for (const int size : {2, 16, 64}) {
            for (const Image& face : latlong_to_cube(Image(width, height, 3, 0.75f), size)) {
                for (const float value : face.data)
                    ASSERT_NEAR(value, 0.75f, 1e-6f) << width << " x " << height << " to " << size;
            }
        }
    }
}

TEST(CubeResample, FollowsASmoothPicture) {
    Image image(512, 256, 3);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 512; ++x) {
            const Vec3f d = latlong_direction({(x + 0.5f) / 512, (y + 0.5f) / 256});
            for (int k = 0; k < 3; ++k) image.at(x, y)[k] = 2.0f + d[k];
        }
    }
    const auto faces = latlong_to_cube(image, 64);
    for (int face = 0; face < 6; ++face) {
        for (int t = 0; t < 64 * 64; ++t) {
            const Vec3f d = cube_direction(face, (t % 64 + 0.5f) / 64, (t / 64 + 0.5f) / 64);
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(faces[face].at(t)[k], 2.0f + d[k], 6e-3f) << face << " " << t;
        }
    }
}

TEST(CubeResample, ResizedCubesKeepTheirEnergy) {
    auto faces = constant_faces(12, {0.5f, 0, 0});
    faces[2].at(0, 0)[1] = 1000;
    faces[5].at(6, 11)[1] = 500;
    for (const int size : {16, 8, 32}) {
        const auto resized = resized_cube(faces, size);
        EXPECT_NEAR(cube_energy(resized, 1) / cube_energy(faces, 1), 1.0, 1e-6);
        for (const Image& face : resized) {
            for (size_t i = 0; i < face.pixel_count(); ++i) ASSERT_FLOAT_EQ(face.at(i)[0], 0.5f);
        }
    }
}

TEST(CubeResample, DefaultFaceSizesAreAtLeastThePicturesResolution) {
    EXPECT_EQ(cube_size_for_latlong(1), 16);
    EXPECT_EQ(cube_size_for_latlong(1000), 256);
    EXPECT_EQ(cube_size_for_latlong(1024), 256);
    EXPECT_EQ(cube_size_for_latlong(1026), 512);
    EXPECT_EQ(cube_size_for_latlong(4096), 1024);
    EXPECT_EQ(cube_size_for_latlong(8000), 1024);
    EXPECT_EQ(cube_size_for_latlong(8192), 2048);
    EXPECT_EQ(cube_size_for_latlong(16384), 2048);
    EXPECT_EQ(cube_size_for_cube(500), 512);
}
