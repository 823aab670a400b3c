// Balls of materials under light whose answer is known.
#include <burnish/base/parallel.h>
#include <burnish/job/material_ball.h>
#include <burnish/material/albedo.h>
#include <burnish/material/library.h>

#include <gtest/gtest.h>

namespace burnish {
namespace {

BallLight constant_light(float radiance) {
    EnvironmentSettings settings;
    settings.up = UpAxis::z;
    return BallLight(Environment::from_image(Image(64, 32, 3, radiance), settings, "constant"));
}

BallSettings small() {
    BallSettings settings;
    settings.size = 64;
    return settings;
}

double coverage(const Image& ball) {
    double sum = 0;
    for (size_t i = 0; i < ball.pixel_count(); ++i) sum += ball.at(i)[3];
    return sum / static_cast<double>(ball.pixel_count());
}

}  // namespace

TEST(MaterialBall, DiffuseOfConstantLightIsItsReflectivity) {
    Material material;
    material.kd = Color3f(0.5f, 0.25f, 0);
    const Image ball = render_ball(material, constant_light(2), small());
    for (const int x : {8, 32, 50}) {
        EXPECT_NEAR(ball.at(x, 32)[0], 1, 0.01) << x;
        EXPECT_NEAR(ball.at(x, 32)[1], 0.5, 0.005) << x;
        EXPECT_EQ(ball.at(x, 32)[2], 0);
        EXPECT_NEAR(ball.at(x, 32)[3], 1, 1e-5);
    }
}

TEST(MaterialBall, OverlayOfConstantLightIsTheAlbedo) {
    Material material = find_material("merl:gold-paint");
    material.kd = Color3f(0);
    const Image ball = render_ball(material, constant_light(1), small());
    const Color3f albedo = directional_albedo(material.lobes[0], Vec3f(0, 0, 1));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ball.at(32, 32)[c], albedo[c], 0.02f * albedo[c]);
}

TEST(MaterialBall, CoversItsDiscAndNothingElse) {
    const Image ball = render_ball(find_material("gold"), constant_light(1), small());
    EXPECT_NEAR(coverage(ball), M_PI / 4 * 0.94 * 0.94, 0.002);
    EXPECT_EQ(ball.at(0, 0)[3], 0);
    EXPECT_EQ(ball.at(0, 0)[0], 0);
    const Image picture = over_grey(ball);
    EXPECT_GT(picture.at(0, 0)[0], 0);
    EXPECT_EQ(picture.at(32, 32)[0], ball.at(32, 32)[0]);
}

TEST(MaterialBall, HasTheSunWhereTheSkyHasIt) {
    const Image ball = render_ball(find_material("mirror"), BallLight::sky(), small());
    int x = 0, y = 0;
    for (int i = 0; i < 64 * 64; ++i)
        if (ball.at(i % 64, i / 64)[1] > ball.at(x, y)[1]) x = i % 64, y = i / 64;
    const Vec3f sun(-0.732f, -0.389f, 0.559f), n = (sun + Vec3f(0, -1, 0)).normalized();  // azimuth -118, elevation 34 degrees
    EXPECT_NEAR(x, 32 + 32 * 0.94 * n.x, 1.5);
    EXPECT_NEAR(y, 32 - 32 * 0.94 * n.z, 1.5);
}

TEST(MaterialBall, SameBitsForAnyThreadCount) {
    const BallLight light = BallLight::sky();
    const Image many = render_ball(find_material("merl:brass"), light, small());
    const ThreadLimit one(1);
    EXPECT_EQ(render_ball(find_material("merl:brass"), light, small()).data, many.data);
}

}  // namespace burnish
