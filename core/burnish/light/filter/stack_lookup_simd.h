// Internal. The filtered lookup as a kernel, compiled once per instruction set (Google Highway's foreach_target).
//
// Lookups go through a queue in the first-level cache. `queue_taps` works out where a vector of lookups lies: face, place,
// levels, and the offsets and weights of their texels; lanes are lookups. `queued_sum` then reads texels, one lookup after
// the other: lanes are the RGBA of two neighbouring texels, so nothing is gathered. Keeping the two apart lets the processor
// fetch texels of many lookups at once.
#include <burnish/light/filter/cube_stack.h>

#include <hwy/highway.h>

// Included anew for each instruction set.
#if defined(BURNISH_STACK_LOOKUP_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef BURNISH_STACK_LOOKUP_SIMD
#undef BURNISH_STACK_LOOKUP_SIMD
#else
#define BURNISH_STACK_LOOKUP_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Eight lookups a vector, fewer where vectors are shorter; wider ones were slower.
using Lanes = hn::CappedTag<float, 8>;
using IntLanes = hn::RebindToSigned<Lanes>;
using VF = hn::Vec<Lanes>;
using VI = hn::Vec<IntLanes>;

struct V3 {
    VF x, y, z;
};
HWY_INLINE VF dot(const V3& a, const V3& b) { return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z))); }

/// Between 0 and `high`; 0 for NaN.
HWY_INLINE VF clamped(VF v, VF high) { return hn::Min(hn::IfThenElseZero(hn::Gt(v, hn::Zero(Lanes())), v), high); }

/// Lookups whose texels are known. Offsets count texels from the start of the stack.
struct TapQueue {
    static constexpr size_t kCapacity = 256, kRoom = kCapacity + 8;  // a whole vector may be stored at the last entry
    HWY_ALIGN int32_t fine[kRoom], fine_below[kRoom], coarse[kRoom], coarse_below[kRoom];
    HWY_ALIGN float fine_y[kRoom], coarse_y[kRoom];  // share of the lower row
    HWY_ALIGN float columns[kRoom][4];               // weights: fine left, fine right, coarse left, coarse right
    HWY_ALIGN float weight[kRoom][4];                // of R, G, B and A
};

/// Entry k of a table of levels, k in [0, kShortTable) or any k of a longer table.
template <class D>
HWY_INLINE hn::Vec<D> of_level(D d, const std::vector<hn::TFromD<D>>& table, VI k) {
    constexpr size_t kHalf = CubeStack::kShortTable / 2;
    if (hn::MaxLanes(D()) != kHalf || table.size() > 2 * kHalf) return hn::GatherIndex(d, table.data(), k);
    const IntLanes di;
    const auto index = hn::IndicesFromVec(d, hn::And(k, hn::Set(di, kHalf - 1)));
    const auto low = hn::TableLookupLanes(hn::LoadU(d, table.data()), index);
    const auto high = hn::TableLookupLanes(hn::LoadU(d, table.data() + kHalf), index);
    return hn::IfThenElse(hn::RebindMask(d, hn::Gt(k, hn::Set(di, kHalf - 1))), high, low);
}

/// The nearest whole number of v in [-1, 2^22), both ways up; ties go either way.
struct Whole {
    VI index;
    VF value;
};
HWY_INLINE Whole nearest(VF v) {
    const Lanes d;
    const IntLanes di;
    const VF shift = hn::Set(d, 0x1.8p23f), shifted = hn::Add(v, shift);  // the last bit of such a float is worth one
    return {hn::Sub(hn::BitCast(di, shifted), hn::BitCast(di, shift)), hn::Sub(shifted, shift)};
}

/// The place of a lookup in one level: the texel above left, the one below it, and the shares of the next column and row.
/// Texel centres lie half a texel in, so the texel to the left, the border counted, is the nearest edge.
struct Place {
    VI texel, below;
    VF x, y;
};
HWY_INLINE Place place(const CubeStack::Layout& stack, VI level, VI face, VF x, VF y) {
    const IntLanes di;
    const VF size = of_level(Lanes(), stack.sizes, level), half = hn::Set(Lanes(), 0.5f);
    const VI stride = hn::Add(nearest(size).index, hn::Set(di, 2)), begin = of_level(di, stack.begins, level);
    const VF px = hn::Mul(x, size), py = hn::Mul(y, size);
    const Whole column = nearest(px), row = nearest(py);
    const VI first = hn::Add(hn::Mul(hn::Add(hn::Mul(face, stride), row.index), stride), column.index);
    const VI texel = hn::Add(first, begin);
    return {texel, hn::Add(texel, stride), hn::Add(hn::Sub(px, column.value), half), hn::Add(hn::Sub(py, row.value), half)};
}

