// Building what predicts bandwidths, on one thread: the light's at its largest size, one lobe's.
#include "core/light/light_pictures.h"

#include <burnish/base/parallel.h>
#include <burnish/frequency/light_bandwidth.h>
#include <burnish/frequency/lobe_bandwidth.h>

#include <benchmark/benchmark.h>

namespace {

using namespace burnish;

void BM_light_bandwidth(benchmark::State& state) {
    const ThreadLimit one(1);
    const auto faces = burnish_test::painted_faces(static_cast<int>(state.range(0)), [](const Vec3f& d) {
        return Color3f(d.x > 0.2f ? 4.0f : 1 + std::sin(30 * d.x) * std::sin(50 * d.y));
    });
    for (auto _ : state) benchmark::DoNotOptimize(LightBandwidth(faces, {}));
}
BENCHMARK(BM_light_bandwidth)->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond);

void BM_lobe_bandwidth(benchmark::State& state) {
    const ThreadLimit one(1);
    LobeParameters lobe;
    lobe.model = ModelId::ggx, lobe.mx = 0.1f, lobe.my = state.range(0) == 1 ? 0.1f : 0.03f;
    for (auto _ : state) benchmark::DoNotOptimize(LobeBandwidth(lobe));
}
BENCHMARK(BM_lobe_bandwidth)->ArgName("views_of_phi")->Arg(1)->Arg(16)->Unit(benchmark::kMillisecond);

void BM_light_bandwidth_at(benchmark::State& state) {
    const LightBandwidth light(
        burnish_test::painted_faces(256, [](const Vec3f& d) { return Color3f(d.x > 0.2f ? 4.0f : 1.0f); }), {});
    burnish_test::Directions random;
    std::vector<Vec3f> directions(4096);
    for (Vec3f& d : directions) d = random.next();
    for (auto _ : state) {
        for (const Vec3f& d : directions) benchmark::DoNotOptimize(light.at(d, 0.05f));
    }
    state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(directions.size()));
}
BENCHMARK(BM_light_bandwidth_at);

}  // namespace
