#include <burnish/surface/fetch.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/surface/fetch.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FetchLanes = hn::ScalableTag<float>;
using Fetched = hn::Vec<FetchLanes>;
constexpr size_t kAhead =
    128;  // pixels asked for while these are worked on: rows of a tile are too short for the processor's guess
constexpr size_t kPixelsPerLine = 4;  // of a cache line, 5 1/3
constexpr size_t kMostLanes = hn::MaxLanes(FetchLanes());

struct FetchedVectors {
    Fetched x, y, z;
};

/// Of pixels anywhere in the frame.
HWY_INLINE FetchedVectors load_scattered(const float* layer, const uint32_t* pixels) {
    const FetchLanes d;
    HWY_ALIGN float x[kMostLanes], y[kMostLanes], z[kMostLanes];
    for (size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const float* v = layer + 3 * static_cast<size_t>(pixels[lane]);
        x[lane] = v[0], y[lane] = v[1], z[lane] = v[2];
    }
    return {hn::Load(d, x), hn::Load(d, y), hn::Load(d, z)};
}

HWY_INLINE FetchedVectors load_listed(const float* layer, const uint32_t* pixels) {
    const FetchLanes d;
    const hn::RebindToUnsigned<FetchLanes> d_pixel;
    if (!hn::AllTrue(d_pixel, hn::Eq(hn::LoadU(d_pixel, pixels), hn::Iota(d_pixel, pixels[0]))))
        return load_scattered(layer, pixels);
    FetchedVectors v;
    hn::LoadInterleaved3(d, layer + 3 * static_cast<size_t>(pixels[0]), v.x, v.y, v.z);
    return v;
}

/// Valid pixels have no zero vectors; the floor keeps those whose square is none finite.
HWY_INLINE void store_unit(const FetchedVectors& v, size_t at, Vec3Planes& unit) {
    const FetchLanes d;
    const Fetched square = hn::Add(hn::Add(hn::Mul(v.x, v.x), hn::Mul(v.y, v.y)), hn::Mul(v.z, v.z));
    const Fetched length = hn::Sqrt(hn::Max(square, hn::Set(d, 1e-37f)));
    hn::StoreU(hn::Div(v.x, length), d, unit.x.data() + at);
    hn::StoreU(hn::Div(v.y, length), d, unit.y.data() + at);
    hn::StoreU(hn::Div(v.z, length), d, unit.z.data() + at);
}

HWY_INLINE void resize_planes(Vec3Planes& planes, size_t count) {
    planes.x.resize(count), planes.y.resize(count), planes.z.resize(count);
}

/// unit <- `vector(pixels)` of the layer, a vector of them at a time, normalised. The last ones go along with copies of the last.
template <class VectorOf>
HWY_INLINE void fetch_all(const float* layer, std::span<const uint32_t> pixels, const VectorOf& vector, Vec3Planes& unit) {
    const size_t lanes = hn::Lanes(FetchLanes()), whole = pixels.size() / lanes * lanes;
    resize_planes(unit, whole == pixels.size() ? whole : whole + lanes);
    for (size_t at = 0; at < whole; at += lanes) {
        const size_t ahead = std::min(at + kAhead, pixels.size() - lanes);
        for (size_t lane = 0; lane < lanes; lane += kPixelsPerLine)
            hwy::Prefetch(layer + 3 * static_cast<size_t>(pixels[ahead + lane]));
        store_unit(vector(pixels.data() + at), at, unit);
    }
    if (whole == pixels.size()) return;
    uint32_t rest[kMostLanes];
    std::fill_n(std::copy(pixels.begin() + static_cast<std::ptrdiff_t>(whole), pixels.end(), rest),
                lanes - (pixels.size() - whole), pixels.back());
    store_unit(vector(rest), whole, unit);
    resize_planes(unit, pixels.size());
}

void fetch_unit_vectors(const float* layer, std::span<const uint32_t> pixels, Vec3Planes& unit) {
    fetch_all(
        layer, pixels, [&](const uint32_t* listed) { return load_listed(layer, listed); }, unit);
}

void fetch_view_vectors(const float* position, const Vec3f& eye, std::span<const uint32_t> pixels, Vec3Planes& wo) {
    const FetchLanes d;
    const auto view = [&](const uint32_t* listed) -> FetchedVectors {
        const FetchedVectors p = load_listed(position, listed);
        return {hn::Sub(hn::Set(d, eye.x), p.x), hn::Sub(hn::Set(d, eye.y), p.y), hn::Sub(hn::Set(d, eye.z), p.z)};
    };
    fetch_all(position, pixels, view, wo);
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(fetch_unit_vectors);
HWY_EXPORT(fetch_view_vectors);

void fetch_unit(const float* layer, std::span<const uint32_t> pixels, Vec3Planes& unit) {
    HWY_DYNAMIC_DISPATCH(fetch_unit_vectors)(layer, pixels, unit);
}

void fetch_views(const float* position, const Vec3f& eye, std::span<const uint32_t> pixels, Vec3Planes& wo) {
    HWY_DYNAMIC_DISPATCH(fetch_view_vectors)(position, eye, pixels, wo);
}

}  // namespace burnish
#endif
