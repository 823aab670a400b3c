// The predictions `correlated` and `source`: wavelet bandwidths of light and lobe, along a few directions, through the operators.
//
// Directions are the cells of a regular pattern over the lobe. Each has what the operators need: nu_l, the largest bandwidth
// of the light within the cell, and nu_rho of the lobe; and a weight, the light that comes through it:
//
//     nu = sum_i lambda_i nu_i / sum_i lambda_i,   lambda_i = L_i f_i cos_i Omega_i          (Bandwidth IV.6)
//
// Bright discs, which the filtered light lacks, are directions of their own. As the operators are linear but for the clamp, two
// means say all of a pixel, of nu_l and of min(nu_rho, nu_l), whatever its curvature.
#pragma once

#include <burnish/frequency/light_bandwidth.h>
#include <burnish/light/environment.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/density.h>
#include <burnish/shading/predictor.h>
#include <burnish/surface/surface_batch.h>

#include <memory>
#include <span>
#include <vector>

namespace burnish {

/// Of one pixel; bandwidths in cycles per radian of the reflected direction.
struct PathBandwidth {
    float nu_l = 0;     // of the light, mean over the directions
    float nu_kept = 0;  // what the lobe lets through: mean of min(nu_rho, nu_l)

    // Bounds of the variance of one sample of the integrand, chi = L f, up to a constant:
    float variance = 0;               // sum (nu_l + nu_rho) chi^2 Omega, of the light as it is (IV.9)
    float preconvolved_variance = 0;  // sum 2 nu_rho chi^2 Omega, of light filtered to the lobe's bandwidth (IV.10)
};

class WaveletPrediction {
public:
    static constexpr int kDefaultDirections = 1;  // per lobe: more make no difference (docs/measured.md)

    /// The environment must outlive this. `shared`: the light's bandwidth, where it is at hand already. settings.prediction
    /// `curvature` counts as `correlated`; settings.directions is met as nearly as patterns allow.
    WaveletPrediction(const Material& material, const Environment& light, const DensitySettings& settings,
                      std::shared_ptr<const LightBandwidth> shared = {});

    /// For shading plans, safety included: nu_a such that two cells fit into a period of nu_kept (`correlated`) or of
    /// (nu_l + nu_kept) / 2 (`source`). Thread-safe; the same pixel gives the same bits in whatever batch it comes.
    void predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const;
    /// All there is to know of each pixel, safety left out.
    void predict(const SurfaceBatch& batch, std::span<PathBandwidth> paths) const;

private:
    struct LobeDirections;
    std::vector<std::shared_ptr<const LobeDirections>> m_lobes;
    const Environment& m_light;
    std::shared_ptr<const LightBandwidth> m_bandwidth;
    DensitySettings m_settings;
};

}  // namespace burnish
