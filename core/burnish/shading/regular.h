// The `regular` estimator: a fixed pattern of half vectors, each lookup filtered over the solid angle it stands for.
//
//     L = sum_i Li(wi) a_i / norm,   wi = reflect(wo, h_i),   Omega_i = 4 (wo . h_i) Omega_h,i
//
// Omega_h = area mx my cos^3 theta_h is the pattern cell's solid angle about h, and 4 (wo . h) its stretch by reflection. In a and
// norm, Omega stands multiplied by the sample's weight, 1 in all patterns but the tuned ones.
#pragma once

#include <burnish/material/lobe.h>
#include <burnish/sampling/lobe_pattern.h>
#include <burnish/shading/shading_point.h>
#include <burnish/shading/tap.h>

#include <span>

namespace burnish {

/// Writes a tap per sample of the pattern, under one of the three quadratures:
///     half_vector      a = f cos Omega              norm = sum of D(h) Omega_h     (Regular 17-18)
///     energy           a = f cos^2 Omega            norm = sum of p cos Omega                 (Walkthrough 4.24)
///     energy_squared   a = f^2 cos^2 Omega / p      norm = sum of f cos Omega                 (Walkthrough 4.25)
/// p is the density of wi when h is drawn from D cos theta_h. `level_of(Omega)` gives the level that filters over Omega;
/// below the horizon it stays what it is at the horizon, where wo . h = cos_o / (2 cos theta_h).
template <class LobeType, class LevelOf>
void regular_taps(const LobeType& lobe, const LobePattern& pattern, Quadrature quadrature, const ShadingPoint& point,
                  const LevelOf& level_of, std::span<Tap> taps) {
    Color3f norm(0, 0, 0);
    for (size_t i = 0; i < pattern.size(); ++i) {
        const PatternSample& s = pattern[i];
        const float sx = s.u * point.mx, sy = s.v * point.my, cos_h = 1 / std::sqrt(1 + sx * sx + sy * sy);
        const Vec3f h = Vec3f(sx, sy, 1) * cos_h;
        const float omega_h = s.area * point.mx * point.my * cos_h * cos_h * cos_h;
        const float D = lobe.D(h), wo_h = point.wo.dot(h);
        const Vec3f wi = lobe.mirrored(h * (2 * wo_h) - point.wo);
        taps[i] = {wi, level_of(4 * std::max(wo_h, point.wo.z / (2 * cos_h)) * omega_h), Color3f(0, 0, 0)};
        if (quadrature == Quadrature::half_vector) norm += Color3f(D * omega_h * s.weight);
        const float cos_i = wi.z * lobe.side_sign;
        if (cos_i <= 0) continue;
        const float omega = 4 * wo_h * omega_h, share = omega * s.weight;
        Color3f weight = lobe.eval(point.wo, wi) * (cos_i * share);
        const float p = D * cos_h / (4 * wo_h);
        if (quadrature == Quadrature::energy) norm += Color3f(p * cos_i * share), weight *= cos_i;
        if (quadrature == Quadrature::energy_squared) norm += weight, weight *= lobe.eval(point.wo, wi) * (cos_i / p);
        taps[i].weight = weight;
    }
    for (size_t i = 0; i < pattern.size(); ++i)
        for (int k = 0; k < 3; ++k) taps[i].weight[k] = norm[k] > 0 ? taps[i].weight[k] / norm[k] : 0.0f;
}

}  // namespace burnish
