#include <burnish/base/error.h>
#include <burnish/frequency/daubechies.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace burnish;

Image noise(int width, int height) {
    std::mt19937 engine(5);
    Image image(width, height, 1);
    for (float& value : image.data) value = static_cast<float>(engine() >> 8) * 0x1p-24f - 0.3f;
    return image;
}

double energy(const Image& image) {
    double sum = 0;
    for (const float value : image.data) sum += static_cast<double>(value) * value;
    return sum;
}

/// Largest coefficient outside the corner that is low in all bands, and at least three cells from where indices wrap around.
float largest_detail(const Image& image, int bands) {
    const Image coefficients = daubechies(image, bands);
    float largest = 0;
    for (int band = 0; band < bands; ++band) {
        const int width = image.width >> (band + 1), height = image.height >> (band + 1);
        for (int quarter = 1; quarter < 4; ++quarter) {
            for (int y = 0; y < height - 3; ++y) {
                for (int x = 0; x < width - 3; ++x)
                    largest = std::max(largest, std::fabs(*coefficients.at(x + quarter % 2 * width, y + quarter / 2 * height)));
            }
        }
    }
    return largest;
}

}  // namespace

TEST(Daubechies, TapsAreWhatTheClosedFormSays) {
    const double r = std::sqrt(3.0), scale = 4.0 * std::sqrt(2.0);
    const double low[4] = {1 + r, 3 + r, 3 - r, 1 - r};
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(kDaubechiesLow[k], low[k] / scale, 4e-8);
        EXPECT_EQ(kDaubechiesHigh[k], (k % 2 ? -1 : 1) * kDaubechiesLow[3 - k]);
    }
}

TEST(Daubechies, IsOrthonormal) {
    constexpr int width = 16, height = 8, count = width * height;
    std::vector<Image> basis;
    for (int i = 0; i < count; ++i) {
        Image one(width, height, 1);
        one.data[i] = 1.0f;
        basis.push_back(daubechies(one, 3));
    }
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j <= i; ++j) {
            double product = 0;
            for (int k = 0; k < count; ++k) product += static_cast<double>(basis[i].data[k]) * basis[j].data[k];
            ASSERT_NEAR(product, i == j, 1e-6) << i << " " << j;
        }
    }
}

TEST(Daubechies, KeepsEnergyAndTurnsBack) {
    for (const int bands : {0, 1, 2, 5}) {
        const Image image = noise(96, 64), coefficients = daubechies(image, bands),
                    back = inverse_daubechies(coefficients, bands);
        EXPECT_NEAR(energy(coefficients) / energy(image), 1.0, 1e-5);
        for (size_t i = 0; i < image.data.size(); ++i) ASSERT_NEAR(back.data[i], image.data[i], 3e-6f);
    }
}

TEST(Daubechies, DoesNotSeeConstantsAndRamps) {
    Image constant(64, 64, 1, 2.0f), ramp(64, 64, 1), bowl(64, 64, 1);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            *ramp.at(x, y) = 0.02f * static_cast<float>(x) - 0.03f * static_cast<float>(y);
            *bowl.at(x, y) = 0.001f * static_cast<float>(x * x);
        }
    }
    EXPECT_LT(largest_detail(constant, 3), 1e-5f);
    EXPECT_LT(largest_detail(ramp, 3), 1e-5f);
    EXPECT_GT(largest_detail(bowl, 3), 1e-3f);
}

TEST(Daubechies, RefusesWhatItCannotHalve) {
    EXPECT_THROW(daubechies(Image(24, 20, 1), 3), Error);
    EXPECT_THROW(daubechies(Image(8, 8, 3), 1), Error);
    EXPECT_THROW(daubechies(Image(), 1), Error);
    EXPECT_THROW(inverse_daubechies(Image(6, 8, 1), 2), Error);
}
