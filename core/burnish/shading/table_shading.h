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

/// Where the sums of a batch are added, entry i for pixel i.
struct TableSums {
    std::span<Color3f> overlay;
    std::span<float> samples;  // lookups it took: taps of no weight take none
    std::span<float> fourth;   // of the stack's fourth channel, taps weighted by their luminance; may be empty
};

/// Adds the lobe's overlay. The same pixel gives the same bits in whatever batch it comes.
void add_table_shading(const TableShading& shading, const SurfaceBatch& batch, const TableSums& out);

}  // namespace burnish
