// Shading under lights that are near: every tap of a lobe becomes a ray from the shaded point, and a chain of lights says what
// comes along it.
#pragma once

#include <burnish/light/light_chain.h>
#include <burnish/material/parameters.h>
#include <burnish/shading/lobe_taps.h>
#include <burnish/surface/surface_batch.h>

#include <memory>
#include <span>
#include <vector>

namespace burnish {

struct RunningReference;

/// A material's lobes under one estimator, without any light: made once, shared by its shaders.
struct MaterialTaps {
    /// Throws Error(bad_argument) for `factored`.
    MaterialTaps(const Material& material, const EstimatorSettings& settings);

    std::vector<LobeParameters> lobes;
    EstimatorSettings settings;
    std::vector<LobeTaps> taps;  // one a lobe; none for `reference`
};

/// Of every pixel of a batch; all the size of the batch, zero or what is to be added to.
struct LocalSums {
    std::span<Color3f> overlay;
    std::span<float> samples;         // lookups
    std::span<float> standard_error;  // `reference` only: of the overlay's luminance
    std::span<float> bend = {};       // of the overlay's luminance with the reflected direction, per radian^2; may be empty
    std::span<float> nearness = {};   // sum over the taps of nearness * nearness_weight; with `bend` only
};

/// Adds what one lobe reflects. The same pixel gives the same bits in whatever batch it comes.
void add_local_lobe(const LobeTaps& taps, const LightChain& lights, const SurfaceBatch& batch, const LocalSums& out);

/// The same by `reference`; `index` of the lobe, which makes its samples its own.
void add_local_reference(const LobeParameters& lobe, uint32_t index, const EstimatorSettings& settings,
                         const LightChain& lights, const SurfaceBatch& batch, const LocalSums& out);

/// The lobe's part of the next pass of `reference`, see MaterialShader::add_pass.
void add_local_pass(const LobeParameters& lobe, uint32_t index, const LightChain& lights, const SurfaceBatch& batch,
                    std::span<RunningReference> running);

/// Adds the bright discs of the chain's environments, which lookups leave out.
void add_local_discs(const LobeParameters& lobe, const LightChain& lights, const SurfaceBatch& batch, const LocalSums& out);

}  // namespace burnish