/// cube_distortion for 4 q = |d|^2 / max d_k^2 - 1, q in [0, 1/2], within 4e-5: Chebyshev in t = 4 q - 1, by Estrin's scheme.
HWY_INLINE VF distortion_of(VF q) {
    const Lanes d;
    const auto c = [&](float value) { return hn::Set(d, value); };
    const VF t = hn::MulSub(q, c(4), c(1)), t2 = hn::Mul(t, t);
    const VF p01 = hn::MulAdd(c(0.360801727f), t, c(0.5f)), p23 = hn::MulAdd(c(0.0290577225f), t, c(-0.090225026f));
    const VF p45 = hn::MulAdd(c(0.00635830406f), t, c(-0.0108298585f));
    const VF p456 = hn::MulAdd(c(-0.00269431947f), t2, p45);
    return hn::MulAdd(hn::MulAdd(p456, t2, p23), t2, p01);
}

/// Where directions of any length meet the cube: the face, and the place there from its centre, right and up, within +-1/2.
struct OnFace {
    VI face;
    VF x, y;
};
HWY_INLINE OnFace on_face(const V3& w) {
    const Lanes d;
    const IntLanes di;
    const VF ax = hn::Abs(w.x), ay = hn::Abs(w.y), az = hn::Abs(w.z), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const auto is_x = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az)), is_y = hn::AndNot(is_x, hn::Ge(ay, az));
    const VF major = hn::IfThenElse(is_x, w.x, hn::IfThenElse(is_y, w.y, w.z)), sign = hn::CopySign(one, major);
    const VF right = hn::IfThenElse(is_x, hn::Mul(w.z, sign), hn::IfThenElse(is_y, w.x, hn::Neg(hn::Mul(w.x, sign))));
    const VF up = hn::IfThenElse(is_y, hn::Mul(w.z, sign), w.y), scale = hn::Div(half, hn::Abs(major));
    const VI axis2 = hn::IfThenElse(hn::RebindMask(di, is_x), hn::Zero(di),
                                    hn::IfThenElse(hn::RebindMask(di, is_y), hn::Set(di, 2), hn::Set(di, 4)));
    const VI face = hn::Sub(axis2, hn::VecFromMask(di, hn::RebindMask(di, hn::Lt(major, hn::Zero(d)))));
    return {face, hn::Mul(right, scale), hn::Mul(up, scale)};
}

/// Queues a vector of lookups at entries `at` and on, weights apart. Any direction, NaN included, stays within the stack.
HWY_INLINE void queue_taps(const CubeStack::Layout& stack, float distortion, const V3& w, VF level, size_t at,
                           TapQueue& queue) {
    const Lanes d;
    const IntLanes di;
    const VF one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const auto [face, x, y] = on_face(w);
    const VF distorted = hn::MulAdd(hn::Set(d, distortion), distortion_of(hn::MulAdd(x, x, hn::Mul(y, y))), level);
    const VF at_level = clamped(distorted, hn::Set(d, stack.last_level));
    const Whole k = nearest(hn::Sub(at_level, half));
    const VF coarser = hn::Sub(at_level, k.value), finer = hn::Sub(one, coarser);

    const VF px = clamped(hn::Add(half, x), one), py = clamped(hn::Sub(half, y), one);
    const Place fine = place(stack, k.index, face, px, py),
                coarse = place(stack, hn::Add(k.index, hn::Set(di, 1)), face, px, py);
    hn::StoreU(fine.texel, di, queue.fine + at), hn::StoreU(fine.below, di, queue.fine_below + at);
    hn::StoreU(coarse.texel, di, queue.coarse + at), hn::StoreU(coarse.below, di, queue.coarse_below + at);
    hn::StoreU(fine.y, d, queue.fine_y + at), hn::StoreU(coarse.y, d, queue.coarse_y + at);
    const VF fine_right = hn::Mul(fine.x, finer), coarse_right = hn::Mul(coarse.x, coarser);
    hn::StoreInterleaved4(hn::Sub(finer, fine_right), fine_right, hn::Sub(coarser, coarse_right), coarse_right, d,
                          queue.columns[at]);
}

