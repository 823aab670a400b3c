#include <burnish/material/albedo.h>
#include <burnish/material/lobe.h>
#include <burnish/sampling/sequence.h>

#include <algorithm>

namespace burnish {

namespace {

Vec3f direction(float theta, float phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Albedo of all lobes of both sides together, and of the diffuse part.
Color3f total_albedo(const Material& material, const Vec3f& wo, int samples) {
    Color3f lobes(0, 0, 0);
    for (const LobeParameters& lobe : material.lobes) lobes += directional_albedo(lobe, wo, samples);
    const auto left = [&](float albedo) { return material.kd_coupled ? std::max(1 - albedo, 0.0f) : 1.0f; };
    return lobes + material.kd * Color3f(left(lobes.x), left(lobes.y), left(lobes.z));
}

bool turns_with_azimuth(const Material& material) {
    return std::ranges::any_of(material.lobes, [](const LobeParameters& lobe) { return lobe.mx != lobe.my; });
}

}  // namespace

Color3f directional_albedo(const LobeParameters& lobe, const Vec3f& wo, int samples) {
    const float c = std::cos(lobe.rotation), s = std::sin(lobe.rotation);
    const Vec3f wo_lobe(c * wo.x + s * wo.y, c * wo.y - s * wo.x, wo.z);
    const Imath::V3d sum = visit_lobe(lobe, [&](const auto& f) {
        Imath::V3d total(0);
        for (int i = 0; i < samples; ++i) {
            const Vec3f wi = f.sample(wo_lobe, hammersley(static_cast<uint32_t>(i), static_cast<uint32_t>(samples)));
            const float pdf = f.pdf(wo_lobe, wi);
            if (pdf > 0) total += Imath::V3d(f.eval(wo_lobe, wi) * (std::abs(wi.z) / pdf));
        }
        return total;
    });
    return lobe.tint * Color3f(Vec3f(sum / samples)) * lobe.strength;
}

EnergyCheck check_energy(const Material& material) {
    constexpr int kSamples = 1024, kStep_deg = 4;
    const int azimuths = turns_with_azimuth(material) ? 8 : 1;
    EnergyCheck worst;
    for (int step_deg = 0; step_deg < 90 + kStep_deg; step_deg += kStep_deg) {
        const float theta_deg = std::min(static_cast<float>(step_deg), kSteepestCheck_deg);
        for (int i = 0; i < azimuths; ++i) {
            const Vec3f wo = direction(theta_deg * kPi / 180, kPi * static_cast<float>(i) / static_cast<float>(azimuths));
            const Color3f albedo = total_albedo(material, wo, kSamples);
            const float largest = std::max({albedo.x, albedo.y, albedo.z});
            if (largest > worst.max_albedo) worst = {largest, theta_deg};
        }
    }
    return worst;
}

}  // namespace burnish
