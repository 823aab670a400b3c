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

void set_rays(const LobeTable& lobe, const SurfaceBatch& batch, size_t begin, size_t end, TapRays& out) {
    PixelBlock block;
    PlacedTaps taps;
    const size_t all = static_cast<size_t>(lobe.table.tap_count());
    const Vec3Planes& ng = batch.geometric_normal();
    out.rays.resize((end - begin) * all), out.weights.resize((end - begin) * all + hn::MaxLanes(Lanes())), out.ends.clear();
    size_t count = 0;
    for (size_t first = begin; first < end; first += PixelBlock::kPixels) {
        const size_t pixels = std::min(PixelBlock::kPixels, end - first);
        for (size_t i = 0; i < pixels; i += hn::Lanes(Lanes())) prepare_pixels(lobe, batch, first + i, i, block);
        for (size_t i = 0; i < pixels; ++i) {
            const Vec3f p = batch.p[first + i], normal = ng[first + i];
            for (size_t tap = 0; tap < all; tap += TapQueue::kCapacity) {
                const size_t placed = place_taps(lobe, block, i, tap, std::min(all - tap, TapQueue::kCapacity), 0, taps,
                                                 reinterpret_cast<Weights>(&out.weights[count]));
                finish_taps(placed, taps);
                for (size_t k = 0; k < placed; ++k)
                    out.rays[count + k] = {p, normal, {taps.x[k], taps.y[k], taps.z[k]}, taps.level[k], lobe.table.side_sign()};
                count += placed;
            }
            out.ends.push_back(static_cast<uint32_t>(count));
        }
    }
    out.rays.resize(count);
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
