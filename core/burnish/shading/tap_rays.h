// The taps of pixels as rays, which lights that are near are asked for.
#pragma once

#include <burnish/light/light_ray.h>
#include <burnish/shading/table_shading.h>

#include <vector>

namespace burnish {

/// The rays of some pixels, one after the other.
struct TapRays {
    /// What a tap's light is multiplied by, in the way of kernels: R, G, B and their luminance.
    struct Weight {
        float rgba[4];
    };

    std::vector<LightRay> rays;   // and room for more, kept from batch to batch
    std::vector<Weight> weights;  // the same
    std::vector<uint32_t> ends;   // of each pixel's rays

    size_t count() const { return ends.empty() ? 0 : ends.back(); }
};

/// The taps of pixels [begin, end) of a batch by their lobe's table, which names widths by their logarithm (lobe_taps.h). What scales
/// the whole lobe is not in the weights; taps of no weight are left out. The same pixel gives the same bits in whatever batch it comes.
void set_table_rays(const LobeTable& lobe, const SurfaceBatch& batch, size_t begin, size_t end, TapRays& out);

}  // namespace burnish
