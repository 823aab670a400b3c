// A lobe under one of the few-sample estimators: its taps at any point, with the albedo they add up to put right.
#pragma once

#include <burnish/shading/albedo_ratio.h>
#include <burnish/shading/pattern_bank.h>
#include <burnish/shading/tap.h>

#include <functional>
#include <span>

namespace burnish {

class TapRule {
public:
    /// The level that filters so widely: over a solid angle in steradian, for `preconvolved` over a Gaussian's width in radian.
    using LevelOf = std::function<float(float size)>;

    /// For `regular`, `filtered_importance` and `preconvolved`.
    TapRule(const LobeParameters& lobe, const EstimatorSettings& settings, LevelOf level_of);

    /// Taps of a lobe of these widths: the same number everywhere unless the anisotropy comes from a layer.
    int tap_count(float mx, float my) const;
    /// Writes the taps, tap_count(point.mx, point.my) of them. The point's frame, ng and scale play no part.
    void operator()(const ShadingPoint& point, std::span<Tap> taps) const;

private:
    void plain_taps(const ShadingPoint& point, std::span<Tap> taps) const;

    LobeParameters m_lobe;
    EstimatorSettings m_settings;
    LevelOf m_level_of;
    PatternBank m_patterns;
    AlbedoRatio m_ratio;
};

}  // namespace burnish
