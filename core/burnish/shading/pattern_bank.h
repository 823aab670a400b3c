// The `regular` patterns a lobe needs: one, or one per step of anisotropy and of width where those come from layers.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/sampling/lobe_pattern.h>

#include <vector>

namespace burnish {

class PatternBank {
public:
    PatternBank(const LobeParameters& lobe, const EstimatorSettings& settings);

    /// The pattern for a lobe of these widths: nearest quarter octave of mx/my, nearest eighth of sqrt(mx my).
    const LobePattern& at(float mx, float my) const;

private:
    /// Values `per_octave` steps to an octave, from `first` on.
    struct Steps {
        float first = 1;
        int per_octave = 1, count = 1;
        float value(int i) const;
        int nearest(float value) const;
    };

    Steps m_aspects, m_widths;
    std::vector<std::vector<LobePattern>> m_patterns;  // by aspect, by width: one width where the pattern does not depend on it
};

}  // namespace burnish
