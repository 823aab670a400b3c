#include "core/data.h"
#include "light_pictures.h"

#include <burnish/light/environment.h>

#include <gtest/gtest.h>
#include <boost/math/distributions/chi_squared.hpp>

using namespace burnish_test;

namespace {

Environment environment(const Image& image) {
    EnvironmentSettings settings;
    settings.face_size = 16;
    return Environment::from_image(image, settings, "test");
}

/// A dim noisy lat-long with a sun, a black band and a bright texel beside a pole.
Image noisy_latlong(int width, int height) {
    Directions random(5);
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int k = 0; k < 3; ++k) image.at(x, y)[k] = y > height * 3 / 4 ? 0.0f : random.uniform();
        }
    }
    for (int k = 0; k < 3; ++k) image.at(width / 3, height / 4)[k] = 3000.0f, image.at(1 % width, 0)[k] = 50.0f;
    return image;
}

Image noisy_strip(int size) {
    Image image = noisy_latlong(size, 6 * size);
    return image;
}

/// Integral of function(d) over the sphere: midpoint rule in (phi, cos theta).
template <class Function>
double sphere_integral(int steps, Function&& function) {
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const float y = 1.0f - 2.0f * (i + 0.5f) / steps, r = std::sqrt(1 - y * y);
        for (int j = 0; j < 2 * steps; ++j) {
            const float phi = 2 * kPi * (j + 0.5f) / (2 * steps);
            sum += function(Vec3f(r * std::sin(phi), y, r * std::cos(phi)));
        }
    }
    return sum * 4 * std::numbers::pi / (2.0 * steps * steps);
}

struct Case {
    const char* name;
    Image image;
};
std::vector<Case> cases() {
    return {{"lat-long", noisy_latlong(64, 32)},
            {"odd lat-long", noisy_latlong(37, 11)},
            {"one texel", Image(1, 1, 3, 2.0f)},
            {"black", Image(8, 4, 3)},
            {"cube", noisy_strip(8)},
            {"odd cube", noisy_strip(5)}};
}

}  // namespace

TEST(EnvironmentSampling, DensityIntegratesToOne) {
    for (const Case& c : cases()) {
        const Environment light = environment(c.image);
        EXPECT_NEAR(sphere_integral(1500, [&](const Vec3f& d) { return light.pdf(d); }), 1.0, 4e-3) << c.name;
    }
}

TEST(EnvironmentSampling, SamplesComeWithTheirDensity) {
    for (const Case& c : cases()) {
        const Environment light = environment(c.image);
        Directions random;
        for (int i = 0; i < 10000; ++i) {
            float pdf = -1;
            const Vec3f d = light.sample({random.uniform(), random.uniform()}, pdf);
            ASSERT_NEAR(d.length(), 1.0f, 1e-6f);
            ASSERT_GT(pdf, 0.0f) << c.name;
            ASSERT_EQ(pdf, light.pdf(d)) << c.name;
        }
    }
}

