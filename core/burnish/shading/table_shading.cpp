#include <burnish/shading/table_shading.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/shading/table_shading.cpp"
#include <hwy/foreach_target.h>

#include <burnish/shading/tap_place_simd.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

/// What multiplies pixel i of a lobe apart from its taps, beyond the lobe's own tint and strength.
HWY_INLINE Color3f pixel_scale(const LobeParameters& lobe, const SurfaceBatch& batch, size_t i) {
    Color3f scale(1, 1, 1);
    if (lobe.per_pixel.tint && !batch.tint.x.empty()) scale *= Color3f(batch.tint[i]);
    if (lobe.per_pixel.weight && !batch.weight.empty()) scale *= batch.weight[i];
    return scale;
}

/// What a block of pixels comes to.
struct BlockSums {
    bool of_weights;  // whether `weight` is asked for
    Color3f light[PixelBlock::kPixels];
    float fourth[PixelBlock::kPixels], weight[PixelBlock::kPixels];
    size_t lookups[PixelBlock::kPixels];
};

/// Adds taps [first, first + count) of pixels [begin, end), all that the queue holds at once.
void add_taps(const TableShading& shading, const PixelBlock& block, size_t begin, size_t end, size_t first, size_t count,
              PlacedTaps& taps, TapQueue& queue, BlockSums& sums) {
    const Lanes d;
    size_t ends[PixelBlock::kPixels], at = 0;
    for (size_t p = begin; p < end; ++p) ends[p] = at = place_taps(shading, block, p, first, count, at, taps, queue.weight);
    for (size_t i = 0; i < at; i += hn::Lanes(d))
        queue_taps(shading.stack.layout(), shading.distortion,
                   {hn::Load(d, taps.x + i), hn::Load(d, taps.y + i), hn::Load(d, taps.z + i)}, hn::Load(d, taps.level + i), i,
                   queue);
    for (size_t p = begin, i = 0; p < end; i = ends[p++]) {
        float rgba[4];
        queued_sum(shading.stack.layout(), queue, i, ends[p] - i, rgba);
        sums.light[p] += Color3f(rgba[0], rgba[1], rgba[2]), sums.fourth[p] += rgba[3];
        for (size_t tap = i; sums.of_weights && tap < ends[p]; ++tap) sums.weight[p] += queue.weight[tap][3];
        sums.lookups[p] += ends[p] - i;
    }
}

/// Shades `count` prepared pixels, as many at a time as the queue holds; a pixel with more taps than that takes several rounds.
void shade_block(const TableShading& shading, const PixelBlock& block, size_t count, PlacedTaps& taps, TapQueue& queue,
                 BlockSums& sums) {
    const size_t all = static_cast<size_t>(shading.table.tap_count());
    const size_t at_once = std::max<size_t>(TapQueue::kCapacity / all, 1);
    const bool of_weights = sums.of_weights;
    sums = {};
    sums.of_weights = of_weights;
    for (size_t begin = 0; begin < count; begin += at_once)
        for (size_t tap = 0; tap < all; tap += TapQueue::kCapacity)
            add_taps(shading, block, begin, std::min(begin + at_once, count), tap, std::min(all - tap, TapQueue::kCapacity),
                     taps, queue, sums);
}

void shade_batch(const TableShading& shading, const SurfaceBatch& batch, const TableSums& out) {
    PixelBlock block;
    PlacedTaps taps;
    TapQueue queue;
    BlockSums sums{};
    sums.of_weights = !out.weight.empty();
    const Color3f gain = shading.lobe.tint * shading.lobe.strength * shading.gain;
    for (size_t begin = 0; begin < batch.size(); begin += PixelBlock::kPixels) {
        const size_t count = std::min(PixelBlock::kPixels, batch.size() - begin);
        for (size_t i = 0; i < count; i += hn::Lanes(Lanes())) prepare_pixels(shading, batch, begin + i, i, block);
        shade_block(shading, block, count, taps, queue, sums);
        for (size_t i = 0; i < count; ++i) {
            const Color3f scale = gain * pixel_scale(shading.lobe, batch, begin + i);
            out.overlay[begin + i] += reflected(sums.light[i]) * scale;
            out.samples[begin + i] += static_cast<float>(sums.lookups[i]);
            if (!out.fourth.empty()) out.fourth[begin + i] += sums.fourth[i] * luminance(scale);
            if (!out.weight.empty()) out.weight[begin + i] += sums.weight[i] * luminance(scale);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(shade_batch);

void add_table_shading(const TableShading& shading, const SurfaceBatch& batch, const TableSums& out) {
    HWY_DYNAMIC_DISPATCH(shade_batch)(shading, batch, out);
}

}  // namespace burnish
#endif
