#include "core/scenes.h"

#include <burnish/light/environment.h>
#include <burnish/light/filter/gaussian_stack.h>
#include <burnish/light/filter/light_curvature.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

/// A smooth light: 2 + cos(frequency * angle to the axis).
Image ripples(const Vec3f& axis, float frequency, int height = 256) {
    Image light(2 * height, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 2 * height; ++x) {
            const float theta = kPi * (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
            const float phi = kPi * (static_cast<float>(x) + 0.5f) / static_cast<float>(height);
            const Vec3f d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            const float value = 2 + std::cos(frequency * std::acos(std::clamp(d.dot(axis), -1.0f, 1.0f)));
            std::fill_n(light.at(x, y), 3, value);
        }
    return light;
}

Vec3f random_direction(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return Vec3f(normal(random), normal(random), normal(random)).normalized();
}

float mean(const std::array<float, 4>& rgba) { return (rgba[0] + rgba[1] + rgba[2]) / 3; }

/// Largest second difference of a level's lookups along some great circles through d, `step` apart.
float bend(const CubeStack& stack, float level, const Vec3f& d, float step) {
    const Frame frame = Frame::around(d);
    float largest = 0;
    for (int i = 0; i < 8; ++i) {
        const float angle = kPi * static_cast<float>(i) / 8;
        const Vec3f along = (frame.t * std::cos(angle) + frame.b * std::sin(angle)) * std::sin(step);
        const Vec3f ahead = d * std::cos(step) + along, back = d * std::cos(step) - along;
        const float difference = mean(stack.lookup_rgba(ahead, level)) + mean(stack.lookup_rgba(back, level)) -
                                 2 * mean(stack.lookup_rgba(d, level));
        largest = std::max(largest, std::fabs(difference) / (step * step));
    }
    return largest;
}

TEST(LightCurvature, ConstantLightDoesNotBend) {
    const Environment light = Environment::from_image(scenes::constant_light(3), {}, "constant");
    const CubeStack& stack = light.gaussian_stack().stack();
    std::mt19937 random(1);
    for (int level = 1; level < stack.level_count(); ++level)
        for (int i = 0; i < 50; ++i) {
            const float sigma = light.gaussian_stack().sigma(static_cast<float>(level));
            EXPECT_LT(stack.lookup_rgba(random_direction(random), static_cast<float>(level))[3] * sigma * sigma, 0.01f);
        }
}

/// The fourth channel bounds what lookups do between texels and beyond faces' edges, in all of the neighbourhood it stands for.
TEST(LightCurvature, BoundsTheBendOfLookupsInItsNeighbourhood) {
    const Environment light = Environment::from_image(scenes::stress_light(5, 256), {}, "stress");
    const GaussianStack& gaussian = light.gaussian_stack();
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(-1, 1);
    int below = 0, count = 0;
    for (const float sigma : {0.03f, 0.1f, 0.3f})
        for (int i = 0; i < 300; ++i, ++count) {
            const Vec3f d = random_direction(random);
            const Frame frame = Frame::around(d);
            const float reach = 0.7f * kCurvatureReach * sigma;
            const Vec3f near = (d + (frame.t * uniform(random) + frame.b * uniform(random)) * reach).normalized();
            const float level = gaussian.level(sigma);
            below += gaussian.stack().lookup_rgba(d, level)[3] < 0.8f * bend(gaussian.stack(), level, near, sigma);
        }
    EXPECT_LE(below, count / 100);
}

TEST(LightCurvature, IsThatOfAKnownRipple) {
    const Vec3f axis = Vec3f(0.3f, 0.5f, -0.8f).normalized();
    const float frequency = 8;
    const Environment light = Environment::from_image(ripples(axis, frequency), {}, "ripples");
    const GaussianStack& gaussian = light.gaussian_stack();
    const float sigma = 0.05f, left = std::exp(-0.5f * frequency * frequency * sigma * sigma);
    const float expected =
        frequency * frequency * left;  // at crests; a neighbourhood of two and a half sigmas holds one or nearly
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const Vec3f d = random_direction(random);
        if (std::fabs(d.dot(axis)) > 0.9f) continue;  // rings about the axis bend more across
        const float found = gaussian.stack().lookup_rgba(d, gaussian.level(sigma))[3];
        EXPECT_LT(found, 1.15f * expected);
        EXPECT_GT(found, 0.4f * expected);
    }
}

}  // namespace
