#include <burnish/surface/collect.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/surface/collect.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void collect_pixels(const Validity* validity, const int16_t* rules, int rule, size_t first, size_t count,
                    std::vector<uint32_t>& pixels) {
    const hn::ScalableTag<int32_t> d;
    const hn::RebindToUnsigned<decltype(d)> d_pixel;
    const hn::Rebind<uint8_t, decltype(d)> d_validity;
    const hn::Rebind<int16_t, decltype(d)> d_rule;
    const size_t lanes = hn::Lanes(d), end = first + count;
    size_t found = pixels.size(), at = first;
    pixels.resize(found + count + lanes);  // a whole vector may be stored behind the last
    for (; at + lanes <= end; at += lanes) {
        const auto code = hn::PromoteTo(d, hn::LoadU(d_validity, reinterpret_cast<const uint8_t*>(validity + at)));
        const auto worn = hn::PromoteTo(d, hn::LoadU(d_rule, rules + at));
        const auto wanted = hn::And(hn::Eq(code, hn::Zero(d)), hn::Eq(worn, hn::Set(d, rule)));
        found += hn::CompressStore(hn::Iota(d_pixel, static_cast<uint32_t>(at)), hn::RebindMask(d_pixel, wanted), d_pixel,
                                   pixels.data() + found);
    }
    for (; at < end; ++at)
        if (validity[at] == Validity::valid && rules[at] == rule) pixels[found++] = static_cast<uint32_t>(at);
    pixels.resize(found);
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(collect_pixels);

void collect(const Validity* validity, const int16_t* rules, int rule, size_t first, size_t count,
             std::vector<uint32_t>& pixels) {
    HWY_DYNAMIC_DISPATCH(collect_pixels)(validity, rules, rule, first, count, pixels);
}

}  // namespace burnish
#endif
