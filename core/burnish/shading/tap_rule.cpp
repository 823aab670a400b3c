#include <burnish/shading/tap_rule.h>

#include <burnish/material/lobe.h>
#include <burnish/shading/filtered_importance.h>
#include <burnish/shading/preconvolved.h>
#include <burnish/shading/regular.h>

namespace burnish {

TapRule::TapRule(const LobeParameters& lobe, const EstimatorSettings& settings, LevelOf level_of)
    : m_lobe(lobe), m_settings(settings), m_level_of(std::move(level_of)), m_patterns(lobe, settings) {
    if (!settings.albedo_correction) return;
    m_ratio = AlbedoRatio(lobe, [this](const ShadingPoint& point) {
        std::vector<Tap> taps(tap_count(point.mx, point.my));
        plain_taps(point, taps);
        Color3f sum(0, 0, 0);
        for (const Tap& tap : taps) sum += tap.weight;
        return sum;
    });
}

int TapRule::tap_count(float mx, float my) const {
    if (m_settings.kind != EstimatorKind::regular) return m_settings.samples;
    return static_cast<int>(m_patterns.at(mx, my).size());
}

void TapRule::operator()(const ShadingPoint& point, std::span<Tap> taps) const {
    plain_taps(point, taps);
    const float ratio = m_ratio.at(point);
    for (Tap& tap : taps) tap.weight *= ratio;
}

void TapRule::plain_taps(const ShadingPoint& point, std::span<Tap> taps) const {
    visit_lobe(m_lobe, [&](const auto& prototype) {
        const auto own = prototype.with_widths(point.mx, point.my);
        switch (m_settings.kind) {
            case EstimatorKind::filtered_importance: return importance_taps(own, point, m_level_of, taps);
            case EstimatorKind::preconvolved: return preconvolved_taps(own, point, m_level_of, taps);
            default: regular_taps(own, m_patterns.at(point.mx, point.my), m_settings.quadrature, point, m_level_of, taps);
        }
    });
}

}  // namespace burnish
