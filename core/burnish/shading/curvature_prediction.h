// Predicts how fast an overlay varies from how sharply the light bends once the lobe has filtered it.
//
// Bilinear interpolation over a step of D radians misses at most D^2 / 8 of a second derivative along each axis, so the second
// derivative of what a display shows is all that counts. With display ~ sqrt(x), x = the overlay L scaled to a mean of 0.18,
//
//     d2 display ~ L'' sqrt(s / L) / 2,     L'' = sum of taps' weight * curvature of the light filtered to the tap's width
//
// plus what suns and the lobe's own change with the view add. As a bandwidth: nu of a full-range sinusoid that bends as much.
// The lobe stands for few Gaussians (fitted.h), whose filtered light and its curvature one lookup reads (light_curvature.h).
#pragma once

#include <burnish/light/environment.h>
#include <burnish/shading/predictor.h>
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
        float albedo_curvature(float cos_o) const;

        LobeParameters lobe;
        TapTable table;                         // empty where anisotropy comes from a layer: one tap per pixel then
        std::vector<float> relative_curvature;  // |A'' / A| by angle of view, 0 to 90 degrees
        float typical_albedo;
    };

    void add_light(const LobeProbes& probes, const SurfaceBatch& batch, std::span<Color3f> overlay,
                   std::span<float> bend) const;
    void add_suns(const LobeProbes& probes, const SurfaceBatch& batch, std::span<float> bend) const;
    void set_reach(const LobeProbes& probes, const SurfaceBatch& batch, std::span<AngularPrediction> out) const;

    const Environment& m_light;
    float m_safety;
    float m_exposure;  // scales overlays to a mean of 0.18
    std::vector<LobeProbes> m_lobes;
};

}  // namespace burnish
