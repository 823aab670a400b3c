#include <burnish/plan/planner.h>
#include "core/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

using namespace burnish;

namespace {

/// A sphere under a room with bright windows, to be planned.
class Plans : public ::testing::Test {
protected:
    Plans() : frame(scenes::sphere_frame(48)) {
        assignment.width = assignment.height = 48;
        assignment.rule.assign(frame.layer(Role::normal).pixel_count(), 0);
        assignment.coverage.assign(assignment.rule.size(), 1.0f), assignment.counts = {assignment.rule.size()};
        Image picture(128, 64, 3);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 128; ++x) std::fill_n(picture.at(x, y), 3, x / 16 % 2 == 0 && y / 8 % 2 == 0 ? 20.0f : 0.5f);
        light.emplace(Environment::from_image(picture, {}, "windows"));
        surfaces.emplace(frame, assignment, SurfaceSettings{});
        material.lobes = {scenes::lobe_of(ModelId::ggx, 0.1f, 0.1f)};
    }

    PlanSubject subject(const QualityTarget& target) {
        EstimatorSettings exact;
        exact.kind = EstimatorKind::reference, exact.tolerance = truth_tolerance(target), exact.adaptive = true;
        const MaterialShader one(material, *light, with({}, kProbe)), other(material, *light, other_probe({}));
        Truth truth(*surfaces, check_sample(*surfaces, assignment, 0, 300, {one, other}),
                    MaterialShader(material, *light, exact));
        PlanSubject subject{&material, std::move(truth), {}, {}, {0, 1, 2}};
        subject.cost.pixels = pixels, subject.cost.frame_pixels = 2 * pixels, subject.cost.face_texels = 6 * 64 * 64;
        subject.cost.is_near = is_near;
        subject.shader = [this](const EstimatorSettings& settings, const LobeChoice& lobes) {
            return MaterialShader(with_lobes(material, lobes), *light, settings);
        };
        return subject;
    }
    Planner plan(const QualityTarget& target) {
        std::vector<PlanSubject> subjects;
        subjects.push_back(subject(target));
        return {std::move(subjects), target, {}, machine_costs()};
    }
    double dense_db(const Planner& planner) const {
        const MaterialPlan& plan = planner.plans()[0];
        return planner.truth(0).closeness(MaterialShader(with_lobes(material, plan.lobes), *light, plan.estimator)).psnr_db;
    }

    size_t pixels = 200'000;
    bool is_near = false;
    AovFrame frame;
    Assignment assignment;
    std::optional<Environment> light;
    std::optional<Surfaces> surfaces;
    Material material;
};

}  // namespace

TEST_F(Plans, MeetWhatIsAskedAndNoMoreThanItTakes) {
    std::vector<double> seconds;
    for (const float psnr : {30.0f, 36.0f, 42.0f}) {
        const Planner planner = plan({psnr, 0, 0});
        EXPECT_GE(dense_db(planner), psnr - 0.5) << in_words(planner.plans()[0]);
        seconds.push_back(planner.plans()[0].expected_seconds);
    }
    EXPECT_LT(seconds.front(), seconds.back());
}

TEST_F(Plans, KeepSinglePixelsWithinALargestError) {
    const Planner planner = plan({0, 0.05f, 0});
    const MaterialPlan& plan = planner.plans()[0];
    EXPECT_LE(planner.truth(0).closeness(MaterialShader(material, *light, plan.estimator)).largest, 0.05) << in_words(plan);
}

TEST_F(Plans, MakeTheBestOfATime) {
    const Planner hasty = plan({0, 0, 0.002f}), patient = plan({0, 0, 2.0f});
    EXPECT_LT(hasty.level(), patient.level());
    EXPECT_LT(hasty.plans()[0].expected_seconds, patient.plans()[0].expected_seconds);
    EXPECT_LE(patient.plans()[0].expected_seconds, 2.0);
}

TEST_F(Plans, LeaveOutLobesThatNobodySees) {
    LobeParameters dim = scenes::lobe_of(ModelId::kurt, 0.4f, 0.4f);
    dim.strength = 1e-5f;
    material.lobes.insert(material.lobes.begin(), dim);
    EXPECT_EQ(plan({40, 0, 0}).plans()[0].lobes, LobeChoice{1});
    material.lobes[0].strength = 0.3f;
    EXPECT_EQ(plan({40, 0, 0}).plans()[0].lobes, (LobeChoice{0, 1}));
}

/// A billion pixels pay any maps.
TEST_F(Plans, TakeMapsWhereTheyCanBeAndAreCloseEnough) {
    pixels = 1'000'000'000;
    material.lobes = {scenes::lobe_of(ModelId::ggx, 0.4f, 0.4f)};
    const auto kind = [&](float psnr) { return plan({psnr, 0, 0}).plans()[0].estimator.kind; };
    EXPECT_EQ(kind(20), EstimatorKind::factored);
    EXPECT_NE(kind(48), EstimatorKind::factored);
    is_near = true;
    EXPECT_NE(kind(20), EstimatorKind::factored);
    is_near = false, material.lobes[0].my = 0.1f;
    EXPECT_NE(kind(20), EstimatorKind::factored);
}

TEST_F(Plans, AreCorrectedWhereTheFrameMisses) {
    Planner planner = plan({36, 0, 0});
    const std::string before = in_words(planner.plans()[0]);
    Closeness found;
    found.psnr_db = 36.5, found.low_db = 36.2, found.pixels = 300;
    EXPECT_FALSE(planner.correct(0, found));
    found.psnr_db = 29, found.low_db = 28.5;
    EXPECT_TRUE(planner.correct(0, found));
    EXPECT_NE(in_words(planner.plans()[0]), before);
}

TEST_F(Plans, FallBackToTheReferenceForWhatNothingElseReaches) {
    const Planner planner = plan({62, 0, 0});
    EXPECT_EQ(planner.plans()[0].estimator.kind, EstimatorKind::reference) << in_words(planner.plans()[0]);
}

TEST(Misses, AreWhatWasAskedAndIsNotThere) {
    Closeness found;
    found.psnr_db = 44.6, found.largest = 0.03;
    EXPECT_FALSE(misses(found, {45, 0, 0}));
    EXPECT_TRUE(misses(found, {45.2f, 0, 0}));
    EXPECT_TRUE(misses(found, {40, 0.02f, 0}));
    EXPECT_FALSE(misses(found, {0, 0, 0.1f}));
}

TEST(Credit, IsCautiousWithFewPixels) {
    Closeness found;
    found.psnr_db = 45, found.low_db = 42, found.largest = 0.03;
    EXPECT_DOUBLE_EQ(credit(found, {40, 0, 0}), 42.25);
    found.low_db = 44.9;
    EXPECT_DOUBLE_EQ(credit(found, {40, 0, 0}), 45);
    EXPECT_LT(credit(found, {0, 0.02f, 0}), level_of({0, 0.02f, 0}));
    EXPECT_GT(credit(found, {0, 0.04f, 0}), level_of({0, 0.04f, 0}));
}
