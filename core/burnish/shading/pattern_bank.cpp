#include <burnish/shading/pattern_bank.h>

#include <burnish/material/lobe.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int kStepsPerOctave = 4, kOctaves = 6;  // covers aspects 1:64 to 64:1

}  // namespace

PatternBank::PatternBank(const LobeParameters& parameters, const EstimatorSettings& settings) {
    const auto make = [&](float aspect) {
        return visit_lobe(parameters, [&](const auto& lobe) {
            return regular_pattern(settings.pattern, settings.samples, aspect, settings.border,
                                   [&](float xi) { return lobe.border(xi); });
        });
    };
    if (!parameters.per_pixel.anisotropy) {
        m_patterns.push_back(make(parameters.mx / parameters.my));
        return;
    }
    for (int step = -kStepsPerOctave * kOctaves; step <= kStepsPerOctave * kOctaves; ++step)
        m_patterns.push_back(make(std::exp2(static_cast<float>(step) / kStepsPerOctave)));
}

const LobePattern& PatternBank::at(float mx, float my) const {
    if (m_patterns.size() == 1) return m_patterns[0];
    const int step = static_cast<int>(std::lround(kStepsPerOctave * std::log2(mx / my)));
    return m_patterns[std::clamp(step, -kStepsPerOctave * kOctaves, kStepsPerOctave * kOctaves) + kStepsPerOctave * kOctaves];
}

}  // namespace burnish
