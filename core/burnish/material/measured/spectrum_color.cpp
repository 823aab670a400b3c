#include <burnish/material/measured/spectrum_color.h>

#include <algorithm>

namespace burnish {
namespace {

struct Observer {
    double wavelength, x, y, z, d65;
};

constexpr Observer kObserver[] = {
#define CIE_1931(wavelength, x, y, z, d65) {wavelength, x, y, z, d65},
#include <burnish/material/measured/cie_1931.def>
#undef CIE_1931
};

/// Linear Rec.709 of the observer's answer. Source: IEC 61966-2-1, from the primaries and white of ITU-R BT.709.
Imath::V3d rec709(const Observer& at) {
    return Imath::V3d(3.2404542 * at.x - 1.5371385 * at.y - 0.4985314 * at.z,
                      -0.9692660 * at.x + 1.8760108 * at.y + 0.0415560 * at.z,
                      0.0556434 * at.x - 0.2040259 * at.y + 1.0572252 * at.z) *
           at.d65;
}

}  // namespace

SpectrumColor::SpectrumColor(const std::vector<double>& wavelengths) : m_weights(wavelengths.size(), Imath::V3d(0)) {
    Imath::V3d white(0);
    for (const Observer& at : kObserver) {
        const auto above = std::upper_bound(wavelengths.begin(), wavelengths.end(), at.wavelength) - wavelengths.begin();
        const size_t next = std::clamp<size_t>(static_cast<size_t>(above), 1, wavelengths.size() - 1);
        const double first = wavelengths[next - 1], second = wavelengths[next];
        const double share = std::clamp((at.wavelength - first) / (second - first), 0.0, 1.0);
        m_weights[next - 1] += rec709(at) * (1 - share), m_weights[next] += rec709(at) * share;
        white += rec709(at);
    }
    for (Imath::V3d& weight : m_weights) weight /= white;  // by channel: grey stays grey to the last digit
}

Color3f SpectrumColor::operator()(const double* values) const {
    Imath::V3d sum(0);
    for (size_t i = 0; i < m_weights.size(); ++i) sum += m_weights[i] * values[i];
    return Color3f(Vec3f(sum));
}

}  // namespace burnish
