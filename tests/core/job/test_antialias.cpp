// Jobs with finer AOVs: bands do not show, whatever the filter reaches into, and what is counted is counted once.
#include "core/input/synthetic_exr.h"
#include "core/read_layer.h"
#include "core/scenes.h"
#include "core/scratch.h"

#include <burnish/burnish.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>

using namespace burnish;

namespace {

constexpr int kSize = 48;
const std::vector<std::string> kSpec{"burnish_spec.R", "burnish_spec.G", "burnish_spec.B"};

std::string bytes_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The picture alone: beauty, alpha and rendered specular.
SyntheticPart picture_part(const std::string& compression) {
    SyntheticPart part;
    part.layers = {{{"R", "G", "B", "A"}, Image(kSize, kSize, 4, 0.5f)},
                   {{"specular_direct.R", "specular_direct.G", "specular_direct.B"}, Image(kSize, kSize, 3, 0.125f)}};
    part.compression = compression;
    return part;
}

/// The surfaces alone, at `factor` times the size, cut to `data` where given.
SyntheticPart surfaces_part(int factor, const Window& data) {
    const int size = kSize * factor;
    const AovFrame frame = scenes::sphere_frame(size);
    const Image &p = frame.layer(Role::position), &n = frame.layer(Role::normal);
    const Window cut = data.width ? data : Window{0, 0, size, size};
    Image position(cut.width, cut.height, 3), normal(cut.width, cut.height, 3), uv(cut.width, cut.height, 2),
        id(cut.width, cut.height, 1), weight(cut.width, cut.height, 1, 1.0f);
    for (int y = 0; y < cut.height; ++y)
        for (int x = 0; x < cut.width; ++x) {
            const float *at = p.at(x + cut.x, y + cut.y), *direction = n.at(x + cut.x, y + cut.y);
            std::copy_n(at, 3, position.at(x, y)), std::copy_n(direction, 3, normal.at(x, y));
            uv.at(x, y)[0] = at[0] + 0.3f * at[1] * at[1], uv.at(x, y)[1] = at[1] - 0.2f * at[0];
            *id.at(x, y) = direction[2] > 0.7f ? 2 : 1;
            if ((x * 31 + y) % 997 == 0) *weight.at(x, y) = NAN;
        }
    SyntheticPart part;
    part.layers = {{{"P.X", "P.Y", "P.Z"}, position},
                   {{"N.X", "N.Y", "N.Z"}, normal},
                   {{"UV.U", "UV.V"}, uv},
                   {{"IndexOB.X"}, id},
                   {{"burnish_weight.X"}, weight}};
    part.data = cut, part.display = {0, 0, size, size};
    return part;
}

class Antialias : public testing::Test {
protected:
    Antialias() {
        AovFrame picture;
        picture.data_window = picture.display_window = {0, 0, 64, 32};
        const Image sky = scenes::stress_light(3, 32, 6);
        write_exr(scratch.file("sky.exr"), picture, {{{"R", "G", "B"}, &sky}}, PixelType::float32);
        job.environment = scratch.file("sky.exr"), job.material = "chrome";
        job.camera = R"({"position": [0, 0, 6]})";
        job.estimator.samples = 4, job.output.pixel_type = PixelType::float32;
        write_inputs(4, {}, "zip");
    }

    void write_inputs(int factor, const Window& data, const std::string& compression) {
        job.aovs = write_synthetic(scratch.file("beauty.exr"), {picture_part(compression)});
        job.fine_aovs = write_synthetic(scratch.file("fine.exr"), {surfaces_part(factor, data)});
    }

    Report run_to(const std::string& name, const FlowSettings& flow) {
        job.output.file = scratch.file(name);
        return run(job, {}, flow);
    }

    /// Bands of one row, of four and of all give the same file, which is returned, and the same report.
    std::string expect_bands_do_not_show() {
        job.output.diagnostics = true;
        const auto comparable = [](const Report& report) {
            nlohmann::json json = report_to_json(report.frames.at(0));
            json.erase("seconds"), json.erase("output");
            return json;
        };
        const auto whole = comparable(run_to("whole.exr", {}));
        EXPECT_GT(whole["pixels"]["valid"], 1000);
        for (const size_t rows : {1, 4, 16}) {
            const Report report = run_to("bands.exr", {rows * kSize * 16, 2});
            EXPECT_EQ(comparable(report), whole) << rows;
            EXPECT_TRUE(bytes_of(job.output.file) == bytes_of(scratch.file("whole.exr"))) << rows;
        }
        return bytes_of(job.output.file);
    }

