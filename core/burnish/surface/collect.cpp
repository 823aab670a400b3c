#include <burnish/surface/collect.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "burnish/surface/collect.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace burnish {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Pixels [at, end) to `pixels`, with room for a vector more; returns how many there are.
HWY_INLINE size_t collect_row(const WornRules& frame, size_t at, size_t end, int rule, uint32_t* pixels) {
    const hn::ScalableTag<int32_t> d;
    const hn::RebindToUnsigned<decltype(d)> d_pixel;
    const hn::Rebind<uint8_t, decltype(d)> d_validity;
    const hn::Rebind<int16_t, decltype(d)> d_rule;
    size_t found = 0;
    for (; at + hn::Lanes(d) <= end; at += hn::Lanes(d)) {
        const auto code = hn::PromoteTo(d, hn::LoadU(d_validity, reinterpret_cast<const uint8_t*>(frame.validity + at)));
        const auto worn = hn::PromoteTo(d, hn::LoadU(d_rule, frame.rule + at));
        const auto wanted = hn::And(hn::Eq(code, hn::Zero(d)), hn::Eq(worn, hn::Set(d, rule)));
        const auto listed = hn::Compress(hn::Iota(d_pixel, static_cast<uint32_t>(at)), hn::RebindMask(d_pixel, wanted));
        hn::StoreU(listed, d_pixel, pixels + found);
        found += hn::CountTrue(d, wanted);
    }
    for (; at < end; ++at)
        if (frame.validity[at] == Validity::valid && frame.rule[at] == rule) pixels[found++] = static_cast<uint32_t>(at);
    return found;
}

void collect_pixels(const WornRules& frame, const Window& window, int rule, std::vector<uint32_t>& pixels) {
    const size_t width = static_cast<size_t>(window.width), height = static_cast<size_t>(window.height);
    size_t found = pixels.size(), at = static_cast<size_t>(window.y) * frame.width + static_cast<size_t>(window.x);
    pixels.resize(found + width * height + hn::Lanes(hn::ScalableTag<uint32_t>()));
    for (size_t row = 0; row < height; ++row, at += frame.width)
        found += collect_row(frame, at, at + width, rule, pixels.data() + found);
    pixels.resize(found);
}

}  // namespace HWY_NAMESPACE
}  // namespace burnish
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace burnish {

HWY_EXPORT(collect_pixels);

void collect(const WornRules& frame, const Window& window, int rule, std::vector<uint32_t>& pixels) {
    HWY_DYNAMIC_DISPATCH(collect_pixels)(frame, window, rule, pixels);
}

}  // namespace burnish
#endif
