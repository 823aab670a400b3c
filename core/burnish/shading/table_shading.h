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

/// Adds the lobe's overlay of pixel i to overlay[i], and to samples[i] the lookups it took: taps of no weight take none. The
/// same pixel gives the same bits in whatever batch it comes.
void add_table_shading(const TableShading& shading, const SurfaceBatch& batch, std::span<Color3f> overlay,
                       std::span<float> samples);

}  // namespace burnish
