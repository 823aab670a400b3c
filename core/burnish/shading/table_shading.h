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
    /// How taps that reach below the geometric surface fade. A tap of width sigma shows it the share
    /// v = 1/2 + cos / (2.5 sigma), within 0 and 1, and weighs v(ng) / v(n) of its weight, at most all. Of level 1,
    /// 1 / (2.5 sigma); sigma doubles with every second level. 0: taps have no width, those below the surface are cut.
    float fade = 0;
};

/// Adds the lobe's overlay of pixel i to overlay[i], and to samples[i] the lookups it took: taps of no weight take none. The
/// same pixel gives the same bits in whatever batch it comes.
void add_table_shading(const TableShading& shading, const SurfaceBatch& batch, std::span<Color3f> overlay,
                       std::span<float> samples);

}  // namespace burnish