    Scratch scratch;
    Job job;
};

}  // namespace

TEST_F(Antialias, BandsDoNotShowUnderAWideFilter) {
    job.antialias.filter = {FilterKind::blackman_harris, 3};
    job.per_pixel.weight = true;
    expect_bands_do_not_show();
}

TEST_F(Antialias, BandsDoNotShowWhereShadingIsSparse) {
    job.density.density = ShadingDensity::sparse;
    LobeParameters brushed;
    brushed.mx = 0.5f, brushed.my = 0.3f;
    job.materials["brushed"] = {"brushed", Color3f(0, 0, 0), {brushed}};
    job.material = "brushed";
    job.antialias.filter = {FilterKind::gaussian, 2};
    const std::string sparse = expect_bands_do_not_show();
    job.density.density = ShadingDensity::dense;
    run_to("dense.exr", {});
    EXPECT_NE(bytes_of(job.output.file), sparse);
}

TEST_F(Antialias, BandsDoNotShowWhereTangentsNeedNeighbours) {
    LobeParameters brushed;
    brushed.mx = 0.3f, brushed.my = 0.05f;
    job.materials["brushed"] = {"brushed", Color3f(0, 0, 0), {brushed}};
    job.material = "brushed";
    job.antialias.filter = {FilterKind::gaussian, 2};
    expect_bands_do_not_show();
}

TEST_F(Antialias, BandsDoNotShowInDifferencesOverRowsWithoutSamples) {
    write_inputs(4, {40, 60, 100, 90}, "dwab");
    job.composite.mode = CompositeMode::difference;
    job.assign = {{"gold", 2, {}, {}}};
    job.old_materials = {{"chrome", "rubber"}, {"gold", "chrome"}};
    job.antialias.filter = {FilterKind::triangle, 2};
    expect_bands_do_not_show();
}

TEST_F(Antialias, OneSampleAPixelUnderABoxIsTheFrameItself) {
    write_inputs(1, {}, "zip");
    job.antialias.filter = {FilterKind::box, 1};
    run_to("fine.out.exr", {});
    SyntheticPart both = picture_part("zip");
    for (SyntheticLayer& layer : surfaces_part(1, {}).layers) both.layers.push_back(std::move(layer));
    job.aovs = write_synthetic(scratch.file("both.exr"), {both});
    job.fine_aovs.clear();
    run_to("plain.out.exr", {});
    EXPECT_EQ(read_layer(scratch.file("fine.out.exr"), kSpec).data, read_layer(scratch.file("plain.out.exr"), kSpec).data);
}

TEST_F(Antialias, ReplaceTakesOutAllThatTheSurfaceShowsAtItsEdge) {
    job.composite.mode = CompositeMode::replace, job.composite.gain = 0;
    run_to("out.exr", {});
    const Image beauty = read_layer(job.output.file, {"R"});
    EXPECT_FLOAT_EQ(beauty.at(kSize / 2, kSize / 2)[0], 0.5f - 0.125f);
    EXPECT_FLOAT_EQ(beauty.at(0, 0)[0], 0.5f) << "no surface there";
    const int on_edge =
        static_cast<int>(kSize * (0.5 - 0.5 / std::sqrt(2.0)));  // the outline crosses this pixel of the diagonal
    EXPECT_FLOAT_EQ(beauty.at(on_edge, on_edge)[0], 0.5f - 0.125f);
}

TEST_F(Antialias, EdgesMayTakeTheFramesAlpha) {
    job.antialias.coverage = EdgeCoverage::alpha;
    run_to("alpha.exr", {});
    const Image half = read_layer(job.output.file, kSpec);
    job.antialias.coverage = EdgeCoverage::samples;
    run_to("samples.exr", {});
    const Image full = read_layer(job.output.file, kSpec);
    EXPECT_FLOAT_EQ(half.at(kSize / 2, kSize / 2)[0], 0.5f * full.at(kSize / 2, kSize / 2)[0]) << "its alpha is one half";
}
