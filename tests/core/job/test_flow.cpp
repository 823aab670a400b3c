// Bands and overlap change when things happen, never what comes out: same bytes, same report; and no stop leaves half a file.
#include "core/input/synthetic_exr.h"
#include "core/scenes.h"
#include "core/scratch.h"

#include <burnish/burnish.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace burnish;
namespace fs = std::filesystem;

namespace {

constexpr int kSize = 96;
constexpr FlowSettings kNarrow{kSize * 16, 3};  // six bands

std::string bytes_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Without what differs from run to run: times and places.
nlohmann::json comparable(const Report& report) {
    nlohmann::json json = report_to_json(report);
    json.erase("seconds"), json.erase("job");
    for (nlohmann::json& frame : json["frames"]) frame.erase("seconds"), frame.erase("output");
    return json;
}

/// A sphere with everything a job may read: beauty with broken pixels, ids, UVs, roughness.
SyntheticPart sphere_part(float light, int tile) {
    const AovFrame frame = scenes::sphere_frame(kSize);
    const Image &p = frame.layer(Role::position), &n = frame.layer(Role::normal);
    Image beauty(kSize, kSize, 4, light), uv(kSize, kSize, 2), id(kSize, kSize, 1), rough(kSize, kSize, 1);
    for (size_t i = 0; i < p.pixel_count(); ++i) {
        const float *at = p.at(i), *normal = n.at(i);
        uv.at(i)[0] = at[0] + 0.3f * at[1] * at[1], uv.at(i)[1] = at[1] - 0.2f * at[0];
        *id.at(i) = normal[2] > 0.7f ? 2 : 1;
        *rough.at(i) = 0.2f + 0.3f * std::fabs(normal[1]);
        if (i % 501 == 0) beauty.at(i)[1] = NAN;
    }
    SyntheticPart part;
    part.layers = {{{"R", "G", "B", "A"}, beauty},
                   {{"P.X", "P.Y", "P.Z"}, p},
                   {{"N.X", "N.Y", "N.Z"}, n},
                   {{"UV.U", "UV.V"}, uv},
                   {{"IndexOB.X"}, id},
                   {{"roughness.X"}, rough},
                   {{"DiffDir.R", "DiffDir.G", "DiffDir.B"}, Image(kSize, kSize, 3, 0.1f)}};
    part.tile = tile;
    return part;
}

class Flow : public testing::Test {
protected:
    Flow() {
        AovFrame picture;
        picture.data_window = picture.display_window = {0, 0, 64, 32};
        const Image sky = scenes::stress_light(3, 32, 6);
        write_exr(scratch.file("sky.exr"), picture, {{{"R", "G", "B"}, &sky}}, PixelType::float32);
        job.environment = scratch.file("sky.exr"), job.material = "chrome";
        job.camera = R"({"position": [0, 0, 6]})";
        job.estimator.samples = 4;
    }

    /// Frames 1 to `count`, each of its own light.
    void write_sequence(int count) {
        for (int frame = 1; frame <= count; ++frame) {
            const std::string file = scratch.file("in.000" + std::to_string(frame) + ".exr");
            write_synthetic(file, {sphere_part(0.1f * static_cast<float>(frame), 0)});
        }
        job.aovs = scratch.file("in.####.exr");
    }

    Report run_to(const std::string& folder, const FlowSettings& flow, const Progress& progress = {}) {
        const bool several = job.aovs.find('#') != std::string::npos;
        job.output.file = scratch.file(folder + (several ? "/out.####.exr" : "/out.exr"));
        return run(job, progress, flow);
    }

    void cut(int frame) {
        const std::string file = scratch.file("in.000" + std::to_string(frame) + ".exr");
        fs::resize_file(file, fs::file_size(file) * 2 / 3);
    }

    std::vector<std::string> files_in(const std::string& folder) const {
        std::vector<std::string> names;
        if (!fs::exists(scratch.path() / folder)) return names;
        for (const auto& entry : fs::directory_iterator(scratch.path() / folder)) names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }

    void expect_same_bytes(const std::string& folder, const std::string& other) {
        EXPECT_FALSE(files_in(folder).empty());
        EXPECT_EQ(files_in(folder), files_in(other));
        for (const std::string& name : files_in(folder))
            EXPECT_TRUE(bytes_of(scratch.file(folder + "/" + name)) == bytes_of(scratch.file(other + "/" + name))) << name;
    }

