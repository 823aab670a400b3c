// What it costs that lights are asked ray by ray: a sphere of 1920 x 1080 under one environment, by the kernel made for distant light
// and through a chain of lights; and lookups of a chain by themselves.
#include "core/scenes.h"

#include <burnish/base/parallel.h>
#include <burnish/shading/dense.h>
#include <burnish/shading/local_shading.h>

#include <benchmark/benchmark.h>

using namespace burnish;

namespace {

std::shared_ptr<const Environment> stress() {
    return std::make_shared<const Environment>(Environment::from_image(scenes::stress_light(1, 512), {}, "stress"));
}

LightChain chain_of(const std::shared_ptr<const Environment>& light) {
    return LightChain({{std::make_shared<const Light>(EnvironmentLight(light)), true}});
}

Material material(float m) { return {"bench", Color3f(0, 0, 0), {scenes::lobe_of(ModelId::ggx, m, m)}}; }

/// Arguments: lookups per pixel, 100 m.
template <bool is_local>
void shade_sphere(benchmark::State& state) {
    const ThreadLimit one(1);
    const AovFrame frame = scenes::sphere_in_frame(1920, 1080, 520);
    const Assignment assignment = scenes::whole_frame(frame);
    const std::shared_ptr<const Environment> light = stress();
    EstimatorSettings settings;
    settings.samples = static_cast<int>(state.range(0));
    const Material worn = material(0.01f * static_cast<float>(state.range(1)));
    const std::vector<MaterialShader> shaders{
        is_local ? MaterialShader(std::make_shared<const MaterialTaps>(worn, settings), chain_of(light))
                 : MaterialShader(worn, *light, settings)};
    const Surfaces surfaces(frame, assignment, {});
    double lookups = 0;
    for (auto _ : state) {
        const ShadedFrame shaded = shade_dense(surfaces, assignment, shaders, {});
        lookups += shaded.lookups;
        benchmark::DoNotOptimize(shaded.overlay.data.data());
    }
    state.counters["lookups/s"] = benchmark::Counter(lookups, benchmark::Counter::kIsRate);
}

void distant_sphere(benchmark::State& state) { shade_sphere<false>(state); }
void local_sphere(benchmark::State& state) { shade_sphere<true>(state); }

}  // namespace

BENCHMARK(distant_sphere)->ArgsProduct({{4, 6}, {3, 10, 40}})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK(local_sphere)->ArgsProduct({{4, 6}, {3, 10, 40}})->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
