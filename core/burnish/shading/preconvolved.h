// The `preconvolved` estimator (Bandwidth IV.3.5, after Kautz et al. 2000): importance samples of the lobe, each read in light
// that keeps only the frequencies the lobe lets through.
//
// The light is filtered by a Gaussian of a part of the lobe's own width, the narrower one where its image is long: what that
// takes from the light the lobe would have taken too. Filter and lobe one after the other would be wider than the lobe, so the
// samples follow a lobe narrowed by as much. Where a sample stands for more than the filter, far out in the lobe's tail, it
// reads as wide as that; with many samples nothing but the band is left.
#pragma once

#include <burnish/material/lobe.h>
#include <burnish/sampling/tuned_patterns.h>
#include <burnish/shading/filtered_importance.h>
#include <burnish/shading/lobe_image.h>

#include <span>

namespace burnish {

/// Width of the filter over the lobe's: wider is smoother with few samples and blurs rough lobes (docs/measured.md). Lobes with a
/// long tail have a core narrower by sqrt(2): (1 + r^2 / m^2)^-2 falls like exp(-2 r^2 / m^2).
template <class LobeType>
float passed_width(const LobeType& lobe) {
    return lobe_tail([&](float xi) { return lobe.border(xi); }) == LobeTail::long_tail ? 0.42f : 0.6f;
}

/// Of the width's square, after narrowing: where the image is a hundred times as long as wide, its narrower deviation is rounded up.
inline constexpr float kLeastLeft = 0.5f;

/// Width of the Gaussian that stands for a solid angle; measured, 1 / sqrt(4 pi) would have a disc's own second moment.
inline float footprint_width(float omega) { return 0.42f * std::sqrt(omega); }

/// Writes one tap per sample, taps.size() samples. `level_of(sigma)` gives the level whose lookups are Gaussians `sigma` rad wide.
template <class LobeType, class LevelOf>
void preconvolved_taps(const LobeType& lobe, const ShadingPoint& point, const LevelOf& level_of, std::span<Tap> taps) {
    const float band = passed_width(lobe) * lobe_image(point.wo, point.mx, point.my).minor;
    const Vec2f wider = widening(point.wo, band);
    const auto left = [](float m, float taken) { return std::sqrt(std::max(m * m - taken, kLeastLeft * m * m)); };
    const auto narrowed = lobe.with_widths(left(point.mx, wider.x), left(point.my, wider.y));
    importance_taps(
        narrowed, point, [&](float omega) { return level_of(std::max(band, footprint_width(omega))); }, taps);
}

}  // namespace burnish
