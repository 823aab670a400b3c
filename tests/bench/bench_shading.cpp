// Dense shading of a fully covered 1920 x 1080 frame: time per frame and lookups per second per core.
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/composite/composite.h>
#include <burnish/shading/dense.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

using namespace burnish;

namespace {

/// Arguments: lookups per pixel, threads. Model and estimator by template, so that the names of the benchmarks say what ran; maps of
/// `factored` by normal and reflection.
template <ModelId model, EstimatorKind kind>
void shade_1080p(benchmark::State& state) {
    const ThreadLimit limit(static_cast<int>(state.range(1)));
    const AovFrame frame = scenes::covered_frame(1920, 1080);
    const Assignment assignment = scenes::whole_frame(frame);
    const Environment light = Environment::from_image(scenes::stress_light(1, 512), {}, "stress");
    LobeParameters lobe;
    lobe.model = model, lobe.mx = lobe.my = 0.1f;
    if (model == ModelId::kurt) lobe.extra = {0.4f};
    EstimatorSettings settings;
    settings.kind = kind, settings.parametrization = "nr";
    settings.samples = static_cast<int>(state.range(0));
    const std::vector<MaterialShader> shaders{MaterialShader({"bench", Color3f(0, 0, 0), {lobe}}, light, settings)};
    double lookups = 0;
    for (auto _ : state) {
        const Surfaces surfaces(frame, assignment, {});
        const ShadedFrame shaded = shade_dense(surfaces, assignment, shaders, {});
        lookups += shaded.lookups;
        benchmark::DoNotOptimize(shaded.overlay.data.data());
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["lookups/s/core"] = benchmark::Counter(lookups, benchmark::Counter::kIsRate);  // of processor time
    state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024;
}

/// What a frame costs between its files: surfaces, `fitted` shading and compositing. Arguments: lookups per pixel, threads.
void compute_1080p(benchmark::State& state) {
    const ThreadLimit limit(static_cast<int>(state.range(1)));
    AovFrame frame = scenes::covered_frame(1920, 1080);
    frame.layers[Role::beauty] = Image(1920, 1080, 3, 0.5f);
    const Assignment assignment = scenes::whole_frame(frame);
    const Environment light = Environment::from_image(scenes::stress_light(1, 512), {}, "stress");
    LobeParameters lobe;
    lobe.model = ModelId::ggx, lobe.mx = lobe.my = 0.1f;
    EstimatorSettings settings;
    settings.kind = EstimatorKind::fitted, settings.samples = static_cast<int>(state.range(0));
    const std::vector<MaterialShader> shaders{MaterialShader({"bench", Color3f(0, 0, 0), {lobe}}, light, settings)};
    for (auto _ : state) {
        const Surfaces surfaces(frame, assignment, {});
        ShadedFrame shaded = shade_dense(surfaces, assignment, shaders, {});
        benchmark::DoNotOptimize(
            composite(frame, {assignment.coverage, {}, {}}, std::move(shaded.overlay), nullptr, {}).beauty.data.data());
    }
}

/// Arguments: mx and my in percent, roughness from a layer, estimator, lookups. What a lobe costs before its first pixel.
void make_shader(benchmark::State& state) {
    const ThreadLimit limit(2);
    const Environment light = Environment::from_image(scenes::constant_light(1), {}, "constant");
    LobeParameters lobe;
    lobe.model = ModelId::ggx, lobe.mx = 0.01f * state.range(0), lobe.my = 0.01f * state.range(1);
    lobe.per_pixel.roughness = state.range(2) != 0;
    EstimatorSettings settings;
    settings.kind = static_cast<EstimatorKind>(state.range(3)), settings.samples = static_cast<int>(state.range(4));
    for (auto _ : state) benchmark::DoNotOptimize(MaterialShader({"bench", Color3f(0, 0, 0), {lobe}}, light, settings));
}

constexpr EstimatorKind fitted = EstimatorKind::fitted, regular = EstimatorKind::regular,
                        filtered_importance = EstimatorKind::filtered_importance, split_sum = EstimatorKind::split_sum,
                        factored = EstimatorKind::factored;

}  // namespace

BENCHMARK(shade_1080p<ModelId::ggx, factored>)
    ->ArgsProduct({{1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK(shade_1080p<ModelId::ggx, split_sum>)
    ->ArgsProduct({{1}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK(shade_1080p<ModelId::ggx, fitted>)
    ->ArgsProduct({{1, 2, 4, 6}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK(shade_1080p<ModelId::kurt, regular>)
    ->ArgsProduct({{4, 8, 16}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK(shade_1080p<ModelId::beckmann, regular>)->Args({16, 2})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(shade_1080p<ModelId::ggx, regular>)->Args({16, 2})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(shade_1080p<ModelId::ggx, filtered_importance>)
    ->Args({16, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK(compute_1080p)->ArgsProduct({{2, 4}, {1, 2}})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(make_shader)
    ->ArgNames({"mx", "my", "layer", "estimator", "lookups"})
    ->ArgsProduct({{10, 30}, {10, 6}, {0, 1}, {static_cast<int>(regular)}, {16}})
    ->ArgsProduct({{10, 30}, {10, 6}, {0, 1}, {static_cast<int>(fitted)}, {6}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