    /// One band and six give the same files and the same report.
    void expect_bands_do_not_show(int tile) {
        job.aovs = write_synthetic(scratch.file("in.exr"), {sphere_part(0.2f, tile)});
        job.output.preview = scratch.file("whole/preview.png");
        const Report whole = run_to("whole", {});
        job.output.preview = scratch.file("bands/preview.png");
        const Report bands = run_to("bands", kNarrow);
        EXPECT_EQ(files_in("bands").size(), 2u);
        EXPECT_EQ(comparable(whole), comparable(bands));
        EXPECT_GT(whole.frames.at(0).pixels.at(0).second, 1000u);
        expect_same_bytes("whole", "bands");
    }

    Scratch scratch;
    Job job;
};

}  // namespace

TEST_F(Flow, BandsGiveTheBytesOfTheWholeFrame) {
    job.output.diagnostics = true;
    expect_bands_do_not_show(0);
}

TEST_F(Flow, BandsOfTheReferenceDrawTheSameSamples) {
    job.estimator.kind = EstimatorKind::reference, job.estimator.max_samples = 64;
    expect_bands_do_not_show(0);
}

TEST_F(Flow, BandsDoNotShowUnderLightsThatAreNear) {
    CubeMapSettings map;
    map.file = job.environment, map.proxy.kind = ProxyKind::box, map.proxy.box.half = Vec3f(4, 4, 4);
    for (const float x : {-1.0f, 1.0f}) {
        map.centre = Vec3f(x, 0, 0);
        job.lights[x < 0 ? "left" : "right"].kind = map;
    }
    job.lights["lamp"] = {
        AreaSettings{{{-1, 2, 1}, {-1, 2, 3}, {1, 2, 3}, {1, 2, 1}}, Color3f(5, 4, 3), "", true}, 1, {1, 1, 1}, false, ""};
    for (const ShadingDensity density : {ShadingDensity::dense, ShadingDensity::sparse}) {
        job.density.density = density;
        expect_bands_do_not_show(0);
    }
}

/// Nothing but what a pixel needs is read or made, and the report says so; what is missing is told before the first frame.
TEST_F(Flow, LightsThatNoPixelSeesAreNotLoaded) {
    job.aovs = write_synthetic(scratch.file("in.exr"), {sphere_part(0.2f, 0)});
    CubeMapSettings map;
    map.file = job.environment;
    job.lights["here"].kind = map;
    map.centre = Vec3f(100, 0, 0);
    job.lights["far"].kind = map;
    const Report report = run_to("out", kNarrow);
    EXPECT_EQ(report.saved.at(0), "2 of 3 lights loaded");
    EXPECT_EQ(report.frames.at(0).saved, std::vector<std::string>{"10 of 17 channels decoded"});
    EXPECT_TRUE(std::ranges::none_of(report.notes, [](const std::string& note) { return note.starts_with("far: "); }));
    std::get<CubeMapSettings>(job.lights["far"].kind).file = scratch.file("none.exr");
    try {
        run_to("missing", kNarrow);
        FAIL() << "went without the file";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::read_failed);
        EXPECT_NE(std::string(error.what()).find("lights.far: "), std::string::npos) << error.what();
    }
}

TEST_F(Flow, MirrorsOfASequenceAreReadFrameByFrame) {
    write_sequence(2);
    MirrorSettings mirror;
    mirror.file = job.aovs, mirror.plane = {Vec3f(0, 0, 0), Vec3f(0, 0, 1)};
    job.lights["floor"].kind = mirror;
    job.camera = R"({"position": [0, 0, 6], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov_x_deg": 20})";
    std::get<MirrorSettings>(job.lights["floor"].kind).camera = job.camera;
    job.chain = {"floor"};
    const Report report = run_to("out", kNarrow);
    for (size_t i = 0; i < 2; ++i) {
        const std::vector<std::string>& notes = report.frames.at(i).notes;
        EXPECT_EQ(std::ranges::count_if(notes, [](const std::string& note) { return note.starts_with("floor: "); }) > 0, true);
    }
    job.aovs = scratch.file("in.0001.exr"), job.frames.clear();
    EXPECT_THROW(run_to("one", kNarrow), Error) << "one frame and a sequence of mirrors";
}

TEST_F(Flow, BandsOfTiledFilesToo) { expect_bands_do_not_show(32); }

TEST_F(Flow, BandsKnowTheirNeighboursWhereTangentsComeFromUvs) {
    LobeParameters brushed;
    brushed.mx = 0.3f, brushed.my = 0.05f;
    job.materials["brushed"] = {"brushed", Color3f(0, 0, 0), {brushed}};
    job.material = "brushed";
    expect_bands_do_not_show(0);
}

