// The facade in C++: files and memory give the same pixels, a failing frame is told, cancelling leaves nothing.
#include "core/scenes.h"
#include "core/scratch.h"

#include <burnish/burnish.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace burnish;

namespace {

/// A sphere's frame and a bright sky as files, and a job on them.
class Run : public testing::Test {
protected:
    Run() : frame(scenes::sphere_frame(48)) {
        frame.layers[Role::beauty] = Image(48, 48, 3, 0.25f);
        sky = Image(64, 32, 3, 1.0f);
        for (int x = 10; x < 20; ++x) sky.at(x, 8)[0] = 9.0f;
        write_exr(scratch.file("in.exr"), frame,
                  {{{"R", "G", "B"}, &frame.layers[Role::beauty]},
                   {{"P.X", "P.Y", "P.Z"}, &frame.layers[Role::position]},
                   {{"N.X", "N.Y", "N.Z"}, &frame.layers[Role::normal]}},
                  PixelType::float32);
        AovFrame picture;
        picture.data_window = picture.display_window = {0, 0, 64, 32};
        write_exr(scratch.file("sky.exr"), picture, {{{"R", "G", "B"}, &sky}}, PixelType::float32);
        job.aovs = scratch.file("in.exr"), job.environment = scratch.file("sky.exr"), job.material = "chrome";
        job.camera = R"({"position": [0, 0, 6]})";
        job.output.file = scratch.file("out/out.exr"), job.output.pixel_type = PixelType::float32;
    }

    Image written(const std::string& layer) {
        ReadOptions options;
        options.roles = {Role::beauty};
        options.channels[Role::beauty] = layer;
        return read_frame(job.output.file, options).layer(Role::beauty);
    }

    Scratch scratch;
    AovFrame frame;
    Image sky;
    Job job;
};

}  // namespace

TEST_F(Run, WritesThePixelsThatMemoryGives) {
    const Report report = run(job, Progress());
    EXPECT_EQ(report.count(FrameStatus::done), 1u);
    EXPECT_EQ(exit_code(report), 0);
    const ColorFlow color(job);
    Wardrobe wardrobe = prepare_wardrobe(job);
    const auto light = light_from_picture(job, color, sky, Renderer::unknown);
    Rig rig = build_rig(job, wardrobe.rules, color, light, {});
    const Look look = prepare_look(job, std::move(wardrobe), std::move(rig), {});
    const FrameResult result = run_frame(job, frame, nullptr, look, nullptr, Progress());
    EXPECT_EQ(written("burnish_spec").data, result.composite.overlay.data);
    EXPECT_GT(report.frames[0].lookups, 0);
}

TEST_F(Run, TellsProgressThatRisesToTheEnd) {
    float last = 0;
    run(job, Progress([&](const std::string&, float done) {
            EXPECT_GE(done, last);
            last = done;
            return true;
        }));
    EXPECT_EQ(last, 1.0f);
}

TEST_F(Run, LeavesNothingWhenCancelled) {
    job.output.report = scratch.file("out/report.json");
    const Progress stop([](const std::string& stage, float) { return stage != "writing"; });
    try {
        run(job, stop);
        FAIL() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::cancelled);
    }
    EXPECT_FALSE(std::filesystem::exists(scratch.file("out")));
}

TEST_F(Run, ReportsAFailedRun) {
    job.output.report = scratch.file("report.json");
    job.channels[Role::normal] = "Nope";
    EXPECT_THROW(run(job, Progress()), Error);
    EXPECT_TRUE(std::filesystem::exists(job.output.report));
}

TEST_F(Run, GoesOnPastABadFrameOnlyWhenTold) {
    std::filesystem::copy(job.aovs, scratch.file("in.0002.exr"));
    job.aovs = scratch.file("in.####.exr"), job.frames = "1-2", job.output.file = scratch.file("out.####.exr");
    EXPECT_THROW(run(job, Progress()), Error);
    job.bad_frames = BadFrames::skip;
    const Report report = run(job, Progress());
    EXPECT_EQ(report.count(FrameStatus::failed), 1u);
    EXPECT_EQ(report.count(FrameStatus::done), 1u);
    EXPECT_EQ(exit_code(report), 3);
}

TEST_F(Run, StopsAtABadLightEvenWhenFramesMayBeSkipped) {
    job.bad_frames = BadFrames::skip, job.environment = scratch.file("absent.hdr");
    EXPECT_THROW(run(job, Progress()), Error);
}

TEST_F(Run, AddsNewMinusOldMaterialInModeDifference) {
    job.composite.mode = CompositeMode::difference, job.old_materials["chrome"] = "chrome";
    run(job, Progress());
    const Image nothing = written("burnish_spec");
    for (const float value : nothing.data) ASSERT_EQ(value, 0.0f);
    job.old_materials["chrome"] = "rubber";
    run(job, Progress());
    const Image gain = written("burnish_spec");
    EXPECT_GT(*std::max_element(gain.data.begin(), gain.data.end()), 0.1f);
}

TEST(AssignMasks, LetsLaterMasksWin) {
    Image all(2, 1, 1, 1.0f), right(2, 1, 1);
    *right.at(1, 0) = 0.5f;
    const Assignment assignment = assign_masks({all, right});
    EXPECT_EQ(assignment.rule, (PixelVector<int16_t>{0, 1}));
    EXPECT_EQ(assignment.coverage, (PixelVector<float>{1.0f, 0.5f}));
    EXPECT_EQ(assignment.counts, (std::vector<size_t>{1, 1}));
}
