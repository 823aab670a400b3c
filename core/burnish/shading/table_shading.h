// Shading by a table of taps: a batch of pixels at a time, with the widest vectors the processor has.
#pragma once

#include <burnish/light/cube_stack.h>
#include <burnish/shading/tap_table.h>
#include <burnish/surface/surface_batch.h>

#include <span>

namespace burnish {

/// What one lobe is shaded with; all of it outlives the call.
struct TableShading {
    const LobeParameters& lobe;
    const TapTable& table;
    const CubeStack& stack;
    float distortion;  // levels per octave of cube_distortion
    Matrix33f world_to_light;
    Color3f gain;
};

/// The luminance of light as a lobe weighs it, without tint, strength and gain.
struct LobeMoments {
    float mean = 0;    // integral of light times lobe
    float square = 0;  // integral of light squared times lobe
    float weight = 0;  // integral of the lobe

    /// Variance of one importance sample of the lobe, over the square of its mean; >= 0.
    float relative_variance() const { return mean > 0 ? std::max(square * weight / (mean * mean) - 1, 0.0f) : 0.0f; }
};

/// Adds the lobe's overlay of pixel i to overlay[i], and to samples[i] the lookups it took: taps of no weight take none. Sets
/// moments[i], if there are any, as far as the stack's A holds squares. The same pixel gives the same bits in whatever batch it
/// comes.
void add_table_shading(const TableShading& shading, const SurfaceBatch& batch, std::span<Color3f> overlay,
                       std::span<float> samples, std::span<LobeMoments> moments = {});

}  // namespace burnish
