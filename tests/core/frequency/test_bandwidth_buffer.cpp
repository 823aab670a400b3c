// Levels at the powers of two, and pyramids against the extreme of every block.
#include <burnish/frequency/bandwidth_buffer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace burnish;

namespace {

/// The extreme over the pixels that pixel (x, y) of level k stands for.
template <class Choose>
float extreme(const Image& finest, int k, int x, int y, int channel, const Choose& choose) {
    float best = finest.at(x << k, y << k)[channel];
    for (int v = y << k; v < std::min((y + 1) << k, finest.height); ++v)
        for (int u = x << k; u < std::min((x + 1) << k, finest.width); ++u) best = choose(best, finest.at(u, v)[channel]);
    return best;
}

Image random_image(int width, int height, int channels) {
    Image image(width, height, channels);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (float& value : image.data) value = uniform(random);
    return image;
}

}  // namespace

TEST(ShadingLevel, IsTheCoarsestGridOfTwoNodesACycle) {
    EXPECT_EQ(shading_level(0.5f, 640, 360), 0);
    EXPECT_EQ(shading_level(0.25f, 640, 360), 1);
    EXPECT_EQ(shading_level(0.2501f, 640, 360), 0);
    EXPECT_EQ(shading_level(1.0f / 32, 640, 360), 4);
    for (const float b : {0.001f, 0.013f, 0.1f, 0.3f}) {
        const float step = std::exp2(shading_level(b, 4096, 4096));
        EXPECT_LE(step * 2 * b, 1) << b;
        EXPECT_GT(2 * step * 2 * b, 1) << b;
    }
}

TEST(ShadingLevel, StaysWithinTheImage) {
    EXPECT_EQ(shading_level(0, 640, 360), 8);
    EXPECT_EQ(shading_level(1e-9f, 640, 360), 8);
    EXPECT_EQ(shading_level(1e-9f, 512, 512), 9);
    EXPECT_EQ(shading_level(0, 1, 7), 0);
    EXPECT_EQ(shading_level(30, 640, 360), 0);
    EXPECT_EQ(shading_level(std::numeric_limits<float>::infinity(), 640, 360), 0);
}

TEST(Pyramids, HoldTheExtremeOfEveryBlock) {
    for (const auto& [width, height] : {std::pair{64, 64}, {37, 21}, {1, 9}, {5, 1}, {1, 1}, {2, 3}}) {
        const Image finest = random_image(width, height, 2);
        const std::vector<Image> low = min_pyramid(finest), high = max_pyramid(finest);
        ASSERT_EQ(low.size(), high.size());
        EXPECT_EQ(low.front().data, finest.data);
        EXPECT_EQ(low.back().pixel_count(), 1u);
        for (size_t k = 0; k < low.size(); ++k) {
            const int level = static_cast<int>(k), step = 1 << level;
            EXPECT_EQ(low[k].width, (width + step - 1) / step);
            EXPECT_EQ(low[k].height, (height + step - 1) / step);
            for (int y = 0; y < low[k].height; ++y)
                for (int x = 0; x < low[k].width; ++x)
                    for (int c = 0; c < 2; ++c) {
                        const auto smaller = [](float a, float b) { return std::min(a, b); };
                        const auto larger = [](float a, float b) { return std::max(a, b); };
                        EXPECT_EQ(low[k].at(x, y)[c], extreme(finest, level, x, y, c, smaller));
                        EXPECT_EQ(high[k].at(x, y)[c], extreme(finest, level, x, y, c, larger));
                    }
        }
    }
}
