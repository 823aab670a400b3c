// Internal. Which direction a factor is looked up by, and where that lies in its map: lanes are pixels. The same as
// ProjectedDirection::project and DirectionMap::lookup. Compiled once per instruction set.
#include <burnish/shading/batch_lanes_simd.h>
#include <burnish/shading/factor_shading.h>

// Included anew for each instruction set.
#if defined(BURNISH_FACTOR_PLACE_SIMD) == defined(HWY_TARGET_TOGGLE)
#ifdef BURNISH_FACTOR_PLACE_SIMD
#undef BURNISH_FACTOR_PLACE_SIMD
#else
#define BURNISH_FACTOR_PLACE_SIMD
#endif

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {

/// Pixels in light axes.
struct LitPixels {
    V3 n, wo;
    const FactorGuide& guide;
};

/// Lookups of one factor: the texel above left, counted from the map's first, and the shares of the next column and row.
struct PlacedLookups {
    static constexpr size_t kPixels = 64;
    HWY_ALIGN int32_t texel[kPixels];
    HWY_ALIGN float x[kPixels], y[kPixels];
};

HWY_INLINE V3 same_everywhere(const Vec3f& v) { return {constant(v.x), constant(v.y), constant(v.z)}; }

/// d in the frame along n: Frame::along(n, hint).to_local(d).
HWY_INLINE V3 in_frame_along(const V3& n, const V3& hint, const V3& d) {
    const V3 t = tangent_along(n, hint);
    return {dot(d, t), dot(d, cross(n, t)), dot(d, n)};
}

/// Between which two of `size` values in a row a place lies, the first at 0, and the share of the second.
struct Along {
    VI low;
    VF part;
};
HWY_INLINE Along along(VF place, int size) {
    const Lanes d;
    const IntLanes di;
    const VF within = clamped(place, constant(static_cast<float>(size - 1)));
    const VI low = hn::Min(hn::ConvertTo(di, within), hn::Set(di, size - 2));
    return {low, hn::Sub(within, hn::ConvertTo(d, low))};
}

/// FactorGuide::reflection.
HWY_INLINE V3 reflection(const LitPixels& pixels) {
    const Lanes d;
    const FactorGuide& guide = pixels.guide;
    const VF c = dot(pixels.n, pixels.wo), steps = constant(FactorGuide::kKnots - 1);
    const Along at = along(hn::Mul(c, steps), FactorGuide::kKnots);
    const auto read = [&](const std::array<float, FactorGuide::kKnots>& curve) {
        const VF low = hn::GatherIndex(d, curve.data(), at.low), next = hn::GatherIndex(d, curve.data() + 1, at.low);
        return hn::MulAdd(hn::Sub(next, low), at.part, low);
    };
    const V3 r = pixels.n * read(guide.towards_n) + (pixels.n * c - pixels.wo) * read(guide.towards_r);
    return r * hn::Div(constant(1), hn::Max(hn::Sqrt(dot(r, r)), constant(1e-6f)));
}

HWY_INLINE V3 dominant_half(const LitPixels& pixels) {
    const V3 dominant = same_everywhere(pixels.guide.dominant), sum = dominant + pixels.wo;
    const VF length2 = dot(sum, sum);
    const auto defined = hn::Gt(length2, constant(1e-12f));
    const V3 unit = sum * hn::Div(constant(1), hn::Sqrt(length2));
    const V3 half = {hn::IfThenElse(defined, unit.x, dominant.x), hn::IfThenElse(defined, unit.y, dominant.y),
                     hn::IfThenElse(defined, unit.z, dominant.z)};
    return in_frame_along(pixels.n, dominant, half);
}

/// Lane by lane, by the parametrisation's own function.
HWY_INLINE V3 projected(const ProjectedDirection& direction, const LitPixels& pixels) {
    const Lanes d;
    HWY_ALIGN float n[3][8], wo[3][8], found[3][8];
    hn::Store(pixels.n.x, d, n[0]), hn::Store(pixels.n.y, d, n[1]), hn::Store(pixels.n.z, d, n[2]);
    hn::Store(pixels.wo.x, d, wo[0]), hn::Store(pixels.wo.y, d, wo[1]), hn::Store(pixels.wo.z, d, wo[2]);
    for (size_t i = 0; i < hn::Lanes(d); ++i) {
        const Vec3f own = direction.project({{n[0][i], n[1][i], n[2][i]}, {wo[0][i], wo[1][i], wo[2][i]}}, pixels.guide);
        found[0][i] = own.x, found[1][i] = own.y, found[2][i] = own.z;
    }
    return {hn::Load(d, found[0]), hn::Load(d, found[1]), hn::Load(d, found[2])};
}

HWY_INLINE V3 direction_of(const FactorShading::Lookup& lookup, const LitPixels& pixels) {
    using enum FactorShading::Vectorised;
    switch (lookup.vectorised) {
        case normal: return pixels.n;
        case view: return pixels.wo;
        case reflection: return HWY_NAMESPACE::reflection(pixels);
        case elevation: {
            const VF z = clamped(dot(pixels.n, pixels.wo), constant(1));
            return {hn::Sqrt(hn::NegMulAdd(z, z, constant(1))), constant(0), z};
        }
        case dominant_half: return HWY_NAMESPACE::dominant_half(pixels);
        case dominant_difference: {
            const V3 dominant = same_everywhere(pixels.guide.dominant);
            return in_frame_along(HWY_NAMESPACE::dominant_half(pixels), same_everywhere({1, 0, 0}),
                                  in_frame_along(pixels.n, dominant, dominant));
        }
        default: return projected(*lookup.direction, pixels);
    }
}

/// Where the square of a disc starts, texels to the right, and the place there from its middle, the rim at 1.
struct OnDisc {
    VI first;
    VF x, y;
};
HWY_INLINE OnDisc on_disc(Mapping mapping, int size, const V3& d) {
    const IntLanes di;
    const VF zero = constant(0), least = constant(1e-6f), below_rim = hn::Sqrt(hn::MulAdd(d.x, d.x, hn::Mul(d.y, d.y)));
    VF radius = hn::Max(hn::Add(constant(1), d.z), least);
    VI first = hn::Zero(di);
    if (mapping == Mapping::double_parabolic) {
        radius = hn::Add(constant(1), hn::Abs(d.z));
        first = hn::IfThenElseZero(hn::RebindMask(di, hn::Lt(d.z, zero)), hn::Set(di, size));
    } else if (mapping == Mapping::hemispherical)
        radius = hn::IfThenElse(hn::Lt(d.z, zero), hn::Max(below_rim, least), constant(1));
    return {first, hn::Div(d.x, radius), hn::Div(d.y, radius)};
}

/// Lookups of a vector of pixels to entries i and on. Any direction, NaN included, stays within the map.
HWY_INLINE void place_lookups(const FactorShading::Texture& texture, const V3& direction, size_t i, PlacedLookups& out) {
    const Lanes d;
    const IntLanes di;
    const VF size = constant(static_cast<float>(texture.size)), half = constant(0.5f);
    const VI stride = hn::Set(di, texture.stride);
    Along x, y{hn::Zero(di), hn::Zero(d)};
    VI row = hn::Zero(di), first = hn::Zero(di);
    if (texture.mapping == Mapping::elevation) {
        x = along(hn::Mul(direction.z, hn::Sub(size, constant(1))), texture.size);
    } else if (texture.mapping == Mapping::cube) {
        const OnFace at = on_face(direction);
        x = along(hn::MulAdd(hn::Add(half, at.x), size, half), texture.stride);
        y = along(hn::MulAdd(hn::Sub(half, at.y), size, half), texture.stride);
        row = hn::Add(hn::Mul(at.face, stride), y.low);
    } else {
        const OnDisc at = on_disc(texture.mapping, texture.size, direction);
        const VF radius = hn::MulSub(half, size, constant(1)), middle = hn::MulSub(half, size, half);
        x = along(hn::MulAdd(at.x, radius, middle), texture.size), y = along(hn::MulAdd(at.y, radius, middle), texture.size);
        row = y.low, first = at.first;
    }
    hn::Store(hn::Add(hn::Mul(row, stride), hn::Add(first, x.low)), di, out.texel + i);
    hn::Store(x.part, d, out.x + i), hn::Store(y.part, d, out.y + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();
#endif
