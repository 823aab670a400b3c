// How a lobe's albedo changes with the view: what of an overlay varies under any light.
#pragma once

#include <burnish/material/parameters.h>

#include <vector>

namespace burnish {

/// Of one lobe, in its plane of incidence.
class AlbedoCurve {
public:
    explicit AlbedoCurve(const LobeParameters& lobe);

    /// Luminance of the albedo half way between the normal and the horizon.
    float typical() const { return m_typical; }
    /// |A'' / A| by the angle of view, per radian^2; the larger one of the angles about it.
    float curvature(float cos_o) const;

private:
    float m_typical = 0;
    std::vector<float> m_relative_curvature;  // by angle of view, 0 to 90 degrees
};

}  // namespace burnish
