#include <burnish/base/error.h>
#include <burnish/frequency/local_bandwidth.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace burnish;

template <class Function>
Image painted(int width, int height, Function&& function) {
    Image image(width, height, 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) *image.at(x, y) = static_cast<float>(function(x, y));
    }
    return image;
}

Image white_noise(int width, int height) {
    std::mt19937 engine(9);
    std::normal_distribution<float> normal;
    return painted(width, height, [&](int, int) { return normal(engine); });
}

/// Of the values at least `margin` pixels inside.
std::vector<float> sorted_inside(const Image& image, int margin) {
    std::vector<float> values;
    for (int y = margin; y < image.height - margin; ++y)
        values.insert(values.end(), image.at(margin, y), image.at(image.width - margin, y));
    std::sort(values.begin(), values.end());
    return values;
}

float quantile(const std::vector<float>& sorted, double q) {
    return sorted[static_cast<size_t>(q * static_cast<double>(sorted.size() - 1))];
}

constexpr double kTau = 2 * std::numbers::pi;

}  // namespace

TEST(LocalBandwidth, PureWavesHaveTheirOwnFrequency) {
    for (const double frequency : {0.03, 0.05, 0.08, 0.1, 0.15, 0.2, 0.3, 0.35, 0.4, 0.45}) {
        for (const double direction : {0.0, 0.4, 0.8, 1.3}) {
            for (const double phase : {0.0, 1.0}) {
                const double fx = frequency * std::cos(direction), fy = frequency * std::sin(direction);
                const Image wave =
                    painted(256, 256, [&](int x, int y) { return 1 + 0.5 * std::sin(kTau * (fx * x + fy * y) + phase); });
                const std::vector<float> nu = sorted_inside(local_bandwidth(wave, {}), 64);
                EXPECT_NEAR(std::log2(quantile(nu, 0.5) / frequency), 0.0, 0.55)
                    << frequency << " " << direction << " " << phase;
                EXPECT_GT(quantile(nu, 0.01), 0.7 * frequency) << frequency << " " << direction << " " << phase;
            }
        }
    }
}

TEST(LocalBandwidth, NoisyImagesReachNyquist) {
    const std::vector<float> nu = sorted_inside(local_bandwidth(white_noise(256, 256), {}), 0);
    EXPECT_NEAR(quantile(nu, 0.5), 0.45, 0.05);
    EXPECT_GT(quantile(nu, 0.0), 0.25f);
    BandwidthSettings maxima;
    maxima.rule = BandRule::maxima;
    EXPECT_EQ(quantile(sorted_inside(local_bandwidth(white_noise(64, 64), maxima), 0), 0.0), 0.5f);
}

TEST(LocalBandwidth, ConstantsHaveNone) {
    for (const BandRule rule : {BandRule::energy, BandRule::maxima}) {
        for (const float value : {0.0f, 1e-6f, 1.0f, 1e6f}) {
            BandwidthSettings settings;
            settings.rule = rule, settings.surround = Surround::repeat;
            const Image nu = local_bandwidth(Image(100, 70, 1, value), settings);
            EXPECT_EQ(nu.width, 100);
            EXPECT_EQ(nu.height, 70);
            EXPECT_LT(*std::max_element(nu.data.begin(), nu.data.end()), 1e-5f) << value;
        }
    }
}

TEST(LocalBandwidth, ScaleDoesNotMatter) {
    Image image = white_noise(64, 64);
    const Image nu = local_bandwidth(image, {});
    for (float& value : image.data) value *= 1024.0f;
    EXPECT_EQ(local_bandwidth(image, {}).data, nu.data);
}

TEST(LocalBandwidth, AnEdgeIsHighAtTheEdgeOnly) {
    for (int edge = 120; edge < 128; ++edge) {
        BandwidthSettings settings;
        settings.surround = Surround::repeat;
        const Image nu = local_bandwidth(painted(256, 256, [&](int x, int) { return x < edge ? 0.2 : 1.0; }), settings);
        float highest = 0;
        for (int x = edge - 2; x < edge + 2; ++x) highest = std::max(highest, *nu.at(x, 100));
        EXPECT_GT(highest, 0.33f) << edge;
        for (int x = 64; x < 192; ++x) {
            const float distance = std::fabs(static_cast<float>(x - edge) + 0.5f);
            if (distance > 4) EXPECT_LT(*nu.at(x, 100), 2.2f / distance) << x << " " << edge;
        }
    }
}

