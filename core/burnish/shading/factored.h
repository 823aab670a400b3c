// The `factored` estimator: what a material reflects of distant light, all its lobes and all lamps at once, as a product of a few maps
// over directions (factors.h), made beforehand. No integral is left at the pixel, at the price of a fixed error that no number of
// lookups makes smaller.
//
// Maps know the light's axes alone: however the light is turned, scaled or tinted, they stay. Suns, whose highlights are sharper than
// maps, are left to disc_light.h, as other estimators do; maps of files hold them.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/light/environment.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/estimator.h>
#include <burnish/shading/factor_shading.h>

#include <memory>
#include <vector>

namespace burnish {

struct ShadedBatch;

/// Throws Error(bad_argument) where no maps can stand for the material: as require_factorable, and where layers tint or weigh some of
/// its lobes alone.
void require_factored(const Material& material);

bool can_be_factored(const Material& material);

/// Maps of a material under a light. Throws as require_factored.
Factors factored_light(const Material& material, const Environment& light, const EstimatorSettings& settings,
                       const Progress& progress = {});

/// A material under distant light by its maps.
class FactoredShader {
public:
    /// By maps of the material under this light, however it was turned and scaled since. The light must outlive the shader. Throws as
    /// require_factored and FactorShading.
    FactoredShader(const Material& material, const Environment& light, const Factors& factors);

    /// Sets overlay and samples; out has the size of the batch.
    void shade(const SurfaceBatch& batch, ShadedBatch& out) const;

private:
    FactorShading m_shading;
    PerPixel m_layers;                     // tint and weight that all lobes take
    std::vector<LobeParameters> m_sunlit;  // lobes that suns are to be added for
    const Environment& m_light;
};

}  // namespace burnish