TEST_F(Flow, BandsOfSparseShadingDoNotShow) {
    job.density.density = ShadingDensity::sparse;
    LobeParameters rough;
    rough.mx = rough.my = 0.4f;
    job.materials["rough"] = {"rough", Color3f(0, 0, 0), {rough}};
    job.material = "rough";
    job.output.diagnostics = true;
    expect_bands_do_not_show(0);
}

TEST_F(Flow, BandsOfRulesLayersAndDifferences) {
    job.composite.mode = CompositeMode::difference;
    job.assign = {{"gold", 2, {}, {}}};
    job.old_materials = {{"chrome", "rubber"}, {"gold", "chrome"}};
    job.per_pixel.roughness = true;
    expect_bands_do_not_show(0);
}

TEST_F(Flow, BandsFindTheCameraThatTheWholeFrameShows) {
    job.camera.clear();
    expect_bands_do_not_show(0);
}

TEST_F(Flow, OverlapChangesNeitherFilesNorReport) {
    write_sequence(5);
    const Report sequential = run_to("sequential", {FlowSettings().band_pixels, 1});
    const Report overlapping = run_to("overlapping", {});
    const Report narrow = run_to("narrow", kNarrow);
    ASSERT_EQ(sequential.frames.size(), 5u);
    for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(overlapping.frames[frame].frame, frame + 1);
    EXPECT_EQ(comparable(sequential), comparable(overlapping));
    EXPECT_EQ(comparable(sequential), comparable(narrow));
    expect_same_bytes("sequential", "overlapping");
    expect_same_bytes("sequential", "narrow");
}

TEST_F(Flow, ABrokenFrameEndsTheRunAfterThoseBeforeIt) {
    write_sequence(5);
    cut(3);
    job.output.report = scratch.file("report.json");
    for (const FlowSettings& flow : {FlowSettings{}, kNarrow}) {
        fs::remove_all(scratch.path() / "out");
        try {
            run_to("out", flow);
            FAIL() << "was read";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::read_failed);
            EXPECT_TRUE(std::string(error.what()).starts_with("frame=3 ")) << error.what();
        }
        EXPECT_EQ(files_in("out"), (std::vector<std::string>{"out.0001.exr", "out.0002.exr"}));
        const auto report = nlohmann::json::parse(bytes_of(job.output.report));
        EXPECT_EQ(report["frames"].size(), 3u);
        EXPECT_EQ(report["frames"][2]["status"], "failed");
    }
}

TEST_F(Flow, ABrokenFrameIsLeftOutWhenToldSo) {
    write_sequence(5);
    cut(3);
    job.bad_frames = BadFrames::skip;
    const Report whole = run_to("whole", {}), bands = run_to("bands", kNarrow);
    EXPECT_EQ(comparable(whole), comparable(bands));
    EXPECT_EQ(whole.count(FrameStatus::done), 4u);
    EXPECT_EQ(whole.frames[2].status, FrameStatus::failed);
    EXPECT_EQ(files_in("bands").size(), 4u);
    expect_same_bytes("whole", "bands");
}

TEST_F(Flow, FilesThatAreThereAreNotMadeAgain) {
    write_sequence(3);
    job.output.skip_existing = true;
    run_to("out", {});
    fs::remove(scratch.file("out/out.0002.exr"));
    const Report report = run_to("out", {});
    EXPECT_EQ(report.count(FrameStatus::skipped), 2u);
    EXPECT_EQ(report.frames[1].status, FrameStatus::done);
    EXPECT_EQ(files_in("out").size(), 3u);
}

TEST_F(Flow, CancellingInFlightLeavesWholeFramesOnly) {
    write_sequence(5);
    run_to("all", {});
    for (const char* stage : {"reading", "shading", "writing"}) {
        fs::remove_all(scratch.path() / "out");
        bool stopped = false;
        const Progress stop([&](const std::string& name, float done) {
            EXPECT_FALSE(stopped) << "told after it said stop";
            stopped = name == stage && done > 0.5f;
            return !stopped;
        });
        try {
            run_to("out", kNarrow, stop);
            FAIL() << "not cancelled";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::cancelled);
            EXPECT_EQ(std::string(error.what()), std::string("cancelled during ") + stage);
        }
        EXPECT_LT(files_in("out").size(), 5u);
        for (const std::string& name : files_in("out"))
            EXPECT_TRUE(bytes_of(scratch.file("out/" + name)) == bytes_of(scratch.file("all/" + name))) << name;
    }
}

TEST_F(Flow, ReadsOnlyWhatTheJobUses) {
    job.aovs = write_synthetic(scratch.file("in.exr"), {sphere_part(0.2f, 0)});
    const Report report = run_to("out", {});
    EXPECT_EQ(report.frames.at(0).roles, (std::vector<std::string>{"beauty", "alpha", "position", "normal"}));
}
