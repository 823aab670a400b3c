// Directional albedo of lobes: how much light a lobe returns, and the check that no material creates energy.
#pragma once

#include <burnish/material/parameters.h>

#include <string>
#include <vector>

namespace burnish {

/// rho(wo) = integral of f(wo, wi) |cos theta_i| dwi over the lobe's side, tint and strength included, by quasi-Monte-Carlo
/// importance sampling with `samples` points (relative error about 1e-3 at 4096). wo: local, unit, wo.z > 0.
Color3f directional_albedo(const LobeParameters& lobe, const Vec3f& wo, int samples = 4096);

/// Steepest view that check_energy tries: Kurt with alpha > 0 has no bound at the horizon itself, where no pixel looks from.
inline constexpr float kSteepestCheck_deg = 89.0f;

/// The largest directional albedo of the whole material (kd and all lobes, worst channel) over wo, and where it is.
struct EnergyCheck {
    float max_albedo = 0.0f;
    float theta_o_deg = 0.0f;
};
EnergyCheck check_energy(const Material& material);

}  // namespace burnish
