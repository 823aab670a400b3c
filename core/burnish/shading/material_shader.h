// One material under its light, ready to shade: tables and patterns are made once, `shade` then runs from many threads.
//
// Distant light alone has kernels of its own, table_shading.h and, for `factored`, factor_shading.h; any other chain of lights is asked
// ray by ray, local_shading.h.
#pragma once

#include <burnish/light/environment.h>
#include <burnish/light/light_chain.h>
#include <burnish/material/parameters.h>
#include <burnish/sampling/estimator.h>
#include <burnish/surface/surface_batch.h>

#include <memory>
#include <span>
#include <vector>

namespace burnish {

class FactoredShader;
struct MaterialTaps;
struct RunningReference;

/// Results of one batch, entry i for batch pixel i.
struct ShadedBatch {
    std::vector<Color3f> overlay;       // linear radiance, light gain, tint and weight included
    std::vector<float> standard_error;  // reference only: of the overlay's luminance; else empty
    std::vector<float> samples;         // lookups spent on the pixel
};

class MaterialShader {
public:
    /// The environment must outlive the shader. `fitted` leaves lobes whose anisotropy comes from a layer to `regular`; and lobes
    /// longer than 1:6 with a long tail (GGX), unless settings.samples asks for a number of lookups. `factored` makes its maps here, in
    /// seconds; throws Error(bad_argument) where no maps can stand for the material (factored.h).
    MaterialShader(const Material& material, const Environment& light, const EstimatorSettings& settings);

    /// `factored` by maps that are there.
    explicit MaterialShader(std::shared_ptr<const FactoredShader> factored) : m_factored(std::move(factored)) {}

    /// Under any lights, not by `factored`. `taps`: of the material, see MaterialTaps.
    MaterialShader(std::shared_ptr<const MaterialTaps> taps, LightChain lights);

    /// Shades a batch into `out`. Thread-safe; the same pixel gives the same bits in whatever batch it comes.
    void shade(const SurfaceBatch& batch, ShadedBatch& out) const;

    /// Without the environment's bright discs, whatever they cover; under distant light by a filtered estimator.
    void shade_without_suns(const SurfaceBatch& batch, ShadedBatch& out) const;

    /// Adds the next pass of `reference` to what it has summed up at each pixel, whatever its tolerance. Of `reference` only;
    /// thread-safe as `shade`.
    void add_pass(const SurfaceBatch& batch, std::span<RunningReference> running) const;

    /// The fields of a batch that `shade` reads.
    BatchNeeds needs() const;

    /// Whether `shade` fills standard_error: the estimator is `reference`.
    bool estimates_error() const;

    int lobe_count() const;

    struct LobeShader;  // one lobe under one estimator

private:
    void shade_distant(const SurfaceBatch& batch, ShadedBatch& out) const;
    void shade_local(const SurfaceBatch& batch, ShadedBatch& out) const;

    std::vector<std::shared_ptr<const LobeShader>> m_lobes;  // under distant light
    std::shared_ptr<const FactoredShader> m_factored;        // or all of them by maps
    std::shared_ptr<const MaterialTaps> m_taps;              // under any other light
    LightChain m_lights;
};

}  // namespace burnish
