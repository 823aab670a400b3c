// The limit of this machine: the bare lookup kernel, nothing else, over lobes of eight directions. What whole estimators
// reach is to be read against it. Half-float texels are tried here as well.
#include <burnish/light/filter/cube_pyramid.h>
#include <burnish/light/filter/cube_resample.h>

#include <Imath/half.h>
#include <benchmark/benchmark.h>

#include <random>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench_limit.cpp"
#include <hwy/foreach_target.h>

#include <burnish/light/filter/stack_lookup_simd.h>

#ifndef BURNISH_BENCH_LIMIT
#define BURNISH_BENCH_LIMIT
struct LobeDirections {
    std::vector<float> x, y, z;
};
#endif

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

#if HWY_MAX_BYTES >= 32
/// `queued_sum` over half-float texels.
HWY_INLINE void queued_sum_half(const hwy::float16_t* rgba, const TapQueue& queue, size_t first, size_t count, float* sums) {
    const hn::FixedTag<float, 8> pair;
    const hn::FixedTag<hwy::float16_t, 8> half;
    const auto texels = [&](int32_t offset) {
        return hn::PromoteTo(pair, hn::LoadU(half, rgba + 4 * static_cast<size_t>(offset)));
    };
    auto sum = hn::Zero(pair);
    for_each_pair(texels, queue, first, count,
                  [&](size_t i, auto both) { sum = hn::MulAdd(both, hn::LoadDup128(pair, queue.weight[i]), sum); });
    store_sum(sum, sums);
}
#endif

/// Sums of eight lookups each; `half` where not null, else the stack itself.
float bare_lookups(const CubeStack& stack, [[maybe_unused]] const hwy::float16_t* half, float level,
                   const LobeDirections& dirs) {
    const Lanes d;
    TapQueue queue;
    std::fill_n(&queue.weight[0][0], 4 * TapQueue::kCapacity, 1.0f);
    float total = 0, rgba[4];
    for (size_t first = 0; first < dirs.x.size(); first += TapQueue::kCapacity) {
        for (size_t i = 0; i < TapQueue::kCapacity; i += hn::Lanes(d))
            queue_taps(stack.layout(), CubePyramid::kDistortion,
                       {hn::LoadU(d, &dirs.x[first + i]), hn::LoadU(d, &dirs.y[first + i]), hn::LoadU(d, &dirs.z[first + i])},
                       hn::Set(d, level), i, queue);
        for (size_t i = 0; i < TapQueue::kCapacity; i += 8) {
#if HWY_MAX_BYTES >= 32
            if (half)
                queued_sum_half(half, queue, i, 8, rgba);
            else
#endif
                queued_sum(stack.layout(), queue, i, 8, rgba);
            total += rgba[0];
        }
    }
    return total;
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {
namespace {

HWY_EXPORT(bare_lookups);

Image noise_latlong(int width) {
    std::mt19937 random(1);
    Image image(width, width / 2, 3);
    for (float& value : image.data) value = static_cast<float>(random() >> 8) * 0x1p-24f;
    return image;
}

/// Lobes of eight directions, each as wide as the footprints of its samples ask at this level of a 512^2 cube: as 128 x 128
/// neighbouring pixels of a frame see them, their mirror directions 1/500 radian apart; or directions anywhere on the sphere.
LobeDirections directions(bool coherent, float level) {
    std::mt19937 random(2);
    const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
    const float radius = 1.5f * std::exp2(level) * 2 / 512;
    LobeDirections all;
    for (int i = 0; i < 8 * 128 * 128; ++i) {
        const float turn = 2 * kPi * static_cast<float>(i % 8) / 8;
        const float x = static_cast<float>(i / 8 % 128) / 500, y = static_cast<float>(i / 8 / 128) / 500;
        Vec3f d(1, 0.1f + x + radius * std::cos(turn), 0.2f + y + radius * std::sin(turn));
        if (!coherent) {
            const float z = 1 - 2 * uniform(), phi = 2 * kPi * uniform(), r = std::sqrt(std::max(0.0f, 1 - z * z));
            d = Vec3f(r * std::cos(phi), r * std::sin(phi), z);
        }
        all.x.push_back(d.x), all.y.push_back(d.y), all.z.push_back(d.z);
    }
    return all;
}

/// Arguments: half-float texels, coherent, 10 * level. Faces of 512^2.
void lookup_limit(benchmark::State& state) {
    static const CubePyramid pyramid(latlong_to_cube(noise_latlong(2048), 512), PyramidKernel::box2);
    const CubeStack& stack = pyramid.stack();
    const float level = static_cast<float>(state.range(2)) / 10;
    std::vector<hwy::float16_t> half;
    if (state.range(0)) {
        size_t texels = 0;
        for (int k = 0; k < stack.level_count(); ++k) texels += CubeLevel::float_count(stack[k].size());
        for (size_t i = 0; i < texels; ++i) half.push_back({Imath::half(stack.layout().rgba[i]).bits()});
    }
    const LobeDirections dirs = directions(state.range(1) != 0, level);
    for (auto _ : state)
        benchmark::DoNotOptimize(HWY_DYNAMIC_DISPATCH(bare_lookups)(stack, half.empty() ? nullptr : half.data(), level, dirs));
    state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(dirs.x.size()));
}

}  // namespace
}  // namespace burnish

BENCHMARK(burnish::lookup_limit)
    ->ArgNames({"half", "coherent", "level_x10"})
    ->ArgsProduct({{0, 1}, {1}, {3, 15, 32}})
    ->Args({0, 0, 15})
    ->Args({1, 0, 15});
#endif
