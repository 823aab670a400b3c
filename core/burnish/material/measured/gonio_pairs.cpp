#include <burnish/material/measured/gonio_pairs.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr double kLeastCosine = 0.0087;  // of 89.5 degrees

Vec3f direction(double theta, double phi) {
    const double sine = std::sin(theta);
    return {static_cast<float>(sine * std::cos(phi)), static_cast<float>(sine * std::sin(phi)),
            static_cast<float>(std::cos(theta))};
}

}  // namespace

std::optional<BrdfSample> gonio_sample(const GonioRow& row, bool transfer) {
    const double cos_i = std::cos(row.theta_i), cos_o = std::abs(std::cos(row.theta_o));
    if (cos_i < kLeastCosine || cos_o < kLeastCosine) return std::nullopt;
    Color3f f = transfer ? row.value / static_cast<float>(cos_o) : row.value;
    for (int c = 0; c < 3; ++c) f[c] = std::clamp(f[c], 0.0f, kLargestReflectance);
    const Vec3f incident = direction(row.theta_i, row.phi_i), outgoing = direction(row.theta_o, row.phi_o);
    if (outgoing.z < 0) return BrdfSample{incident, outgoing, f};
    return BrdfSample{outgoing, incident, f};
}

}  // namespace burnish
