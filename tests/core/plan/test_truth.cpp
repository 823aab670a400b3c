#include <burnish/base/display.h>
#include <burnish/light/environment.h>
#include <burnish/plan/truth.h>
#include "core/scenes.h"

#include <gtest/gtest.h>

#include <set>

using namespace burnish;

namespace {

/// A sphere of one material under a light that brightens upwards.
struct Ball {
    explicit Ball(int size = 64) : frame(scenes::sphere_frame(size)) {
        assignment.width = assignment.height = size;
        assignment.rule.assign(frame.layer(Role::normal).pixel_count(), 0);
        assignment.coverage.assign(assignment.rule.size(), 1.0f), assignment.counts = {assignment.rule.size()};
        Image picture(64, 32, 3);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x) std::fill_n(picture.at(x, y), 3, 0.5f + static_cast<float>(31 - y) / 31);
        light.emplace(Environment::from_image(picture, {}, "gradient"));
        surfaces.emplace(frame, assignment, SurfaceSettings{});
        material.lobes = {scenes::lobe_of(ModelId::ggx, 0.2f, 0.2f)};
        settings.kind = EstimatorKind::reference, settings.tolerance = 0.002f;
    }
    CheckSample sample(size_t pixels) const {
        EstimatorSettings few;
        few.kind = EstimatorKind::regular, few.samples = 4;
        const MaterialShader one(material, *light, few);
        few.samples = 19;
        return check_sample(*surfaces, assignment, 0, pixels, {one, MaterialShader(material, *light, few)});
    }
    Truth truth(size_t pixels) const { return {*surfaces, sample(pixels), MaterialShader(material, *light, settings)}; }

    AovFrame frame;
    Assignment assignment;
    std::optional<Environment> light;
    std::optional<Surfaces> surfaces;
    Material material;
    EstimatorSettings settings;
};

}  // namespace

TEST(CheckSample, StandsForAllOfTheMaterial) {
    const Ball ball;
    const CheckSample sample = ball.sample(200);
    ASSERT_EQ(sample.pixels.size(), 200u);
    double sum = 0, upper = 0;
    for (size_t i = 0; i < sample.pixels.size(); ++i) {
        EXPECT_EQ(ball.surfaces->validity(sample.pixels[i]), Validity::valid);
        sum += sample.weights[i];
        if (sample.pixels[i] < ball.assignment.rule.size() / 2) upper += sample.weights[i];
    }
    EXPECT_NEAR(sum, 1, 0.05);
    EXPECT_NEAR(upper, 0.5, 0.05);
    EXPECT_EQ(sample.pixels, ball.sample(200).pixels);
}

TEST(CheckSample, IsAllWhereThereIsLittle) {
    const Ball ball(8);
    EXPECT_EQ(ball.sample(1000).pixels.size(), ball.surfaces->rule_counts()[0]);
}

TEST(Truth, TellsAKnownErrorInDecibels) {
    const Ball ball;
    const Truth truth = ball.truth(300);
    EstimatorSettings exact = ball.settings;
    std::vector<Color3f> brighter = truth.shade(MaterialShader(ball.material, *ball.light, exact));
    double mean = 0, square = 0;
    for (const Color3f& color : brighter) mean += color.y / static_cast<double>(brighter.size());
    for (Color3f& color : brighter) {
        const double shown = display_encoded(kMiddleGrey / mean * color.y);
        color *= 1.1f;
        square += std::pow(display_encoded(kMiddleGrey / mean * color.y) - shown, 2) / static_cast<double>(brighter.size());
    }
    const Closeness found = truth.closeness(brighter);
    EXPECT_NEAR(found.psnr_db, -10 * std::log10(square), 0.1);
    EXPECT_LT(found.low_db, found.psnr_db);
    EXPECT_GT(found.low_db, found.psnr_db - 1);
    EXPECT_EQ(found.pixels, 300u);
}

TEST(Truth, TakesItsOwnNoiseOffTheFigure) {
    Ball ball;
    const Truth exact = ball.truth(300);
    ball.settings.tolerance = 0.05f, ball.settings.adaptive = true, ball.settings.max_samples = 512;
    const Truth noisy = ball.truth(300);
    EXPECT_LT(noisy.lookups(), exact.lookups());
    EstimatorSettings few;
    few.kind = EstimatorKind::regular, few.samples = 7;
    const MaterialShader estimator(ball.material, *ball.light, few);
    EXPECT_NEAR(noisy.closeness(estimator).psnr_db, exact.closeness(estimator).psnr_db, 0.5);
}
