#include <burnish/shading/pattern_bank.h>

#include <burnish/material/lobe.h>

#include <algorithm>
#include <cmath>

namespace burnish {

float PatternBank::Steps::value(int i) const {
    return first * std::exp2(static_cast<float>(i) / static_cast<float>(per_octave));
}

int PatternBank::Steps::nearest(float value) const {
    if (count == 1) return 0;
    return std::clamp(static_cast<int>(std::lround(std::log2(value / first) * static_cast<float>(per_octave))), 0, count - 1);
}

PatternBank::PatternBank(const LobeParameters& parameters, const EstimatorSettings& settings) {
    const auto make = [&](float mx, float my) {
        return visit_lobe(parameters, [&](const auto& lobe) {
            return regular_pattern(settings.pattern, settings.samples, mx, my, settings.border,
                                   [&](float xi) { return lobe.border(xi); });
        });
    };
    const PerPixel& per_pixel = parameters.per_pixel;
    if (!per_pixel.anisotropy && !per_pixel.roughness) {
        m_patterns = {{make(parameters.mx, parameters.my)}};
        return;
    }
    m_aspects = {parameters.mx / parameters.my, 1, 1}, m_widths = {std::sqrt(parameters.mx * parameters.my), 1, 1};
    if (per_pixel.anisotropy) m_aspects = {1.0f / 64, 4, 4 * 12 + 1};
    if (per_pixel.roughness) m_widths = {1.0f / 64, 8, 8 * 6 + 1};
    for (int i = 0; i < m_aspects.count; ++i) {
        const float aspect = m_aspects.value(i), half_aspect = std::sqrt(aspect);
        const bool tuned = chosen_kind(settings.pattern, settings.samples, aspect, settings.border) == PatternKind::tuned;
        std::vector<LobePattern>& widths = m_patterns.emplace_back();
        for (int j = 0; j < (tuned ? m_widths.count : 1); ++j)
            widths.push_back(make(m_widths.value(j) * half_aspect, m_widths.value(j) / half_aspect));
    }
}

const LobePattern& PatternBank::at(float mx, float my) const {
    const std::vector<LobePattern>& widths = m_patterns[m_aspects.nearest(mx / my)];
    return widths.size() == 1 ? widths[0] : widths[m_widths.nearest(std::sqrt(mx * my))];
}

}  // namespace burnish
