// Shading by a table of taps: a batch of pixels at a time, with the widest vectors the processor has.
#pragma once

#include <burnish/light/filter/cube_stack.h>
#include <burnish/shading/tap_table.h>
#include <burnish/surface/surface_batch.h>

#include <span>

namespace burnish {

/// One lobe by its table, in the axes that its directions are to come in; all of it outlives the call.
struct LobeTable {
    const LobeParameters& lobe;
    const TapTable& table;
    Matrix33f world_to_light;
};

/// What one lobe is shaded with.
struct TableShading : LobeTable {
    const CubeStack& stack;
    float distortion;  // levels per octave of cube_distortion
    Color3f gain;
};

/// Where the sums of a batch are added, entry i for pixel i.
struct TableSums {
    std::span<Color3f> overlay;
    std::span<float> samples;  // lookups it took: taps of no weight take none
    std::span<float> fourth;   // of the stack's fourth channel, taps weighted by their luminance; may be empty
    std::span<float> weight;   // of those weights, as the overlay of light 1 would be; may be empty
};

/// Adds the lobe's overlay. The same pixel gives the same bits in whatever batch it comes.
void add_table_shading(const TableShading& shading, const SurfaceBatch& batch, const TableSums& out);

/// Variance of one importance sample of the lobe, over the square of its mean; >= 0. From the luminance of a lobe's overlay and
/// its `fourth` and `weight`, where the stack's fourth channel holds squares.
inline float relative_variance(float mean, float fourth, float weight) {
    return mean > 0 ? std::max(fourth * weight / (mean * mean) - 1, 0.0f) : 0.0f;
}

}  // namespace burnish