TEST(LocalBandwidth, FineDetailNearSomethingBrightIsSeen) {
    std::mt19937 engine(3);
    const Image image =
        painted(256, 256, [&](int x, int) { return x > 200 ? 100.0 : 0.1 + 0.02 * static_cast<double>(engine()) * 0x1p-32; });
    const Image nu = local_bandwidth(image, {});
    std::vector<float> row;
    for (int y = 64; y < 192; ++y) row.insert(row.end(), nu.at(96, y), nu.at(152, y));
    std::sort(row.begin(), row.end());
    EXPECT_GT(quantile(row, 0.1), 0.25f);
}

TEST(LocalBandwidth, AnAreaLightVariesAtItsBorder) {
    const Image nu = local_bandwidth(Image(128, 128, 1, 1.0f), {});
    EXPECT_LT(*nu.at(64, 64), 0.03f);
    EXPECT_GT(*nu.at(127, 64), 0.3f);
    EXPECT_GT(*nu.at(64, 127), 0.3f);
    EXPECT_GT(std::max(*nu.at(0, 64), *nu.at(1, 64)), 0.15f);
    BandwidthSettings tiled;
    tiled.surround = Surround::repeat;
    EXPECT_LT(*local_bandwidth(Image(128, 128, 1, 1.0f), tiled).at(127, 64), 1e-5f);
}

TEST(LocalBandwidth, ALatLongPictureHasNoBorder) {
    const Image picture = painted(256, 128, [](int x, int y) {  // smooth on the sphere
        const double phi = kTau * (x + 0.5) / 256, theta = std::numbers::pi * (y + 0.5) / 128;
        return 2 + std::sin(theta) * std::cos(phi - 0.3) + 0.4 * std::cos(theta);
    });
    BandwidthSettings settings;
    settings.surround = Surround::latlong;
    const Image nu = local_bandwidth(picture, settings);
    EXPECT_LT(*std::max_element(nu.data.begin(), nu.data.end()), 0.04f);  // below all bands
    const Image bordered = local_bandwidth(picture, {});
    EXPECT_GT(*std::max_element(bordered.data.begin(), bordered.data.end()), 0.3f);
}

TEST(LocalBandwidth, OfATextureIsPerUnitOfLength) {
    const Image wave = painted(256, 128, [](int x, int) { return 1 + std::sin(kTau * 0.1 * x); });
    const Image samples = local_bandwidth(wave, {});
    const Image wide = spatial_bandwidth(wave, 0.5f, 0.25f, {}), square = spatial_bandwidth(wave, 0.25f, 0.25f, {});
    for (size_t i = 0; i < samples.data.size(); ++i) {
        ASSERT_EQ(wide.data[i], 512.0f * samples.data[i]);
        ASSERT_EQ(square.data[i], 1024.0f * samples.data[i]);  // by the denser axis
    }
}

TEST(LocalBandwidth, TakesAnySizeOfOneChannel) {
    for (const auto& [width, height] : {std::pair(1, 1), {3, 50}, {17, 33}, {129, 5}}) {
        for (const Surround surround : {Surround::zero, Surround::repeat, Surround::latlong}) {
            BandwidthSettings settings;
            settings.surround = surround;
            const Image nu = local_bandwidth(white_noise(width, height), settings);
            EXPECT_EQ(nu.pixel_count(), static_cast<size_t>(width) * height);
            for (const float value : nu.data) EXPECT_TRUE(value >= 0.0f && value <= 0.5f);
        }
    }
    EXPECT_THROW(local_bandwidth(Image(8, 8, 3), {}), Error);
    EXPECT_THROW(local_bandwidth(Image(), {}), Error);
}
