// Predicts how fast an overlay varies under distant light, from how sharply the light bends once the lobe has filtered it
// (bend_sums.h).
//
// The lobe stands for few Gaussians (fitted.h), whose filtered light and its curvature one lookup reads (light_curvature.h).
#pragma once

#include <burnish/light/environment.h>
#include <burnish/shading/bend_sums.h>
#include <burnish/shading/tap_table.h>

#include <vector>

namespace burnish {

class CurvaturePrediction {
public:
    CurvaturePrediction(const Material& material, const Environment& light, const DensitySettings& settings);

    void predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const;

private:
    /// One lobe by its taps, and how its albedo changes with the view.
    struct LobeProbes {
        LobeProbes(const LobeParameters& parameters, const Environment& light, int directions);

        LobeParameters lobe;
        TapTable table;   // empty where anisotropy comes from a layer: one tap per pixel then
        CubeStack stack;  // what the taps read
        AlbedoCurve albedo;
    };

    void add_light(const LobeProbes& probes, const SurfaceBatch& batch, std::span<Color3f> overlay,
                   std::span<float> bend) const;
    void add_suns(const LobeProbes& probes, const SurfaceBatch& batch, std::span<float> bend) const;

    const Environment& m_light;
    float m_safety;
    float m_exposure;  // scales overlays to a mean of kDisplayMean
    std::vector<LobeProbes> m_lobes;
};

}  // namespace burnish
