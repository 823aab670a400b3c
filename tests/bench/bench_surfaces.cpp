// What runs over every pixel of a 1920 x 1080 frame whether it is shaded or not: by stage, and as a whole, against merely
// streaming the layers it reads and the picture it writes through memory once. Arguments: threads.
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/job/build_lights.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/run_frame.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

using namespace burnish;

namespace {

constexpr int kWidth = 1920, kHeight = 1080;

/// P, N, object index (two objects) and beauty; every pixel has a surface.
AovFrame frame_of_layers() {
    AovFrame frame = scenes::covered_frame(kWidth, kHeight);
    frame.layers[Role::beauty] = Image(kWidth, kHeight, 3, 0.5f);
    Image& ids = frame.layers[Role::object_id] = Image(kWidth, kHeight, 1, 1.0f);
    for (int y = kHeight / 4; y < kHeight / 2; ++y) std::fill_n(ids.at(kWidth / 4, y), kWidth / 2, 2.0f);
    return frame;
}

/// The whole frame wears one material, the second object another.
std::vector<AssignRule> rules() { return {{"metal", {}, {}, {}}, {"paint", 2, {}, {}}}; }

/// Materials without lobes: a look that shades in no time.
Look look_of_nothing(const std::shared_ptr<const Environment>& light) {
    Job job;
    job.assign = rules(), job.density.density = ShadingDensity::dense;
    for (const AssignRule& rule : job.assign) job.materials[rule.material] = {rule.material, Color3f(0, 0, 0), {}};
    Wardrobe wardrobe = prepare_wardrobe(job);
    Rig rig = build_rig(job, wardrobe.rules, ColorFlow(job), light, {});
    return prepare_look(job, std::move(wardrobe), std::move(rig), {});
}

/// Nanoseconds a pixel, and page faults a frame.
void count(benchmark::State& state, long faults_before) {
    using benchmark::Counter;
    constexpr double kPixels = 1e-9 * kWidth * kHeight;
    state.counters["ns/pixel"] = Counter(kPixels, Counter::kIsIterationInvariantRate | Counter::kInvert);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["faults"] = Counter(static_cast<double>(usage.ru_minflt - faults_before), Counter::kAvgIterations);
}

template <class Work>
void measure(benchmark::State& state, const Work& work) {
    const ThreadLimit limit(static_cast<int>(state.range(0)));
    work();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    for (auto _ : state) work();
    count(state, usage.ru_minflt);
}

/// The rival: each layer read once, RGB written once, to memory that is there already.
void stream_layers(benchmark::State& state) {
    const AovFrame frame = frame_of_layers();
    const Image &p = frame.layer(Role::position), &n = frame.layer(Role::normal), &beauty = frame.layer(Role::beauty);
    const Image& ids = frame.layer(Role::object_id);
    Image rgb(kWidth, kHeight, 3);
    measure(state, [&] {
        for_each_index(kHeight, [&](int y) {
            const float *a = p.at(0, y), *b = n.at(0, y), *c = beauty.at(0, y), *id = ids.at(0, y);
            float* out = rgb.at(0, y);
            for (int i = 0; i < 3 * kWidth; ++i) out[i] = a[i] + b[i] + c[i];
            for (int i = 0; i < kWidth; ++i) out[i] += id[i];
        });
        benchmark::DoNotOptimize(rgb.data.data());
    });
}

void assign(benchmark::State& state) {
    const AovFrame frame = frame_of_layers();
    measure(state, [&] { benchmark::DoNotOptimize(assign_rules(frame, rules()).rule.data()); });
}

void classify(benchmark::State& state) {
    const AovFrame frame = frame_of_layers();
    const Assignment assignment = assign_rules(frame, rules());
    measure(state, [&] {
        const Surfaces surfaces(frame, assignment, {});
        benchmark::DoNotOptimize(surfaces.counts());
    });
}

/// With tangents, or as isotropic lobes need them.
template <bool with_tangents>
void gather(benchmark::State& state) {
    const AovFrame frame = frame_of_layers();
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    measure(state, [&] {
        for_each_tile(kWidth, kHeight, {}, "", [&](const Window& tile) {
            thread_local SurfaceBatch batch;
            surfaces.gather(tile, 0, batch, {.position = false, .tangent = with_tangents});
            benchmark::DoNotOptimize(batch.pixel.data());
        });
    });
}

/// Every 32nd pixel, in batches of a tile's size: nanoseconds are per pixel of the frame.
void fill_sparse(benchmark::State& state) {
    const AovFrame frame = frame_of_layers();
    const Assignment assignment = scenes::whole_frame(frame);
    const Surfaces surfaces(frame, assignment, {});
    constexpr int kStep = 32, kBatch = kTileSize * kTileSize;
    measure(state, [&] {
        for_each_index(kWidth * kHeight / (kStep * kBatch), [&](int index) {
            thread_local SurfaceBatch batch;
            batch.clear();
            for (uint32_t i = 0; i < kBatch; ++i) batch.pixel.push_back((index * kBatch + i) * kStep);
            surfaces.fill(batch, {.position = false, .tangent = false});
            benchmark::DoNotOptimize(batch.n.x.data());
        });
    });
}

void composite_add(benchmark::State& state) {
    const AovFrame frame = frame_of_layers();
    const Cover cover{assign_rules(frame, rules()).coverage, {}, {}};
    Image overlay(kWidth, kHeight, 3, 0.25f);
    measure(state, [&] {
        Composite done = composite(frame, cover, std::move(overlay), nullptr, {});
        benchmark::DoNotOptimize(done.beauty.data.data());
        overlay = std::move(done.overlay);
    });
}

/// run_frame but for the shading itself.
void around_shading(benchmark::State& state) {
    const AovFrame frame = frame_of_layers();
    const auto light = std::make_shared<const Environment>(Environment::from_image(scenes::constant_light(1), {}, "sky"));
    const Look look = look_of_nothing(light);
    const Job job;
    measure(state, [&] {
        const FrameResult result = run_frame(job, frame, nullptr, look, nullptr, Progress());
        benchmark::DoNotOptimize(result.composite.beauty.data.data());
    });
}

}  // namespace

#define BURNISH_BENCH_PIXELS(name) \
    BENCHMARK(name)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()
BURNISH_BENCH_PIXELS(stream_layers);
BURNISH_BENCH_PIXELS(assign);
BURNISH_BENCH_PIXELS(classify);
BURNISH_BENCH_PIXELS(gather<false>);
BURNISH_BENCH_PIXELS(gather<true>);
BURNISH_BENCH_PIXELS(fill_sparse);
BURNISH_BENCH_PIXELS(composite_add);
BURNISH_BENCH_PIXELS(around_shading);
