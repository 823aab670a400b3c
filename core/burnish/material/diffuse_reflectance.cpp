#include <burnish/material/diffuse_reflectance.h>

#include <burnish/material/albedo.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr int kSteps = 64;
constexpr float kLeastCos = 0.0175f;  // 89 degrees, see kSteepestCheck_deg

/// Of all lobes; the mean over azimuths where one is anisotropic.
Color3f mean_albedo(const std::vector<LobeParameters>& lobes, float cos_o) {
    const float sin_o = std::sqrt(1 - cos_o * cos_o);
    Color3f sum(0, 0, 0);
    for (const LobeParameters& lobe : lobes) {
        const int azimuths = lobe.mx == lobe.my ? 1 : 4, samples = 4096 / azimuths;
        for (int i = 0; i < azimuths; ++i) {
            const float phi = kPi * (static_cast<float>(i) + 0.5f) / static_cast<float>(azimuths);
            const Vec3f wo(sin_o * std::cos(phi), sin_o * std::sin(phi), cos_o);
            sum += directional_albedo(lobe, wo, samples) / static_cast<float>(azimuths);
        }
    }
    return sum;
}

}  // namespace

DiffuseReflectance::DiffuseReflectance(const Material& material) : m_by_view{material.kd} {
    if (!material.kd_coupled || material.kd == Color3f(0, 0, 0) || material.lobes.empty()) return;
    m_by_view.clear();
    for (int i = 0; i <= kSteps; ++i) {
        const float cos_o = std::clamp(static_cast<float>(i) / kSteps, kLeastCos, 1.0f);
        const Color3f taken = mean_albedo(material.lobes, cos_o);
        const auto left = [](float albedo) { return std::max(1 - albedo, 0.0f); };
        m_by_view.push_back(material.kd * Color3f(left(taken.x), left(taken.y), left(taken.z)));
    }
}

Color3f DiffuseReflectance::at(float cos_o) const {
    if (!depends_on_view()) return m_by_view.front();
    const float place = std::clamp(cos_o, 0.0f, 1.0f) * kSteps;
    const auto low = std::min(static_cast<size_t>(place), static_cast<size_t>(kSteps - 1));
    const float t = place - static_cast<float>(low);
    return m_by_view[low] * (1 - t) + m_by_view[low + 1] * t;
}

}  // namespace burnish
