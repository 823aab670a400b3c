// From a measured spectrum to linear Rec.709: the colour of the reflectance under daylight D65 for the CIE 1931 observer.
//
// D65 is Rec.709's own white, so that a grey spectrum gives a grey colour of the same value and nothing is adapted.
#pragma once

#include <burnish/base/types.h>

#include <vector>

namespace burnish {

class SpectrumColor {
public:
    /// Wavelengths in nm, rising, at least two. Between them the spectrum is linear, beyond them it keeps its end values.
    explicit SpectrumColor(const std::vector<double>& wavelengths);

    /// `values`: one for each wavelength. Channels may be negative: colours more saturated than Rec.709 holds.
    Color3f operator()(const double* values) const;

private:
    std::vector<Imath::V3d> m_weights;
};

}  // namespace burnish
