#include <burnish/factor/factor_guide.h>

#include <burnish/material/lobe.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/sequence.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float knot(int i) { return static_cast<float>(i) / (FactorGuide::kKnots - 1); }

/// The mean direction of one lobe times what it reflects, seen from wo; local.
Vec3f mean_reflection(const LobeParameters& parameters, const Vec3f& wo) {
    constexpr uint32_t kPoints = 4096, kSeed = 1;
    return visit_lobe(parameters, [&](const auto& lobe) {
        Imath::V3d sum(0, 0, 0);
        for (uint32_t i = 0; i < kPoints; ++i) {
            const Vec3f wi = lobe.sample(wo, owen_sobol(i, kSeed));
            const float pdf = lobe.pdf(wo, wi), cosine = wi.z * lobe.side_sign;
            if (pdf > 0 && cosine > 0) sum += Imath::V3d(wi) * static_cast<double>(luminance(lobe.eval(wo, wi)) * cosine / pdf);
        }
        return Vec3f(sum / kPoints) * luminance(parameters.tint) * parameters.strength;
    });
}

}  // namespace

FactorGuide::FactorGuide() {
    for (int i = 0; i < kKnots; ++i) towards_n[i] = knot(i), towards_r[i] = 1;
}

FactorGuide FactorGuide::of(const Material& material) {
    FactorGuide guide;
    for (int i = 0; i < kKnots; ++i) {
        const float c = std::clamp(knot(i), 1e-3f, 1 - 1e-4f), s = std::sqrt(1 - c * c);
        Vec3f mean(0, 0, 0);
        for (const LobeParameters& lobe : material.lobes) mean += mean_reflection(lobe, {s, 0, c});
        const float length = mean.length();
        if (length > 0) guide.towards_n[i] = mean.z / length, guide.towards_r[i] = -mean.x / (length * s);
    }
    return guide;
}

Vec3f FactorGuide::reflection(const DirectionPair& pair) const {
    const float c = std::clamp(pair.a.dot(pair.b), 0.0f, 1.0f), at = c * (kKnots - 1);
    const int low = std::min(static_cast<int>(at), kKnots - 2);
    const float part = at - static_cast<float>(low);
    const auto along = [&](const std::array<float, kKnots>& curve) {
        return curve[low] + (curve[low + 1] - curve[low]) * part;
    };
    const Vec3f r = pair.a * along(towards_n) + (pair.a * pair.a.dot(pair.b) - pair.b) * along(towards_r);
    return r / std::max(r.length(), 1e-6f);
}

}  // namespace burnish
