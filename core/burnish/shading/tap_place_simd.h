// Internal. The taps of pixels from a lobe's table: between the nodes about the view, turned into directions of light axes, faded
// where the geometric surface hides them. Lanes are taps. Compiled once per instruction set.
#include <burnish/shading/pixel_block_simd.h>

// Included anew for each instruction set.
#if defined(BURNISH_TAP_PLACE_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef BURNISH_TAP_PLACE_SIMD
#undef BURNISH_TAP_PLACE_SIMD
#else
#define BURNISH_TAP_PLACE_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

using Weights = float (*)[4];  // R, G, B and the luminance of these

HWY_INLINE V3 pixel_vector(const PixelBlock::Planes& planes, size_t pixel) {
    return {constant(planes[0][pixel]), constant(planes[1][pixel]), constant(planes[2][pixel])};
}

/// Taps of several pixels, one after the other, before their texels are known; their weights lie elsewhere.
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
                             Weights weights) {
    const Lanes d;
    const auto store = [&](const V3& w, VF l, const V3& rgb) {
        hn::StoreU(w.x, d, taps.x + at), hn::StoreU(w.y, d, taps.y + at), hn::StoreU(w.z, d, taps.z + at);
        hn::StoreU(l, d, taps.level + at);
        const VF bright = dot(rgb, {constant(0.2126f), constant(0.7152f), constant(0.0722f)});  // of the stack's fourth channel
        hn::StoreInterleaved4(rgb.x, rgb.y, rgb.z, bright, d, weights[at]);
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
HWY_INLINE size_t place_taps(const LobeTable& lobe_table, const PixelBlock& block, size_t pixel, size_t first, size_t count,
                             size_t at, PlacedTaps& taps, Weights weights) {
    const Lanes d;
    const V3 t = pixel_vector(block.t, pixel), b = pixel_vector(block.b, pixel), n = pixel_vector(block.n, pixel);
    const V3 wo = pixel_vector(block.wo, pixel), ng = pixel_vector(block.ng, pixel);
    const V3 wo_local = pixel_vector(block.wo_local, pixel);
    for (size_t tap = first; tap < first + count; tap += hn::Lanes(d)) {
        const TableTaps found(lobe_table.table, block, pixel, tap);
        const V3 h{found.field[TapTable::h_x], found.field[TapTable::h_y], found.field[TapTable::h_z]};
        const VF wo_h = dot(wo_local, h);
        const V3 wi = (t * h.x + b * h.y + n * h.z) * hn::Add(wo_h, wo_h) - wo * dot(h, h);
        const VF level = found.field[TapTable::level];
        const V3 weight{found.field[TapTable::weight_r], found.field[TapTable::weight_g], found.field[TapTable::weight_b]};
        at = store_taps(wi, level, weight * visible_shares(dot(n, wi), dot(ng, wi), found.field[TapTable::edge]),
                        std::min(hn::Lanes(d), first + count - tap), at, taps, weights);
    }
    return at;
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();
#endif
