#include <burnish/shading/tap_rays.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/shading/tap_rays.cpp"
#include <hwy/foreach_target.h>

#include <burnish/shading/tap_place_simd.h>
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

/// Directions made unit vectors, levels widths.
HWY_INLINE void finish_taps(size_t count, PlacedTaps& taps) {
    const Lanes d;
    for (size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V3 wi{hn::Load(d, taps.x + i), hn::Load(d, taps.y + i), hn::Load(d, taps.z + i)};
        const V3 unit = wi * hn::Div(constant(1), hn::Sqrt(dot(wi, wi)));
        hn::Store(unit.x, d, taps.x + i), hn::Store(unit.y, d, taps.y + i), hn::Store(unit.z, d, taps.z + i);
        hn::Store(hn::Exp(d, hn::Load(d, taps.level + i)), d, taps.level + i);
    }
}

/// Writes the placed taps of pixel i of the batch, `first` to `end`, as the next rays.
HWY_INLINE void write_rays(const SurfaceBatch& batch, size_t i, const PlacedTaps& taps, size_t first, size_t end, float side,
                           LightRay* rays) {
    const Vec3f p = batch.p[i], ng = batch.geometric_normal()[i];
    for (size_t k = first; k < end; ++k) *rays++ = {p, ng, {taps.x[k], taps.y[k], taps.z[k]}, taps.level[k], side};
}

Weights weights_from(TapRays& out, size_t ray) { return reinterpret_cast<Weights>(&out.weights[ray]); }

/// All taps of prepared pixels [begin, end), few enough for one go; pixel 0 of the block is `first` of the batch.
void set_block(const LobeTable& lobe, const SurfaceBatch& batch, const PixelBlock& block, size_t first, size_t begin,
               size_t end, PlacedTaps& taps, TapRays& out) {
    const size_t all = static_cast<size_t>(lobe.table.tap_count()), from = out.count();
    size_t ends[PixelBlock::kPixels], at = 0;
    for (size_t i = begin; i < end; ++i) ends[i] = at = place_taps(lobe, block, i, 0, all, at, taps, weights_from(out, from));
    finish_taps(at, taps);
    for (size_t i = begin, k = 0; i < end; k = ends[i++]) {
        write_rays(batch, first + i, taps, k, ends[i], lobe.table.side_sign(), &out.rays[from + k]);
        out.ends.push_back(static_cast<uint32_t>(from + ends[i]));
    }
}

/// One prepared pixel whose taps are too many for one go.
void set_pixel(const LobeTable& lobe, const SurfaceBatch& batch, const PixelBlock& block, size_t first, size_t i,
               PlacedTaps& taps, TapRays& out) {
    const size_t all = static_cast<size_t>(lobe.table.tap_count());
    size_t count = out.count();
    for (size_t tap = 0; tap < all; tap += TapQueue::kCapacity) {
        const size_t at_once = std::min(all - tap, TapQueue::kCapacity);
        const size_t placed = place_taps(lobe, block, i, tap, at_once, 0, taps, weights_from(out, count));
        finish_taps(placed, taps);
        write_rays(batch, first + i, taps, 0, placed, lobe.table.side_sign(), &out.rays[count]);
        count += placed;
    }
    out.ends.push_back(static_cast<uint32_t>(count));
}

void set_rays(const LobeTable& lobe, const SurfaceBatch& batch, size_t begin, size_t end, TapRays& out) {
    PixelBlock block;
    PlacedTaps taps;
    const size_t all = static_cast<size_t>(lobe.table.tap_count()), room = (end - begin) * all + hn::MaxLanes(Lanes());
    const size_t at_once = TapQueue::kCapacity / all;  // pixels
    if (out.rays.size() < room) out.rays.resize(room), out.weights.resize(room);
    out.ends.clear();
    for (size_t first = begin; first < end; first += PixelBlock::kPixels) {
        const size_t pixels = std::min(PixelBlock::kPixels, end - first);
        for (size_t i = 0; i < pixels; i += hn::Lanes(Lanes())) prepare_pixels(lobe, batch, first + i, i, block);
        for (size_t i = 0; i < pixels; i += std::max<size_t>(at_once, 1))
            if (at_once > 0)
                set_block(lobe, batch, block, first, i, std::min(i + at_once, pixels), taps, out);
            else
                set_pixel(lobe, batch, block, first, i, taps, out);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(set_rays);

void set_table_rays(const LobeTable& lobe, const SurfaceBatch& batch, size_t begin, size_t end, TapRays& out) {
    HWY_DYNAMIC_DISPATCH(set_rays)(lobe, batch, begin, end, out);
}

}  // namespace burnish
#endif