#if HWY_MAX_BYTES >= 32
using Pair = hn::FixedTag<float, 8>;

/// Of each queued lookup from `first` on, two RGBA that add up to it, handed to `use(i, both)`; `texels(offset)` loads two RGBA
/// texels of a row.
template <class Texels, class Use>
HWY_INLINE void for_each_pair(const Texels& texels, const TapQueue& queue, size_t first, size_t count, const Use& use) {
    const Pair pair;
    alignas(32) static constexpr int32_t kFine[8] = {0, 0, 0, 0, 1, 1, 1, 1}, kCoarse[8] = {2, 2, 2, 2, 3, 3, 3, 3};
    const auto fine_columns = hn::SetTableIndices(pair, kFine), coarse_columns = hn::SetTableIndices(pair, kCoarse);
    for (size_t i = first; i < first + count; ++i) {
        const auto row = [&](int32_t above, int32_t below, float y) {
            const auto top = texels(above), bottom = texels(below);
            return hn::MulAdd(hn::Sub(bottom, top), hn::Set(pair, y), top);
        };
        const auto columns = hn::LoadDup128(pair, queue.columns[i]);
        const auto fine =
            hn::Mul(row(queue.fine[i], queue.fine_below[i], queue.fine_y[i]), hn::TableLookupLanes(columns, fine_columns));
        use(i, hn::MulAdd(row(queue.coarse[i], queue.coarse_below[i], queue.coarse_y[i]),
                          hn::TableLookupLanes(columns, coarse_columns), fine));
    }
}

HWY_INLINE void store_sum(hn::Vec<Pair> both, float* rgba) {
    const hn::FixedTag<float, 4> single;
    hn::StoreU(hn::Add(hn::LowerHalf(single, both), hn::UpperHalf(single, both)), single, rgba);
}
#endif

/// Adds up `count` queued lookups from `first` on, each channel by its own weight.
HWY_INLINE void queued_sum(const CubeStack::Layout& stack, const TapQueue& queue, size_t first, size_t count, float* rgba) {
    const auto texel = [&](int32_t offset) { return stack.rgba + 4 * static_cast<size_t>(offset); };
#if HWY_MAX_BYTES >= 32
    const Pair pair;
    auto sum = hn::Zero(pair);
    for_each_pair([&](int32_t offset) { return hn::LoadU(pair, texel(offset)); }, queue, first, count,
                  [&](size_t i, auto both) { sum = hn::MulAdd(both, hn::LoadDup128(pair, queue.weight[i]), sum); });
    store_sum(sum, rgba);
#else
    std::fill_n(rgba, 4, 0.0f);
    for (size_t i = first; i < first + count; ++i) {
        const float *columns = queue.columns[i], fine_y = queue.fine_y[i], coarse_y = queue.coarse_y[i];
        const float *fine = texel(queue.fine[i]), *fine_below = texel(queue.fine_below[i]);
        const float *coarse = texel(queue.coarse[i]), *coarse_below = texel(queue.coarse_below[i]);
        const auto row = [](const float* above, const float* below, float y, int k) {
            return above[k] + (below[k] - above[k]) * y;
        };
        for (int k = 0; k < 4; ++k)
            rgba[k] +=
                queue.weight[i][k] *
                (columns[0] * row(fine, fine_below, fine_y, k) + columns[1] * row(fine, fine_below, fine_y, k + 4) +
                 columns[2] * row(coarse, coarse_below, coarse_y, k) + columns[3] * row(coarse, coarse_below, coarse_y, k + 4));
    }
#endif
}

/// Each of `count` queued lookups by itself, times `gain`; weights play no part.
HWY_INLINE void queued_values(const CubeStack::Layout& stack, TapQueue& queue, size_t count, const float* gain,
                              float (*rgba)[4]) {
#if HWY_MAX_BYTES >= 32
    const Pair pair;
    const auto gains = hn::LoadDup128(pair, gain);
    for_each_pair([&](int32_t offset) { return hn::LoadU(pair, stack.rgba + 4 * static_cast<size_t>(offset)); }, queue, 0,
                  count, [&](size_t i, auto both) { store_sum(hn::Mul(both, gains), rgba[i]); });
#else
    for (size_t i = 0; i < count; ++i) {
        std::copy_n(gain, 4, queue.weight[i]);
        queued_sum(stack, queue, i, 1, rgba[i]);
    }
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();
#endif
