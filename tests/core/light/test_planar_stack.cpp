// Flat pictures of light: lookups against the Gaussian averages that they stand for.
#include <burnish/base/error.h>
#include <burnish/light/filter/planar_stack.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

Image opaque(int width, int height, const std::function<Color3f(float x, float y)>& color) {
    Image image(width, height, 4, 1.0f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Color3f c = color(x + 0.5f, y + 0.5f);
            std::copy_n(&c.x, 3, image.at(x, y));
        }
    return image;
}

Image noise(int width, int height) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    return opaque(width, height, [&](float, float) { return Color3f(uniform(random)); });
}

/// Sum over the picture's texels, each a point, weighted by the Gaussian less a texel's own width.
float brute_force(const Image& image, const Vec2f& place, float sigma, int channel) {
    const double variance = sigma * sigma - 1 / 12.0;
    double sum = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double dx = x + 0.5 - place.x, dy = y + 0.5 - place.y;
            sum += image.at(x, y)[channel] * std::exp(-0.5 * (dx * dx + dy * dy) / variance) / (2 * kPi * variance);
        }
    return static_cast<float>(sum);
}

}  // namespace

TEST(PlanarStack, IsTheBilinearPictureWhereNothingIsFiltered) {
    const Image image = opaque(8, 5, [](float x, float y) { return Color3f(x, y, x * y); });
    const PlanarStack stack(image);
    const PlanarStack::Value value = stack.lookup({3.25f, 2.5f}, 0);
    EXPECT_NEAR(value.radiance.x, 3.25f, 1e-5f);
    EXPECT_NEAR(value.radiance.y, 2.5f, 1e-5f);
    EXPECT_NEAR(value.radiance.z, 3.25f * 2.5f, 1e-4f);
    EXPECT_NEAR(value.cover, 1, 1e-6f);
}

TEST(PlanarStack, AveragesByAGaussianOfAnyWidth) {
    const Image image = noise(96, 64);
    const PlanarStack stack(image);
    for (const float sigma : {1.3f, 2.0f, 3.4f, 6.5f, 11.0f, 25.0f})
        for (const Vec2f& place : {Vec2f(40.3f, 30.1f), Vec2f(2.2f, 60.7f), Vec2f(95.0f, 12.0f), Vec2f(-4.0f, 31.0f)}) {
            const PlanarStack::Value value = stack.lookup(place, sigma);
            EXPECT_NEAR(value.radiance.x, brute_force(image, place, sigma, 0), 0.025f / sigma + 0.006f) << sigma << place;
            EXPECT_NEAR(value.cover, brute_force(image, place, sigma, 3), 0.03f) << sigma << place;
        }
}

TEST(PlanarStack, FadesOverItsEdgesAsTheNormalDistribution) {
    const PlanarStack stack(opaque(200, 200, [](float, float) { return Color3f(2); }));
    for (const float sigma : {2.0f, 5.0f, 12.0f})
        for (const float beyond : {-2.0f, -1.0f, 0.0f, 0.7f, 2.0f}) {
            const PlanarStack::Value value = stack.lookup({-beyond * sigma, 100}, sigma);
            const float share = 0.5f * std::erfc(beyond / std::sqrt(2.0f));
            EXPECT_NEAR(value.cover, share, 0.016f) << sigma << ' ' << beyond;
            EXPECT_NEAR(value.radiance.x, 2 * value.cover, 1e-4f);
        }
}

TEST(PlanarStack, LosesWhatAVeryWideGaussianSeesBesideIt) {
    const PlanarStack stack(opaque(32, 32, [](float, float) { return Color3f(1); }));
    const float sigma = 400;
    EXPECT_NEAR(stack.lookup({16, 16}, sigma).cover, 32 * 32 / (2 * kPi * sigma * sigma), 4e-4f);
}

TEST(PlanarStack, BoundsHowSharplyItBends) {
    const Image image = noise(64, 64);
    const PlanarStack stack(image);
    const float step = 0.5f;
    for (const float sigma : {2.0f, 4.0f, 9.0f})
        for (float x = 8; x < 56; x += 3.7f) {
            const auto mean = [&](float dx) { return stack.lookup({x + dx, 31.3f}, sigma).radiance.x; };
            const float bend = std::fabs(mean(-sigma) - 2 * mean(0) + mean(sigma)) / (sigma * sigma);
            EXPECT_LE(bend, 1.02f * stack.lookup({x + step, 31.3f}, sigma).bend) << sigma << ' ' << x;
        }
}

TEST(PlanarStack, TakesAnyQuestion) {
    const PlanarStack stack(noise(7, 3));
    for (const float bad : {NAN, INFINITY, -INFINITY, 1e30f, -1e30f}) {
        EXPECT_EQ(stack.lookup({bad, 1}, 1).cover, 0);
        EXPECT_TRUE(std::isfinite(stack.lookup({3, 1}, bad).radiance.x));
    }
    EXPECT_NEAR(PlanarStack(Image(1, 1, 4, 1.0f)).lookup({0.5f, 0.5f}, 0).cover, 1, 1e-6f);
    EXPECT_THROW(PlanarStack{Image(4, 4, 3)}, Error);
    EXPECT_THROW(PlanarStack{Image()}, Error);
}
