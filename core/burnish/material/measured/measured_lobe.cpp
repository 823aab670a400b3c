#include <burnish/material/measured/measured_lobe.h>

#include <burnish/material/measured/half_difference.h>
#include <burnish/material/lobes/microfacet.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kBaseShare = 0.1f, kLeastCosine = 0.26f;  // of 75 degrees
constexpr float kDegree = kPi / 180;
constexpr float kSlopeViews[] = {5, 15, 25, 35, 45, 55, 65};  // theta_d, degrees
constexpr float kCoreShare = 0.8f, kCoreRadius = 0.486f;      // xi, and its border in both Beckmann's lobe and GGX's, nearly

}  // namespace

Color3f diffuse_base(const MeasuredBrdf& measured) {
    std::vector<float> values[3];
    for (const BrdfSample& sample : measured.samples())
        if (std::min(sample.wo.z, sample.wi.z) > kLeastCosine)
            for (int c = 0; c < 3; ++c) values[c].push_back(sample.f[c]);
    Color3f kd(0);
    if (values[0].empty()) return kd;
    for (int c = 0; c < 3; ++c) {
        const auto low = values[c].begin() + static_cast<std::ptrdiff_t>(kBaseShare * static_cast<float>(values[c].size()));
        std::nth_element(values[c].begin(), low, values[c].end());
        kd[c] = std::min(*low * kPi, 1.0f);
    }
    return kd;
}

MeasuredLobe::MeasuredLobe(std::shared_ptr<const MeasuredBrdf> measured, Side side, const Color3f& kd)
    : m_measured(std::move(measured)), m_side(side), m_kd(kd) {
    const bool isotropic = m_measured->is_isotropic();
    m_own.x = width_at(0), m_own.y = isotropic ? m_own.x : width_at(kPi / 2);
    m_profile = SlopeProfile([&](double rho) {
        double sum = 0;
        for (int i = 0; i < (isotropic ? 1 : 8); ++i) {
            const float phi = kPi * static_cast<float>(i) / 8, x = m_own.x * std::cos(phi), y = m_own.y * std::sin(phi);
            sum += slope_density(rho * std::hypot(x, y), std::atan2(y, x));
        }
        return sum;
    });
    const auto luminance_of = [&](const Vec3f& wo, const Vec3f& wi) { return luminance(eval(wo, wi)) * wi.z; };
    m_sampler = std::make_unique<HalfVectorSampler>(luminance_of, m_own, isotropic);
}

Color3f MeasuredLobe::eval(const Vec3f& wo, const Vec3f& wi) const {
    const Color3f f = m_measured->eval(wo, m_side == Side::transmission ? Vec3f(wi.x, wi.y, -wi.z) : wi) - m_kd / kPi;
    return {std::max(f.x, 0.0f), std::max(f.y, 0.0f), std::max(f.z, 0.0f)};
}

/// Proportional to the density of slopes D cos^4 that a microfacet lobe of this f would have: f 4 cos_i cos_o cos^4, the mean over
/// some views. With phi_d = 90 degrees both directions are equally far from the normal, and above the surface.
double MeasuredLobe::slope_density(double slope, float phi) const {
    const float theta_h = static_cast<float>(std::atan(slope)), cos_h = std::cos(theta_h);
    double sum = 0;
    for (const float theta_d : kSlopeViews) {
        const DirectionPair pair = directions({theta_h, phi, theta_d * kDegree, kPi / 2});
        sum += static_cast<double>(luminance(eval(pair.wo, pair.wi)) * pair.wo.z * pair.wi.z);
    }
    return sum * std::pow(static_cast<double>(cos_h), 4);
}

float MeasuredLobe::width_at(float phi) const {
    const SlopeProfile absolute([&](double rho) { return slope_density(kMinWidth * rho, phi); });
    return std::clamp(kMinWidth * absolute.border(kCoreShare) / kCoreRadius, kMinWidth, 1.0f);
}

}  // namespace burnish
