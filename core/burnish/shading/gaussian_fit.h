// A few spherical Gaussians that together stand for a lobe seen from one direction: the heart of the `fitted` estimator.
//
//     f(wo, wi) |cos theta_i|  ~  sum_i weight_i K(wi . d_i, sigma_i),     K(c, sigma) = exp((c - 1) / sigma^2) / norm
//
// Each Gaussian is one lookup of the light's Gaussian stack, so the overlay becomes sum_i weight_i L(d_i, sigma_i). Directions
// and widths are found by Levenberg-Marquardt, the weights, linear, by least squares within every step (variable projection,
// Golub & Pereyra 1973, in Kaufman's simplification), for the luminance; then the weights once more for each channel.
#pragma once

#include <burnish/shading/lobe_quadrature.h>

#include <vector>

namespace burnish {

/// One Gaussian. It looks along reflect(wo, h), h ~ (sx, sy, 1): slopes follow the lobe when the view turns.
struct GaussianTap {
    float sx, sy;
    float log_sigma;  // ln of the width, rad
    Color3f weight;   // integral of its share of the lobe
};

/// Direction of a tap, local frame, mirrored above the surface for transmission lobes; may lie below the horizon.
Vec3f tap_direction(const Vec3f& wo, float sx, float sy);

/// Improves `taps` in place, from where they are, in at most `steps` steps; sets all weights.
/// in_plane  sy stays 0: for a quadrature of half the lobe.
/// Returns the residual: root mean square of the luminance's error over the root mean square of the lobe, over solid angle,
/// both as blurred as the quadrature is.
float fit_gaussians(const LobeQuadrature& lobe, const Vec3f& wo, bool in_plane, int steps, std::vector<GaussianTap>& taps);

/// The same residual of taps as they are, weights too.
float residual_of(const LobeQuadrature& lobe, const Vec3f& wo, const std::vector<GaussianTap>& taps);

}  // namespace burnish
