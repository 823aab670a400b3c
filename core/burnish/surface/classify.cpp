#include <burnish/surface/classify.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/surface/classify.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using PixelLanes = hn::ScalableTag<float>;
using CodeLanes = hn::RebindToSigned<PixelLanes>;
using RuleLanes = hn::Rebind<int16_t, PixelLanes>;
using ByteLanes = hn::Rebind<uint8_t, PixelLanes>;
using PixelFloats = hn::Vec<PixelLanes>;
using Codes = hn::Vec<CodeLanes>;

constexpr float kMiss = 1e9f;         // renderers write 1e10, 1e30 or infinity where no surface was hit
constexpr float kZeroNormal = 1e-6f;  // length

struct PixelVectors {
    PixelFloats x, y, z;
};

HWY_INLINE PixelVectors load_pixels(const float* layer) {
    PixelVectors v;
    hn::LoadInterleaved3(PixelLanes(), layer, v.x, v.y, v.z);
    return v;
}

HWY_INLINE PixelFloats sum_of_products(const PixelVectors& a, const PixelVectors& b) {
    return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

HWY_INLINE auto are_finite(const PixelVectors& v) {
    return hn::And(hn::And(hn::IsFinite(v.x), hn::IsFinite(v.y)), hn::IsFinite(v.z));
}

/// Pixels where nothing was hit, by position and depth.
HWY_INLINE auto are_background(const PixelLayers& layers, const PixelVectors& p, size_t at) {
    const PixelLanes d;
    const auto zero = hn::Zero(d), miss = hn::Set(d, kMiss);
    const auto is_zero = hn::And(hn::And(hn::Eq(p.x, zero), hn::Eq(p.y, zero)), hn::Eq(p.z, zero));
    const auto is_far = hn::Or(hn::Or(hn::Ge(hn::Abs(p.x), miss), hn::Ge(hn::Abs(p.y), miss)), hn::Ge(hn::Abs(p.z), miss));
    const auto none = hn::Or(is_zero, is_far);
    return layers.depth ? hn::Or(none, hn::Not(hn::Lt(hn::LoadU(d, layers.depth + at), miss))) : none;
}

/// Validity of pixels `at` and on, a vector of them. The first reason that holds is the one told, so the last comes first here.
HWY_INLINE Codes validities(const PixelLayers& layers, const ClassifySettings& settings, size_t at) {
    const PixelLanes d;
    const CodeLanes di;
    const PixelVectors p = load_pixels(layers.position + 3 * at), n = load_pixels(layers.normal + 3 * at);
    const PixelVectors to_eye{hn::Sub(hn::Set(d, settings.eye.x), p.x), hn::Sub(hn::Set(d, settings.eye.y), p.y),
                              hn::Sub(hn::Set(d, settings.eye.z), p.z)};
    const PixelFloats length2 = sum_of_products(n, n);
    const auto is_shorter = [&](float length) { return hn::Lt(length2, hn::Set(d, length * length)); };
    const Codes rule = hn::PromoteTo(di, hn::LoadU(RuleLanes(), layers.rule + at));

    Codes code = hn::Zero(di);
    const auto tell = [&](auto where, Validity reason) {
        code = hn::IfThenElse(hn::RebindMask(di, where), hn::Set(di, static_cast<int32_t>(reason)), code);
    };
    tell(hn::Not(hn::Gt(sum_of_products(n, to_eye), hn::Zero(d))), Validity::back_facing);
    tell(hn::Lt(rule, hn::Zero(di)), Validity::unassigned);
    tell(is_shorter(settings.min_normal_length), Validity::averaged_normal);
    tell(is_shorter(kZeroNormal), Validity::zero_normal);
    tell(hn::Not(hn::And(are_finite(p), are_finite(n))), Validity::not_finite);
    tell(are_background(layers, p, at), Validity::background);
    return code;
}

/// The first `count` of these pixels; neighbours are mostly alike.
HWY_INLINE void count_pixels(Codes code, const int16_t* rule, size_t count, PixelCounts& counts) {
    const CodeLanes di;
    const RuleLanes d_rule;
    const auto used = hn::FirstN(di, count), valid = hn::And(hn::Eq(code, hn::Zero(di)), used);
    const size_t shaded = hn::CountTrue(di, valid);
    counts.validity[0] += shaded;
    for (int reason = 1; shaded < count && reason < kValidityCount; ++reason)
        counts.validity[static_cast<size_t>(reason)] += hn::CountTrue(di, hn::And(hn::Eq(code, hn::Set(di, reason)), used));
    if (shaded == 0) return;
    if (rule[0] >= 0 && hn::AllTrue(d_rule, hn::Eq(hn::LoadU(d_rule, rule), hn::Set(d_rule, rule[0])))) {
        counts.rule[static_cast<size_t>(rule[0])] += shaded;
        return;
    }
    HWY_ALIGN int32_t codes[hn::MaxLanes(CodeLanes())];
    hn::Store(code, di, codes);
    for (size_t i = 0; i < count; ++i)
        if (codes[i] == 0) ++counts.rule[static_cast<size_t>(rule[i])];
}

/// One vector of pixels, `count` of them in use.
HWY_INLINE void classify_vector(const PixelLayers& layers, const ClassifySettings& settings, size_t at, size_t count,
                                Validity* validity, PixelCounts& counts) {
    const Codes code = validities(layers, settings, at);
    hn::StoreU(hn::DemoteTo(ByteLanes(), code), ByteLanes(), reinterpret_cast<uint8_t*>(validity));
    count_pixels(code, layers.rule + at, count, counts);
}

/// The last pixels, fewer than a vector's, by way of copies that are long enough.
void classify_rest(const PixelLayers& layers, const ClassifySettings& settings, size_t at, std::span<Validity> validity,
                   PixelCounts& counts) {
    constexpr size_t kLanes = hn::MaxLanes(PixelLanes());
    float position[3 * kLanes] = {}, normal[3 * kLanes] = {}, depth[kLanes] = {};
    int16_t rule[kLanes] = {};
    Validity found[kLanes];
    const size_t count = validity.size();
    std::copy_n(layers.position + 3 * at, 3 * count, position), std::copy_n(layers.normal + 3 * at, 3 * count, normal);
    std::copy_n(layers.rule + at, count, rule);
    if (layers.depth) std::copy_n(layers.depth + at, count, depth);
    classify_vector({position, normal, layers.depth ? depth : nullptr, rule}, settings, 0, count, found, counts);
    std::copy_n(found, count, validity.begin());
}

void classify_pixels(const PixelLayers& layers, const ClassifySettings& settings, std::span<Validity> validity,
                     PixelCounts& counts) {
    const size_t lanes = hn::Lanes(PixelLanes()), whole = validity.size() / lanes * lanes;
    for (size_t at = 0; at < whole; at += lanes) classify_vector(layers, settings, at, lanes, validity.data() + at, counts);
    if (whole < validity.size()) classify_rest(layers, settings, whole, validity.subspan(whole), counts);
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(classify_pixels);

void classify(const PixelLayers& layers, const ClassifySettings& settings, std::span<Validity> validity, PixelCounts& counts) {
    HWY_DYNAMIC_DISPATCH(classify_pixels)(layers, settings, validity, counts);
}

}  // namespace burnish
#endif
