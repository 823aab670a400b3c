#include <burnish/shading/table_shading.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/shading/table_shading.cpp"
#include <hwy/foreach_target.h>

#include <burnish/shading/pixel_block_simd.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

HWY_INLINE V3 pixel_vector(const PixelBlock::Planes& planes, size_t pixel) {
    return {constant(planes[0][pixel]), constant(planes[1][pixel]), constant(planes[2][pixel])};
}

/// Taps of several pixels, one after the other, before their texels are known; their weights are in the queue already.
struct PlacedTaps {
    HWY_ALIGN float x[TapQueue::kRoom] = {}, y[TapQueue::kRoom] = {}, z[TapQueue::kRoom] = {}, level[TapQueue::kRoom] = {};
};

/// A vector of taps between the nodes about a pixel's view.
struct TableTaps {
    VF field[TapTable::kFields];

    HWY_INLINE TableTaps(const TapTable& table, const PixelBlock& block, size_t pixel, size_t tap) {
        const Lanes d;
        for (VF& f : field) f = hn::Zero(d);
        for (int c = 0; c < block.corners; ++c) {
            const float* node = table.data() + block.corner[c][pixel] + tap;
            const VF weight = constant(block.corner_weight[c][pixel]);
            for (int f = 0; f < TapTable::kFields; ++f)
                field[f] = hn::MulAdd(weight, hn::LoadU(d, node + f * table.padded_taps()), field[f]);
        }
    }
};

/// As visible_share in tap.h.
HWY_INLINE VF visible_shares(VF above_n, VF above_ng, VF edge) {
    const VF zero = constant(0.0f), one = constant(1.0f), half_edge = hn::Mul(constant(0.5f), edge);
    const auto clamped = [&](VF x) { return hn::Min(hn::Max(x, zero), one); };
    const auto share = [&](VF x) { return clamped(hn::MulAdd(x, half_edge, constant(0.5f))); };
    const VF seen = hn::IfThenElse(hn::Lt(edge, constant(kHardEdge / 2)), share(above_n), one);
    return clamped(hn::Sub(one, hn::Div(hn::Sub(seen, share(above_ng)), hn::Max(seen, constant(kLeastShare)))));
}

/// Stores a vector of taps from entry `at` on, without those of no weight, and returns where they end. `count` of the
/// vector's taps are in use.
HWY_INLINE size_t store_taps(const V3& wi, VF level, const V3& weight, size_t count, size_t at, PlacedTaps& taps,
                             TapQueue& queue) {
    const Lanes d;
    const auto store = [&](const V3& w, VF l, const V3& rgb) {
        hn::StoreU(w.x, d, taps.x + at), hn::StoreU(w.y, d, taps.y + at), hn::StoreU(w.z, d, taps.z + at);
        hn::StoreU(l, d, taps.level + at);
        const VF bright = dot(rgb, {constant(0.2126f), constant(0.7152f), constant(0.0722f)});  // of the stack's fourth channel
        hn::StoreInterleaved4(rgb.x, rgb.y, rgb.z, bright, d, queue.weight[at]);
    };
    const auto weighs = hn::Ne(hn::Or(hn::Or(weight.x, weight.y), weight.z), hn::Zero(d));
    const size_t kept = hn::CountTrue(d, weighs);
    const auto packed = [&](const V3& v) -> V3 {
        return {hn::Compress(v.x, weighs), hn::Compress(v.y, weighs), hn::Compress(v.z, weighs)};
    };
    if (kept == count)
        store(wi, level, weight);
    else if (kept > 0)
        store(packed(wi), hn::Compress(level, weighs), packed(weight));
    return at + kept;
}

/// Places taps [first, first + count) of a pixel at entries `at` and on, in light axes; returns where they end.
HWY_INLINE size_t place_taps(const TableShading& shading, const PixelBlock& block, size_t pixel, size_t first, size_t count,
                             size_t at, PlacedTaps& taps, TapQueue& queue) {
    const Lanes d;
    const V3 t = pixel_vector(block.t, pixel), b = pixel_vector(block.b, pixel), n = pixel_vector(block.n, pixel);
    const V3 wo = pixel_vector(block.wo, pixel), ng = pixel_vector(block.ng, pixel);
    const V3 wo_local = pixel_vector(block.wo_local, pixel);
    for (size_t tap = first; tap < first + count; tap += hn::Lanes(d)) {
        const TableTaps found(shading.table, block, pixel, tap);
        const V3 h{found.field[TapTable::h_x], found.field[TapTable::h_y], found.field[TapTable::h_z]};
        const VF wo_h = dot(wo_local, h);
        const V3 wi = (t * h.x + b * h.y + n * h.z) * hn::Add(wo_h, wo_h) - wo * dot(h, h);
        const VF level = found.field[TapTable::level];
        const V3 weight{found.field[TapTable::weight_r], found.field[TapTable::weight_g], found.field[TapTable::weight_b]};
        at = store_taps(wi, level, weight * visible_shares(dot(n, wi), dot(ng, wi), found.field[TapTable::edge]),
                        std::min(hn::Lanes(d), first + count - tap), at, taps, queue);
    }
    return at;
}

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
    for (size_t p = begin; p < end; ++p) ends[p] = at = place_taps(shading, block, p, first, count, at, taps, queue);
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
            out.overlay[begin + i] += sums.light[i] * scale;
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
