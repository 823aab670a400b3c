#include <burnish/base/error.h>
#include <burnish/base/parallel.h>
#include <burnish/output/compare.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace burnish;

namespace {

double encoded(double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; }

Image noise(int width, int height, unsigned seed) {
    Image image(width, height, 3);
    std::mt19937 random(seed);
    for (float& value : image.data) value = static_cast<float>(random() % 10000) / 1000;
    return image;
}

}  // namespace

TEST(CompareImages, FindsNothingBetweenEqualImages) {
    const Image image = noise(7, 5, 1);
    const Comparison c = compare_images(image, image, nullptr);
    EXPECT_EQ(c.pixels, 35u);
    EXPECT_EQ(c.display_psnr_db, std::numeric_limits<double>::infinity());
    EXPECT_EQ(c.relative_rms, 0);
    EXPECT_EQ(c.rel_mse, 0);
    EXPECT_EQ(c.largest_error, 0);
}

TEST(CompareImages, AgreesWithTheClosedFormForAConstantError) {
    const Image reference(8, 4, 3, 2.0f), test(8, 4, 3, 2.2f);
    const Comparison c = compare_images(test, reference, nullptr);
    const double d = encoded(0.18 * 2.2f / 2) - encoded(0.18);
    EXPECT_NEAR(c.reference_mean, 2, 1e-12);
    EXPECT_NEAR(c.display_psnr_db, -20 * std::log10(d), 1e-6);
    EXPECT_NEAR(c.relative_rms, 0.1, 1e-6);
    EXPECT_NEAR(c.rel_mse, 0.04 / (4 + 0.0004), 1e-6);
    EXPECT_NEAR(c.largest_error, 0.2, 1e-6);
}

TEST(CompareImages, ClampsTheDisplayButNotTheLinearMeasures) {
    Image reference(10, 10, 3, 1.0f), test = reference;
    for (int c = 0; c < 3; ++c) reference.at(3, 4)[c] = 1000, test.at(3, 4)[c] = 2000;  // both far beyond white
    const Comparison c = compare_images(test, reference, nullptr);
    const double mean = (99 + 1000) / 100.0;
    EXPECT_EQ(c.display_psnr_db, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(c.relative_rms, std::sqrt(1e6 / 100) / mean, 1e-9);
    EXPECT_NEAR(c.rel_mse, 0.01, 1e-6);
    EXPECT_EQ(c.largest_error, 1000);
    EXPECT_EQ(c.largest_x, 3);
    EXPECT_EQ(c.largest_y, 4);
}

TEST(CompareImages, LooksOnlyWhereTheMaskCovers) {
    const Image reference(4, 4, 3, 1.0f);
    Image test = reference, mask(4, 4, 1);
    *mask.at(1, 1) = *mask.at(2, 2) = 1;
    test.at(0, 0)[0] = 50;
    test.at(2, 2)[1] = 1.3f;
    const Comparison c = compare_images(test, reference, &mask);
    EXPECT_EQ(c.pixels, 2u);
    EXPECT_NEAR(c.largest_error, 0.3, 1e-6);
    EXPECT_NEAR(c.relative_rms, std::sqrt(0.09 / 6), 1e-6);
}

TEST(CompareImages, CountsNonFinitePixelsApart) {
    const Image reference(4, 1, 3, 1.0f);
    Image test = reference;
    test.at(0, 0)[2] = NAN;
    test.at(3, 0)[0] = INFINITY;
    const Comparison c = compare_images(test, reference, nullptr);
    EXPECT_EQ(c.pixels, 2u);
    EXPECT_EQ(c.non_finite, 2u);
    EXPECT_EQ(c.relative_rms, 0);
}

TEST(CompareImages, GivesTheSameBitsForAnyThreadCount) {
    const Image a = noise(301, 203, 1), b = noise(301, 203, 2);
    Comparison one, all = compare_images(a, b, nullptr);
    {
        const ThreadLimit limit(1);
        one = compare_images(a, b, nullptr);
    }
    EXPECT_EQ(one.display_psnr_db, all.display_psnr_db);
    EXPECT_EQ(one.relative_rms, all.relative_rms);
    EXPECT_EQ(one.rel_mse, all.rel_mse);
    EXPECT_EQ(one.largest_x, all.largest_x);
}

TEST(CompareImages, RefusesDifferentSizesAndCoversNothingQuietly) {
    EXPECT_THROW(compare_images(Image(2, 2, 3), Image(2, 3, 3), nullptr), Error);
    EXPECT_THROW(compare_images(Image(2, 2, 3), Image(2, 2, 1), nullptr), Error);
    const Image wrong_mask(1, 2, 1);
    EXPECT_THROW(compare_images(Image(2, 2, 3), Image(2, 2, 3), &wrong_mask), Error);
    const Image empty_mask(2, 2, 1);
    EXPECT_EQ(compare_images(Image(2, 2, 3), Image(2, 2, 3), &empty_mask).pixels, 0u);
}

TEST(DifferenceImage, IsRedWhereBrighterBlueWhereDarkerGreyWhereEqual) {
    const Image reference(5, 1, 3, 1.0f);
    Image test = reference, mask(5, 1, 1, 1.0f);
    for (int c = 0; c < 3; ++c) test.at(1, 0)[c] = 1.5f, test.at(2, 0)[c] = 0.5f;
    test.at(3, 0)[0] = NAN;
    *mask.at(4, 0) = 0;
    const Image difference = difference_image(test, reference, &mask, 2);
    const std::vector<float> expected = {0.5f, 0.5f, 0.5f, 1, 0, 0, 0, 0, 1, 1, 0, 1, 0, 0, 0};
    for (size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(difference.data[i], expected[i], 1e-6f) << i;
}
