// How fast one material's overlay varies with the direction of reflection: the angular half of the bandwidth prediction.
//
// Under distant light the transport operators come down to one product (frequency/operators.h),
//
//     b = nu_a * |change of the reflected direction per pixel|   cycles per pixel,
//
// of which the second factor is geometry and this is the first. Where lights are near, what is reflected also moves as the shaded
// point does, by its nearness.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/light/light_chain.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/density.h>
#include <burnish/surface/surface_batch.h>

#include <memory>
#include <span>

namespace burnish {

/// Of one pixel.
struct AngularPrediction {
    float nu_a;      // cycles per radian of the reflected direction, of a display signal that spans black to white
    float reach;     // radian around the reflected direction within which nu_a holds
    float length;    // radian the lobe reaches along its tangent, with which it turns; 0 for round lobes
    float nearness;  // radian that what is seen moves by, per scene unit of the shaded point's way across the ray
    float shown;     // display signal that the pixel comes to, 1 a white; where lights are near
};

/// Share of a period 1 / nu_a that interpolation may span, of a display signal from black to white; by calibration.
inline constexpr float kCellPeriods = 0.16f;
/// Of a display signal: what interpolation over a cell may miss at its centre where lights are near, safety 1.
inline constexpr float kMostMissed = 0.01f;

struct MaterialProbes;

class BandwidthPredictor {
public:
    /// The environment must outlive the predictor.
    BandwidthPredictor(const Material& material, const Environment& light, const DensitySettings& settings);

    /// Under any lights, by `curvature`. `probes`: of the material, see MaterialProbes.
    BandwidthPredictor(std::shared_ptr<const MaterialProbes> probes, LightChain lights);

    /// Sets out[i] for pixel i of the batch, safety included. Thread-safe; the same pixel gives the same bits in whatever batch
    /// it comes.
    void predict(const SurfaceBatch& batch, std::span<AngularPrediction> out) const;

    /// The fields of a batch that `predict` reads, and layers that some lobe of the material reads.
    BatchNeeds needs() const { return {m_asks_rays, m_is_anisotropic}; }
    const PerPixel& used_layers() const { return m_used_layers; }

    /// Whether any light is near: then cells end where positions jump.
    bool is_near() const { return m_is_near; }
    float safety() const { return m_safety; }

    struct Variant;  // one kind of prediction

private:
    void note(const LobeParameters& lobe);

    bool m_is_anisotropic = false, m_asks_rays = false, m_is_near = false;
    float m_safety = 1;
    PerPixel m_used_layers;
    std::shared_ptr<const Variant> m_variant;
};

/// Layers that any of the materials reads.
PerPixel used_layers(std::span<const BandwidthPredictor> predictors);

}  // namespace burnish
