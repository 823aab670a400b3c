// Whole runs, file to file: a sequence against merely reading and writing its files with OpenImageIO, a frame of 40 channels
// of which few are needed, and the memory of an 8K frame.
#include "core/scenes.h"
#include "core/scratch.h"

#include <burnish/base/parallel.h>
#include <burnish/job/run.h>

#include <OpenImageIO/imageio.h>
#include <benchmark/benchmark.h>

#include <sys/resource.h>
#include <chrono>

using namespace burnish;

namespace {

constexpr int kFrames = 24, kNeeded = 11, kWritten = 7;  // channels burnish needs of a frame, and channels of its output

/// Beauty RGBA and normal as half, position and depth as float, then passes nobody needs, as half.
OIIO::ImageSpec sheet_spec(int width, int height, int channels) {
    OIIO::ImageSpec spec(width, height, 0, OIIO::TypeHalf);
    spec.channelnames = {"R", "G", "B", "A", "N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "depth.Z"};
    spec.channelformats.assign(7, OIIO::TypeHalf), spec.channelformats.resize(kNeeded, OIIO::TypeFloat);
    for (int c = kNeeded; c < channels; ++c) {
        spec.channelnames.push_back("pass" + std::to_string(c / 3) + "." + "XYZ"[c % 3]);
        spec.channelformats.push_back(OIIO::TypeHalf);
    }
    spec.nchannels = static_cast<int>(spec.channelnames.size());
    spec.attribute("compression", "zip");
    return spec;
}

/// One pixel of the gently waved sheet of scenes::covered_frame, with noise as renders have it in colour.
void sheet_pixel(const OIIO::ImageSpec& spec, int x, int y, std::mt19937& random, float* to) {
    const float px = 2 * (x + 0.5f) / spec.width - 1, py = (1 - 2 * (y + 0.5f) / spec.height) * spec.height / spec.width;
    const float z = 0.1f * std::sin(4 * px) * std::cos(5 * py), light = 0.3f + 0.2f * std::sin(7 * px);
    const Vec3f n =
        Vec3f(-0.4f * std::cos(4 * px) * std::cos(5 * py), 0.5f * std::sin(4 * px) * std::sin(5 * py), 1).normalized();
    const auto noisy = [&](float value) { return value * (1 + 0.05f * (static_cast<float>(random() >> 8) * 0x1p-24f - 0.5f)); };
    const float known[kNeeded] = {noisy(light), noisy(light), noisy(light), 1, n.x, n.y, n.z, px, py, z, 3 - z};
    for (int c = 0; c < spec.nchannels; ++c) to[c] = c < kNeeded ? known[c] : noisy(light);
}

void write_sheet(const std::string& file, int width, int height, int channels) {
    const OIIO::ImageSpec spec = sheet_spec(width, height, channels);
    constexpr int kRows = 64;
    const auto output = OIIO::ImageOutput::create("openexr");
    if (!output->open(file, spec)) throw std::runtime_error(output->geterror());
    std::mt19937 random(1);
    std::vector<float> rows(static_cast<size_t>(kRows) * width * channels);
    for (int begin = 0; begin < height; begin += kRows) {
        const int end = std::min(begin + kRows, height);
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < width; ++x)
                sheet_pixel(spec, x, y, random, &rows[(static_cast<size_t>(y - begin) * width + x) * channels]);
        output->write_scanlines(begin, end, 0, OIIO::TypeFloat, rows.data());
    }
    if (!output->close()) throw std::runtime_error(output->geterror());
}

/// A job with the cheapest shading there is, so that what is around it shows.
Job sheet_job(const Scratch& scratch) {
    const Image sky = scenes::constant_light(1);
    AovFrame frame;
    frame.data_window = frame.display_window = {0, 0, sky.width, sky.height};
    write_exr(scratch.file("sky.exr"), frame, {{{"R", "G", "B"}, &sky}}, PixelType::half);
    Job job;
    job.environment = scratch.file("sky.exr"), job.material = "chrome";
    job.camera = R"({"position": [0, 0, 3], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov_x_deg": 36.87})";
    job.estimator.samples = 4;
    return job;
}

std::string frame_name(int frame) { return "in." + std::to_string(1000 + frame) + ".exr"; }

