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

/// As visible_share in tap.h.
HWY_INLINE VF visible_shares(VF above_n, VF above_ng, VF edge) {
    const VF zero = constant(0.0f), one = constant(1.0f), half_edge = hn::Mul(constant(0.5f), edge);
    const auto clamped = [&](VF x) { return hn::Min(hn::Max(x, zero), one); };
    const auto share = [&](VF x) { return clamped(hn::MulAdd(x, half_edge, constant(0.5f))); };
    const VF seen = hn::IfThenElse(hn::Lt(edge, constant(kHardEdge / 2)), share(above_n), one);
    return clamped(hn::Sub(one, hn::Div(hn::Sub(seen, share(above_ng)), hn::Max(seen, constant(kLeastShare)))));
}

/// Queues taps [first, first + count) of a pixel at entries `at` and on: interpolated between nodes, turned into light axes.
HWY_INLINE void queue_pixel(const TableShading& shading, const PixelBlock& block, size_t pixel, size_t first, size_t count,
                            size_t at, TapQueue& queue) {
    const Lanes d;
    const TapTable& table = shading.table;
    const V3 t = pixel_vector(block.t, pixel), b = pixel_vector(block.b, pixel), n = pixel_vector(block.n, pixel);
    const V3 wo = pixel_vector(block.wo, pixel), ng = pixel_vector(block.ng, pixel);
    const V3 wo_local = pixel_vector(block.wo_local, pixel);
    for (size_t tap = first; tap < first + count; tap += hn::Lanes(d), at += hn::Lanes(d)) {
        VF field[TapTable::kFields];
        for (VF& f : field) f = hn::Zero(d);
        for (int c = 0; c < block.corners; ++c) {
            const float* node = table.data() + block.corner[c][pixel] + tap;
            const VF weight = constant(block.corner_weight[c][pixel]);
            for (int f = 0; f < TapTable::kFields; ++f)
                field[f] = hn::MulAdd(weight, hn::LoadU(d, node + f * table.padded_taps()), field[f]);
        }
        const V3 h{field[TapTable::h_x], field[TapTable::h_y], field[TapTable::h_z]};
        const VF wo_h = dot(wo_local, h);
        const V3 wi = (t * h.x + b * h.y + n * h.z) * hn::Add(wo_h, wo_h) - wo * dot(h, h);
        const VF share = visible_shares(dot(n, wi), dot(ng, wi), field[TapTable::edge]);
        const auto weight = [&](TapTable::Field f) { return hn::Mul(share, field[f]); };
        hn::StoreInterleaved4(weight(TapTable::weight_r), weight(TapTable::weight_g), weight(TapTable::weight_b), hn::Zero(d),
                              d, queue.weight[at]);
        queue_taps(shading.stack.layout(), shading.distortion, wi, field[TapTable::level], at, queue);
    }
}

/// What multiplies pixel i of a lobe apart from its taps, beyond the lobe's own tint and strength.
HWY_INLINE Color3f pixel_scale(const LobeParameters& lobe, const SurfaceBatch& batch, size_t i) {
    Color3f scale(1, 1, 1);
    if (lobe.per_pixel.tint && !batch.tint.x.empty()) scale *= Color3f(batch.tint[i]);
    if (lobe.per_pixel.weight && !batch.weight.empty()) scale *= batch.weight[i];
    return scale;
}

/// Shades `count` prepared pixels, as many at a time as the queue holds; a pixel with more taps than that takes several rounds.
void shade_block(const TableShading& shading, const PixelBlock& block, size_t count, TapQueue& queue, Color3f* sums) {
    const size_t padded = static_cast<size_t>(shading.table.padded_taps()),
                 taps = static_cast<size_t>(shading.table.tap_count());
    const size_t at_once = std::max<size_t>(TapQueue::kCapacity / padded, 1);
    std::fill_n(sums, count, Color3f(0, 0, 0));
    for (size_t begin = 0; begin < count; begin += at_once) {
        const size_t end = std::min(begin + at_once, count);
        for (size_t tap = 0; tap < padded; tap += TapQueue::kCapacity) {
            const size_t width = std::min(padded - tap, TapQueue::kCapacity);
            for (size_t p = begin; p < end; ++p) queue_pixel(shading, block, p, tap, width, (p - begin) * width, queue);
            for (size_t p = begin; p < end; ++p) {
                float rgba[4];
                queued_sum(shading.stack.layout(), queue, (p - begin) * width, std::min(width, taps - tap), rgba);
                sums[p] += Color3f(rgba[0], rgba[1], rgba[2]);
            }
        }
    }
}

void shade_batch(const TableShading& shading, const SurfaceBatch& batch, std::span<Color3f> overlay) {
    PixelBlock block;
    TapQueue queue;
    Color3f sums[PixelBlock::kPixels];
    const Color3f gain = shading.lobe.tint * shading.lobe.strength * shading.gain;
    for (size_t begin = 0; begin < batch.size(); begin += PixelBlock::kPixels) {
        const size_t count = std::min(PixelBlock::kPixels, batch.size() - begin);
        for (size_t i = 0; i < count; i += hn::Lanes(Lanes())) prepare_pixels(shading, batch, begin + i, i, block);
        shade_block(shading, block, count, queue, sums);
        for (size_t i = 0; i < count; ++i) overlay[begin + i] += sums[i] * gain * pixel_scale(shading.lobe, batch, begin + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(shade_batch);

void add_table_shading(const TableShading& shading, const SurfaceBatch& batch, std::span<Color3f> overlay) {
    HWY_DYNAMIC_DISPATCH(shade_batch)(shading, batch, overlay);
}

}  // namespace burnish
#endif
