// Refinement: every step is nearer to the exact picture, the last one is it, threads and cancelling do not show.
#include "core/scenes.h"

#include <burnish/burnish.h>

#include <gtest/gtest.h>

using namespace burnish;

namespace {

constexpr int kSize = 24;

class Progressive : public testing::Test {
protected:
    Progressive() : frame(scenes::sphere_frame(kSize)), sky(scenes::stress_light(1, 32, 6)) {
        frame.layers[Role::beauty] = Image(kSize, kSize, 3, 0.25f);
        LobeParameters lobe = scenes::lobe_of(ModelId::ggx, 0.25f, 0.25f);
        job.materials["satin"] = {"satin", Color3f(0, 0, 0), {lobe}};
        job.material = "satin";
        job.estimator.samples = 2, job.estimator.tolerance = 0.02f, job.estimator.max_samples = 4096;
    }

    Wardrobe wardrobe() const { return prepare_wardrobe(job); }
    Rig rig() const {
        const ColorFlow color(job);
        return build_rig(job, wardrobe().rules, color, light_from_picture(job, color, sky, Renderer::unknown), {});
    }
    Refinement refinement() const { return Refinement(job, frame, nullptr, wardrobe(), rig(), nullptr); }

    std::vector<RefinedFrame> all_steps() const {
        Refinement steps = refinement();
        std::vector<RefinedFrame> taken;
        while (!steps.is_done()) taken.push_back(steps.next(Progress()));
        return taken;
    }

    Image exact() const {
        Job reference = job;
        reference.estimator.kind = EstimatorKind::reference;
        reference.estimator.tolerance = 0.003f, reference.estimator.max_samples = 8192;
        const Look look = prepare_look(reference, wardrobe(), rig(), {});
        return run_frame(reference, frame, nullptr, look, nullptr, Progress()).composite.overlay;
    }

    static double relative_rms(const Image& a, const Image& b) {
        double error = 0, size = 0;
        for (size_t i = 0; i < a.data.size(); ++i) {
            error += (a.data[i] - b.data[i]) * (a.data[i] - b.data[i]);
            size += b.data[i] * b.data[i];
        }
        return std::sqrt(error / size);
    }

    AovFrame frame;
    Image sky;
    Job job;
};

}  // namespace

TEST_F(Progressive, EveryStepIsNearerAndTheLastIsTheReference) {
    const Image truth = exact();
    const std::vector<RefinedFrame> steps = all_steps();
    ASSERT_GE(steps.size(), 6u);
    EXPECT_EQ(steps[0].label, "first look");
    EXPECT_EQ(steps[3].label, "reference, 512 lookups");
    double before = relative_rms(steps[1].result.composite.overlay, truth);
    for (size_t i = 2; i < steps.size(); ++i) {
        const double error = relative_rms(steps[i].result.composite.overlay, truth);
        EXPECT_LT(error, before * 1.02) << steps[i].label;
        before = error;
        EXPECT_EQ(steps[i].is_final, i + 1 == steps.size());
    }
    EXPECT_LT(before, job.estimator.tolerance);
    job.estimator.kind = EstimatorKind::reference, job.estimator.max_samples = 512;
    const Look look = prepare_look(job, wardrobe(), rig(), {});
    const Image noisy = run_frame(job, frame, nullptr, look, nullptr, Progress()).composite.overlay;
    EXPECT_LT(relative_rms(steps[3].result.composite.overlay, truth), relative_rms(noisy, truth)) << "as many lookups, unmixed";
}

TEST_F(Progressive, ThreadsDoNotShow) {
    std::vector<std::vector<RefinedFrame>> taken;
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        taken.push_back(all_steps());
    }
    ASSERT_EQ(taken[0].size(), taken[1].size());
    for (size_t i = 0; i < taken[0].size(); ++i)
        EXPECT_EQ(taken[0][i].result.composite.beauty.data, taken[1][i].result.composite.beauty.data) << taken[0][i].label;
}

TEST_F(Progressive, AStepThatWasCancelledMayBeTakenAgain) {
    const std::vector<RefinedFrame> whole = all_steps();
    Refinement steps = refinement();
    for (const RefinedFrame& expected : whole) {
        int calls = 0;
        const Progress stops([&](const std::string&, float) { return ++calls < 2; });
        EXPECT_THROW(steps.next(stops), Error) << expected.label;
        const RefinedFrame again = steps.next(Progress());
        EXPECT_EQ(again.step, expected.step);
        EXPECT_EQ(again.result.composite.beauty.data, expected.result.composite.beauty.data) << expected.label;
    }
}

TEST_F(Progressive, DifferencesComeToZeroWhereNothingChanges) {
    job.composite.mode = CompositeMode::difference;
    job.old_materials = {{"satin", "satin"}};
    for (const RefinedFrame& step : all_steps())
        for (const float value : step.result.composite.beauty.data) ASSERT_TRUE(value == 0.25f || value == 1.0f) << step.label;
}

TEST_F(Progressive, SamplesOfFinerSurfacesAreRefinedToo) {
    const AovFrame fine = std::exchange(frame, scenes::sphere_frame(kSize / 2));
    frame.layers = {{Role::beauty, Image(kSize / 2, kSize / 2, 3, 0.25f)}};
    Refinement steps(job, frame, &fine, wardrobe(), rig(), nullptr);
    const Look look = prepare_look(job, wardrobe(), rig(), {});
    const FrameResult plain = run_frame(job, frame, &fine, look, nullptr, Progress());
    steps.next(Progress());
    EXPECT_EQ(steps.next(Progress()).result.composite.beauty.data, plain.composite.beauty.data) << "the step as set";
    while (!steps.is_done()) EXPECT_EQ(steps.next(Progress()).result.composite.beauty.width, kSize / 2);
}
