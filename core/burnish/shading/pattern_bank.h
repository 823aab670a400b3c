// The `regular` patterns a lobe needs: one, or one per step of anisotropy where that comes from a layer.
#pragma once

#include <burnish/material/parameters.h>
#include <burnish/sampling/lobe_pattern.h>

#include <vector>

namespace burnish {

class PatternBank {
public:
    PatternBank(const LobeParameters& lobe, const EstimatorSettings& settings);

    /// The pattern for a lobe of these widths: nearest quarter octave of mx/my.
    const LobePattern& at(float mx, float my) const;

private:
    std::vector<LobePattern> m_patterns;
};

}  // namespace burnish
