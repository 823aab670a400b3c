#include <burnish/light/filter/stack_lookup.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/light/filter/stack_lookup.cpp"
#include <hwy/foreach_target.h>

#include <burnish/light/filter/stack_lookup_simd.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

/// Queues taps [0, count) at the start of the queue; entries up to the next whole vector are filled with the last.
void queue_stack_taps(const CubeStack& stack, float distortion, const StackTap* taps, size_t count, TapQueue& queue) {
    const Lanes d;
    HWY_ALIGN float x[8], y[8], z[8], level[8];
    for (size_t first = 0; first < count; first += hn::Lanes(d)) {
        for (size_t lane = 0; lane < hn::Lanes(d); ++lane) {
            const StackTap& tap = taps[std::min(first + lane, count - 1)];
            x[lane] = tap.d.x, y[lane] = tap.d.y, z[lane] = tap.d.z, level[lane] = tap.level;
            std::copy_n(&tap.weight.x, 3, queue.weight[first + lane]);
            queue.weight[first + lane][3] = 0;
        }
        queue_taps(stack.layout(), distortion, {hn::Load(d, x), hn::Load(d, y), hn::Load(d, z)}, hn::Load(d, level), first,
                   queue);
    }
}

static_assert(kMostTapsPerSum == TapQueue::kCapacity);

void add_up(const CubeStack& stack, float distortion, std::span<const StackTap> taps, size_t per_sum, std::span<Color3f> sums) {
    TapQueue queue;
    const size_t sums_at_once = TapQueue::kCapacity / per_sum;
    for (size_t j = 0; j < sums.size(); j += sums_at_once) {
        const size_t count = std::min(sums_at_once, sums.size() - j);
        queue_stack_taps(stack, distortion, &taps[j * per_sum], count * per_sum, queue);
        for (size_t i = 0; i < count; ++i) {
            float rgba[4];
            queued_sum(stack.layout(), queue, i * per_sum, per_sum, rgba);
            sums[j + i] = {rgba[0], rgba[1], rgba[2]};
        }
    }
}

void look_up_each(const CubeStack& stack, std::span<const StackPlace> places, const std::array<float, 4>& gain,
                  std::span<std::array<float, 4>> rgba) {
    static_assert(sizeof(StackPlace) == 4 * sizeof(float));
    const Lanes d;
    TapQueue queue;
    for (size_t begin = 0; begin < places.size(); begin += TapQueue::kCapacity) {
        const size_t count = std::min(TapQueue::kCapacity, places.size() - begin);
        for (size_t i = 0; i < count; i += hn::Lanes(d)) {
            HWY_ALIGN StackPlace last[8] = {};
            const bool is_whole = begin + i + hn::Lanes(d) <= places.size();
            if (!is_whole) std::copy(places.begin() + static_cast<std::ptrdiff_t>(begin + i), places.end(), last);
            V3 w;
            VF level;
            hn::LoadInterleaved4(d, is_whole ? &places[begin + i].d.x : &last[0].d.x, w.x, w.y, w.z, level);
            queue_taps(stack.layout(), 0, w, level, i, queue);
        }
        queued_values(stack.layout(), queue, count, gain.data(), reinterpret_cast<float(*)[4]>(&rgba[begin]));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(add_up);
HWY_EXPORT(look_up_each);

void look_up(const CubeStack& stack, std::span<const StackPlace> places, const std::array<float, 4>& gain,
             std::span<std::array<float, 4>> rgba) {
    HWY_DYNAMIC_DISPATCH(look_up_each)(stack, places, gain, rgba);
}

void add_up_lookups(const CubeStack& stack, float distortion, std::span<const StackTap> taps, size_t per_sum,
                    std::span<Color3f> sums) {
    HWY_DYNAMIC_DISPATCH(add_up)(stack, distortion, taps, per_sum, sums);
}

}  // namespace burnish
#endif
