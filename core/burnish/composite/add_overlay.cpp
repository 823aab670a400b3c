#include <burnish/composite/add_overlay.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/composite/add_overlay.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Colors {
    hn::Vec<D> c[3];

    HWY_INLINE Colors(D d, const float* pixels) { hn::LoadInterleaved3(d, pixels, c[0], c[1], c[2]); }
};

template <class D>
HWY_INLINE hn::Vec<D> masked(D d, const float* share, const OverlayRow& row, size_t at) {
    const auto whole = hn::LoadU(d, share + at);
    if (!row.mask) return whole;
    const auto mask = hn::LoadU(d, row.mask + at);
    return hn::IfThenElseZero(hn::IsFinite(mask), hn::Mul(whole, mask));
}

/// Pixels [at, end), whole vectors of them; returns where it stopped.
template <class D>
HWY_INLINE size_t add_vectors(D d, const OverlayRow& row, const Color3f& tint, float gain, size_t at, size_t end) {
    for (; at + hn::Lanes(d) <= end; at += hn::Lanes(d)) {
        const auto gained = hn::Mul(hn::Set(d, gain), masked(d, row.coverage, row, at));
        Colors<D> added(d, row.overlay + 3 * at), sum(d, row.base + 3 * at);
        if (row.old_overlay) {
            const Colors<D> old(d, row.old_overlay + 3 * at);
            for (int k = 0; k < 3; ++k) added.c[k] = hn::Sub(added.c[k], old.c[k]);
        }
        for (int k = 0; k < 3; ++k) {
            added.c[k] = hn::Mul(added.c[k], hn::Mul(hn::Set(d, tint[k]), gained));
            sum.c[k] = hn::Add(sum.c[k], added.c[k]);
        }
        if (row.removed) {
            const Colors<D> removed(d, row.removed + 3 * at);
            const auto weight = masked(d, row.replaced, row, at);
            for (int k = 0; k < 3; ++k) sum.c[k] = hn::Sub(sum.c[k], hn::Mul(removed.c[k], weight));
        }
        const auto alpha = row.alpha ? hn::LoadU(d, row.alpha + at) : hn::Set(d, 1.0f);
        hn::StoreInterleaved3(added.c[0], added.c[1], added.c[2], d, row.overlay + 3 * at);
        hn::StoreInterleaved4(sum.c[0], sum.c[1], sum.c[2], alpha, d, row.beauty + 4 * at);
    }
    return at;
}

void add_overlay_pixels(const OverlayRow& row, const Color3f& tint, float gain, size_t count) {
    const size_t at = add_vectors(hn::ScalableTag<float>(), row, tint, gain, 0, count);
    add_vectors(hn::CappedTag<float, 1>(), row, tint, gain, at, count);
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(add_overlay_pixels);

void add_overlay(const OverlayRow& row, const Color3f& tint, float gain, size_t count) {
    HWY_DYNAMIC_DISPATCH(add_overlay_pixels)(row, tint, gain, count);
}

}  // namespace burnish
#endif