// Pearson's test on a 16 x 32 grid of equal solid angles; expectations by quadrature inside each cell.
TEST(EnvironmentSampling, SamplesFollowTheDensity) {
    constexpr int rows = 16, columns = 32, samples = 400000, fine = 64;
    for (const Case& c : cases()) {
        const Environment light = environment(c.image);
        std::vector<double> counted(rows * columns), expected(rows * columns);
        for (int i = 0; i < rows * fine; ++i) {
            for (int j = 0; j < columns * fine; ++j) {
                const float y = 1.0f - 2.0f * (i + 0.5f) / (rows * fine), r = std::sqrt(1 - y * y),
                            phi = 2 * kPi * (j + 0.5f) / (columns * fine);
                expected[i / fine * columns + j / fine] += light.pdf({r * std::sin(phi), y, r * std::cos(phi)});
            }
        }
        for (double& e : expected) e *= samples * 4 * std::numbers::pi / (static_cast<double>(rows) * columns * fine * fine);
        Directions random(9);
        for (int i = 0; i < samples; ++i) {
            float pdf;
            const Vec3f d = light.sample({random.uniform(), random.uniform()}, pdf);
            float phi = std::atan2(d.x, d.z);
            if (phi < 0) phi += 2 * kPi;
            const int row = std::clamp(static_cast<int>((1 - d.y) / 2 * rows), 0, rows - 1),
                      column = std::clamp(static_cast<int>(phi / (2 * kPi) * columns), 0, columns - 1);
            counted[row * columns + column] += 1;
        }
        double chi2 = 0, pooled_counted = 0, pooled_expected = 0;
        int cells = 0;
        for (int i = 0; i < rows * columns; ++i) {
            if (expected[i] < 20) {
                pooled_counted += counted[i], pooled_expected += expected[i];
                continue;
            }
            // The quadrature knows the texels' edges to a 64th of a cell: the tolerance grows with the expectation.
            const double deviation = std::max(0.0, std::fabs(counted[i] - expected[i]) - 0.01 * expected[i]);
            chi2 += deviation * deviation / expected[i], ++cells;
        }
        ASSERT_LT(std::fabs(pooled_counted - pooled_expected), 20 + 0.05 * pooled_expected + 6 * std::sqrt(pooled_expected))
            << c.name;
        if (cells < 2) continue;
        const double p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(cells - 1), chi2));
        EXPECT_GT(p, 1e-3) << c.name << " chi2 " << chi2 << " cells " << cells;
    }
}

TEST(EnvironmentSampling, EstimatesTheTotalLight) {
    for (const Case& c : cases()) {
        const Environment light = environment(c.image);
        const double truth = sphere_integral(1500, [&](const Vec3f& d) { return luminance(light.radiance(d)); });
        Directions random(4);
        double sum = 0, square = 0;
        constexpr int samples = 200000;
        for (int i = 0; i < samples; ++i) {
            float pdf;
            const Vec3f d = light.sample({random.uniform(), random.uniform()}, pdf);
            const double value = luminance(light.radiance(d)) / pdf;
            sum += value, square += value * value;
        }
        const double mean = sum / samples, error = std::sqrt(std::max(0.0, square / samples - mean * mean) / samples);
        EXPECT_NEAR(mean, truth, 4 * error + 4e-3 * truth) << c.name;
        EXPECT_LT(error, 0.004 * truth + 1e-12) << c.name;
    }
}

TEST(EnvironmentSampling, IsNowhereZeroWhereThereIsLight) {
    for (const Case& c : cases()) {
        const Environment light = environment(c.image);
        Directions random;
        for (int i = 0; i < 100000; ++i) {
            const Vec3f d = random.next();
            ASSERT_TRUE(light.pdf(d) > 0.0f || luminance(light.radiance(d)) == 0.0f) << c.name << d;
        }
    }
}

TEST(EnvironmentSampling, FindsTheSunOfARealSky) {
    const auto file = data_path("public/env/rooitou_park_1k.hdr");
    if (!file) GTEST_SKIP() << "needs public/env of the test data, see BURNISH_DATA";
    EnvironmentSettings settings;
    settings.suns = Suns::keep;
    const Environment light = Environment::load(file->string(), settings);
    Directions random;
    double sum = 0, square = 0;
    constexpr int samples = 100000;
    for (int i = 0; i < samples; ++i) {
        float pdf;
        const Vec3f d = light.sample({random.uniform(), random.uniform()}, pdf);
        const double value = luminance(light.radiance(d)) / pdf;
        sum += value, square += value * value;
    }
    const double mean = sum / samples, error = std::sqrt((square / samples - mean * mean) / samples);
    EXPECT_LT(error / mean, 0.003);
    double from_cube = 0;
    const CubePyramid& cube = light.pyramid();
    const int n = cube.face_size();
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < n * n; ++i)
            from_cube += texel_solid_angle(i % n, i / n, n) * luminance(cube.texel(0, face, i % n, i / n));
    }
    EXPECT_NEAR(from_cube / mean, 1.0, 0.01);
}
