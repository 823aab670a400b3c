#include <burnish/shading/sparse.h>

#include <burnish/shading/shading_plan.h>
#include <burnish/shading/tile_shading.h>
#include <burnish/shading/upsample.h>

#include <algorithm>
#include <bit>

namespace burnish {
namespace {

/// Tiles are large, as each has few pixels to shade; but not so large that a small frame has only one, for threads and progress.
int tile_size(const ShadingPlan& plan) {
    constexpr int kManyBlocks = 2048;
    return (plan.block_columns() * plan.block_rows() > kManyBlocks ? 8 : 2) * ShadingPlan::kBlock;
}

/// Adds the tile's valid pixels that are corners of cells.
void list_corners(const ShadingPlan& plan, const Surfaces& surfaces, const Assignment& assignment, const Window& tile,
                  PixelLists& pixels) {
    for (int y = tile.y; y < tile.y + tile.height; ++y) {
        const size_t row = static_cast<size_t>(y) * static_cast<size_t>(assignment.width);
        for (int x0 = tile.x; x0 < tile.x + tile.width; x0 += ShadingPlan::kBlock) {
            const ShadingPlan::Corners& corners = plan.corners(x0 / ShadingPlan::kBlock, y / ShadingPlan::kBlock);
            for (uint32_t bits = corners[static_cast<size_t>(y % ShadingPlan::kBlock)]; bits != 0; bits &= bits - 1) {
                const int x = x0 + std::countr_zero(bits);
                const size_t pixel = row + static_cast<size_t>(x);
                if (x < assignment.width && surfaces.validity(pixel) == Validity::valid)
                    pixels[static_cast<size_t>(assignment.rule[pixel])].push_back(static_cast<uint32_t>(pixel));
            }
        }
    }
}

}  // namespace

ShadedFrame shade_sparse(const AovFrame& frame, const Surfaces& surfaces, const Assignment& assignment,
                         const std::vector<MaterialShader>& shaders, const std::vector<BandwidthPredictor>& predictors,
                         const Progress& progress, bool with_samples) {
    const bool is_near = std::ranges::any_of(predictors, &BandwidthPredictor::is_near);
    const CellTurning turning(frame, surfaces, assignment, used_layers(predictors), is_near ? AtSteps::end : AtSteps::go_on);
    const ShadingPlan plan(turning, surfaces, assignment, predictors);
    ShadedFrame shaded = shaded_frame(assignment.width, assignment.height, shaders, with_samples);
    const auto list = [&](const Window& tile, PixelLists& pixels) { list_corners(plan, surfaces, assignment, tile, pixels); };
    shade_tiles(surfaces, shaders, tile_size(plan), list, progress, shaded);
    upsample(plan, shaded.overlay);
    return shaded;
}

}  // namespace burnish
