#include <burnish/shading/albedo_curve.h>

#include <burnish/material/albedo.h>

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr int kViewAngles = 33;
constexpr int kAlbedoSamples = 1024;  // a point of the curve

}  // namespace

AlbedoCurve::AlbedoCurve(const LobeParameters& lobe) : m_relative_curvature(kViewAngles, 0.0f) {
    const float step = 0.5f * kPi / (kViewAngles - 1);
    std::vector<float> albedo;
    for (int i = 0; i < kViewAngles; ++i) {
        const float theta = std::min(step * static_cast<float>(i), 1.553f);
        albedo.push_back(luminance(directional_albedo(lobe, {std::sin(theta), 0, std::cos(theta)}, kAlbedoSamples)));
    }
    m_typical = albedo[kViewAngles / 2];
    for (size_t i = 1; i + 1 < kViewAngles; ++i)
        m_relative_curvature[i] = std::fabs(albedo[i - 1] - 2 * albedo[i] + albedo[i + 1]) /
                                  (step * step * std::max(albedo[i], 1e-6f * m_typical + 1e-12f));
    m_relative_curvature.front() = m_relative_curvature[1], m_relative_curvature.back() = m_relative_curvature[kViewAngles - 2];
}

float AlbedoCurve::curvature(float cos_o) const {
    const float place = std::acos(std::clamp(cos_o, 0.0f, 1.0f)) / (0.5f * kPi) * (kViewAngles - 1);
    const auto low = std::min(static_cast<size_t>(place), static_cast<size_t>(kViewAngles - 2));
    return std::max(m_relative_curvature[low], m_relative_curvature[low + 1]);
}

}  // namespace burnish
