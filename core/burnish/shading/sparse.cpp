#include <burnish/shading/sparse.h>

#include <burnish/shading/shading_plan.h>
#include <burnish/shading/tile_shading.h>
#include <burnish/shading/upsample.h>

namespace burnish {
namespace {

/// The tile's valid pixels of a rule that are corners of cells.
void list_corners(const ShadingPlan& plan, const Surfaces& surfaces, const Assignment& assignment, const Window& tile, int rule,
                  SurfaceBatch& batch) {
    batch.clear();
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
        const size_t row = static_cast<size_t>(y) * static_cast<size_t>(assignment.width);
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            const size_t pixel = row + static_cast<size_t>(x);
            if (plan.is_corner(x, y) && surfaces.validity(pixel) == Validity::valid && assignment.rule[pixel] == rule)
                batch.pixel.push_back(static_cast<uint32_t>(pixel));
        }
    }
}

}  // namespace

ShadedFrame shade_sparse(const AovFrame& frame, const Surfaces& surfaces, const Assignment& assignment,
                         const std::vector<MaterialShader>& shaders, const std::vector<BandwidthPredictor>& predictors,
                         const PerPixel& used, const Progress& progress) {
    const CellTurning turning(frame, surfaces, assignment, used);
    const ShadingPlan plan(turning, surfaces, assignment, predictors);
    ShadedFrame shaded = shaded_frame(assignment.width, assignment.height, shaders);
    const auto gather = [&](const Window& tile, int rule, SurfaceBatch& batch) {
        list_corners(plan, surfaces, assignment, tile, rule, batch);
        if (batch.size() > 0) surfaces.fill(batch);
    };
    shade_tiles(shaders, gather, progress, shaded);
    upsample(plan, shaded.overlay);
    return shaded;
}

}  // namespace burnish