/// Twenty-four names of one file: what is measured does not depend on what the frames show.
Job sequence_job(const Scratch& scratch, int channels) {
    write_sheet(scratch.file(frame_name(1)), 1920, 1080, channels);
    for (int frame = 2; frame <= kFrames; ++frame)
        std::filesystem::create_hard_link(scratch.file(frame_name(1)), scratch.file(frame_name(frame)));
    Job job = sheet_job(scratch);
    job.aovs = scratch.file("in.####.exr"), job.output.file = scratch.file("out.####.exr");
    return job;
}

void copy_with_oiio(const std::string& from, const std::string& to) {
    const auto input = OIIO::ImageInput::open(from);
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<float> pixels(static_cast<size_t>(spec.width) * spec.height * kNeeded);
    input->read_image(0, 0, 0, kNeeded, OIIO::TypeFloat, pixels.data());
    OIIO::ImageSpec written(spec.width, spec.height, kWritten, OIIO::TypeHalf);
    written.attribute("compression", "zip");
    const auto output = OIIO::ImageOutput::create("openexr");
    output->open(to, written);
    output->write_image(OIIO::TypeFloat, pixels.data(), kNeeded * sizeof(float));
    output->close();
}

double cpu_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Least of several runs: wall time, and time of all cores, which others on the machine disturb less.
struct Least {
    double wall = 1e9, cpu = 1e9;

    template <class Work>
    double measure(Work&& work) {
        const auto begin = std::chrono::steady_clock::now();
        const double cpu_begin = cpu_seconds();
        work();
        const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        wall = std::min(wall, elapsed), cpu = std::min(cpu, cpu_seconds() - cpu_begin);
        return elapsed;
    }
};

double stage_seconds(const Report& report, const std::string& wanted) {
    double sum = 0;
    for (const FrameReport& frame : report.frames)
        for (const auto& [stage, seconds] : frame.seconds) sum += stage == wanted ? seconds : 0;
    return sum;
}

/// Argument: channels of the input. Time is that of burnish::run; ratio is over OpenImageIO's in the same iteration.
void sequence_1080p(benchmark::State& state) {
    const Scratch scratch;
    const Job job = sequence_job(scratch, static_cast<int>(state.range(0)));
    Least ours, theirs;
    Report report;
    for (auto _ : state) {
        theirs.measure([&] {
            for (int frame = 1; frame <= kFrames; ++frame)
                copy_with_oiio(scratch.file(frame_name(frame)), scratch.file("copy.exr"));
        });
        state.SetIterationTime(ours.measure([&] { report = run(job, Progress()); }));
    }
    for (const char* stage : {"reading", "surface", "shading", "composite", "writing"})
        state.counters[std::string(stage) + "_ms"] = 1e3 * stage_seconds(report, stage) / kFrames;
    const auto frame_ms = [](double seconds) { return 1e3 * seconds / kFrames; };
    state.counters["burnish_ms"] = frame_ms(ours.wall), state.counters["oiio_ms"] = frame_ms(theirs.wall);
    state.counters["burnish_cpu_ms"] = frame_ms(ours.cpu), state.counters["oiio_cpu_ms"] = frame_ms(theirs.cpu);
    state.counters["ratio"] = ours.wall / theirs.wall, state.counters["cpu_ratio"] = ours.cpu / theirs.cpu;
}

/// Peak memory holds for a process that runs this benchmark alone.
void frame_8192x4096(benchmark::State& state) {
    const Scratch scratch;
    write_sheet(scratch.file("in.exr"), 8192, 4096, kNeeded);
    Job job = sheet_job(scratch);
    job.aovs = scratch.file("in.exr"), job.output.file = scratch.file("out.exr");
    Report report;
    for (auto _ : state) report = run(job, Progress());
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
    state.counters["shading_s"] = stage_seconds(report, "shading");
}

/// What surfaces cost before anything is shaded: classification and the batches of a fully covered 1920 x 1080 frame.
void surfaces_1080p(benchmark::State& state) {
    const AovFrame frame = scenes::covered_frame(1920, 1080);
    const Assignment assignment = scenes::whole_frame(frame);
    for (auto _ : state) {
        const Surfaces surfaces(frame, assignment, {});
        for_each_tile(1920, 1080, {}, "", [&](const Window& tile) {
            thread_local SurfaceBatch batch;
            surfaces.gather(tile, 0, batch);
            benchmark::DoNotOptimize(batch.pixel.data());
        });
    }
}

}  // namespace

BENCHMARK(sequence_1080p)->Arg(23)->Arg(40)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(2);
BENCHMARK(frame_8192x4096)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(surfaces_1080p)->Unit(benchmark::kMillisecond)->UseRealTime();
