// Predicts how fast an overlay varies under lights that are near: as under distant light (bend_sums.h), but the lights say ray by
// ray how sharply they bend and how near they are.
//
// A step of the shaded point by dP turns the direction to what is seen by dP across the ray times its nearness (the shear of
// light over a distance, frequency/operators.h): a motion like that of the reflected direction itself, so one bandwidth serves both.
#pragma once

#include <burnish/light/light_chain.h>
#include <burnish/shading/bend_sums.h>
#include <burnish/shading/lobe_taps.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burnish {

/// What stands for a material in predictions, without any light: made once, shared by its predictors.
struct MaterialProbes {
    /// settings.prediction does not count: it is `curvature`.
    MaterialProbes(const Material& material, const DensitySettings& settings);

    struct Lobe {
        LobeParameters lobe;
        std::optional<LobeTaps> taps;  // none where anisotropy comes from a layer: one ray per pixel then
        AlbedoCurve albedo;
    };
    std::vector<Lobe> lobes;
    float safety;
};

class LocalPrediction {
public:
    LocalPrediction(std::shared_ptr<const MaterialProbes> probes, LightChain lights);

    void predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const;

private:
    void add_discs(const MaterialProbes::Lobe& probes, const SurfaceBatch& batch, std::span<float> bend) const;

    std::shared_ptr<const MaterialProbes> m_probes;
    LightChain m_lights;
    float m_exposure;  // scales overlays to a mean of kDisplayMean
};

}  // namespace burnish
