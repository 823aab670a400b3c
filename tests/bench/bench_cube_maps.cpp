// Cube maps with proxies: rays looked up per second under each proxy beside the infinite one, and by a hundred maps beside one; the
// time to load a map of 6 x 256 x 256 texels and the bytes that it holds.
#include "core/light/painted_room.h"

#include <burnish/light/cube_map/cube_map_light.h>
#include <burnish/light/filter/gaussian_stack.h>

#include <benchmark/benchmark.h>

#include <fstream>

using namespace burnish_test;

namespace {

const Vec3f kCentre(0.5f, 0.2f, -0.7f);
constexpr int kSize = 256;
constexpr size_t kBatch = 1024;

Proxy proxy_of(const PaintedRoom& room, ProxyKind kind) {
    switch (kind) {
        case ProxyKind::planes: return BoundingPlanes(std::vector{room.planes()[2], room.planes()[3]}, kCentre);
        case ProxyKind::box: return BoundingPlanes(room.box(), kCentre);
        case ProxyKind::depth:
            return DepthImpostor(
                std::make_shared<DistanceMap>(room.distances(kCentre, kSize), EnvironmentSettings(), DistanceKind::ray),
                kCentre);
        case ProxyKind::mesh: return ProxyMesh(room.scene(), kCentre);
        case ProxyKind::infinite: break;
    }
    return InfiniteProxy();
}

CubeMapLight light_of(const PaintedRoom& room, ProxyKind kind) {
    return {Environment::from_picture(room.picture(kCentre, kSize), {.suns = Suns::keep}, "room"), std::nullopt, kCentre,
            proxy_of(room, kind)};
}

/// What a patch of an object asks: places and directions that change slowly.
std::vector<LightRay> patch(const PaintedRoom& room, Directions& random) {
    const Vec3f p = room.inside(random, 0.5f), d = random.next();
    std::vector<LightRay> rays;
    for (size_t i = 0; i < kBatch; ++i) {
        const Vec3f aside(static_cast<float>(i % 32) / 32, static_cast<float>(i) / kBatch, 0.2f * random.uniform());
        const Vec3f turned = (d + aside * 0.5f).normalized();
        rays.push_back({p + aside * 0.1f, turned, turned, 0.05f + 0.1f * random.uniform()});
    }
    return rays;
}

/// Argument: ProxyKind. A standing block makes the depth impostor work.
void proxy_lookup(benchmark::State& state) {
    PaintedRoom room;
    room.block = standing_block();
    const CubeMapLight light = light_of(room, static_cast<ProxyKind>(state.range(0)));
    Directions random;
    std::vector<std::vector<LightRay>> patches;
    for (int i = 0; i < 64; ++i) patches.push_back(patch(room, random));
    std::vector<Incident> found(kBatch);
    for (auto _ : state)
        for (const auto& rays : patches) light.lookup(rays, found), benchmark::DoNotOptimize(found.data());
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * patches.size() * kBatch));
}

/// Argument: how many maps take turns, a patch each.
void many_maps(benchmark::State& state) {
    const PaintedRoom room;
    std::vector<CubeMapLight> lights;
    for (int i = 0; i < state.range(0); ++i) lights.push_back(light_of(room, ProxyKind::box));
    Directions random;
    std::vector<std::vector<LightRay>> patches;
    for (int i = 0; i < 200; ++i) patches.push_back(patch(room, random));
    std::vector<Incident> found(kBatch);
    for (const CubeMapLight& light : lights) light.lookup(patches[0], found);
    for (auto _ : state)
        for (size_t i = 0; i < patches.size(); ++i)
            lights[i % lights.size()].lookup(patches[i], found), benchmark::DoNotOptimize(found.data());
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * patches.size() * kBatch));
}

double resident_bytes() {
    std::ifstream statm("/proc/self/statm");
    double size = 0, resident = 0;
    statm >> size >> resident;
    return 4096 * resident;
}

/// One map with its stack, from a picture in memory.
void load_map(benchmark::State& state) {
    const PaintedRoom room;
    const EnvironmentPicture picture = room.picture(kCentre, kSize);
    std::vector<CubeMapLight> kept;
    const double before = resident_bytes();
    for (auto _ : state) {
        kept.emplace_back(Environment::from_picture(picture, {.suns = Suns::keep}, "room"), std::nullopt, kCentre,
                          BoundingPlanes(room.box(), kCentre));
        kept.back().picture().gaussian_stack().stack();
    }
    state.counters["bytes"] = (resident_bytes() - before) / static_cast<double>(kept.size());
}

}  // namespace

BENCHMARK(proxy_lookup)->ArgName("proxy")->DenseRange(0, 4);
BENCHMARK(many_maps)->ArgName("maps")->Arg(1)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(load_map)->Iterations(8)->Unit(benchmark::kMillisecond)->UseRealTime();
