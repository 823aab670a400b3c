#include <burnish/shading/dense.h>

#include <burnish/base/parallel.h>
#include <burnish/shading/tile_shading.h>

namespace burnish {

ShadedFrame shade_dense(const Surfaces& surfaces, const Assignment& assignment, const std::vector<MaterialShader>& shaders,
                        const Progress& progress, bool with_samples) {
    ShadedFrame frame = shaded_frame(assignment.width, assignment.height, shaders, with_samples);
    const auto list = [&](const Window& tile, PixelLists& pixels) {
        for (size_t rule = 0; rule < shaders.size(); ++rule) surfaces.list(tile, static_cast<int>(rule), pixels[rule]);
    };
    shade_tiles(surfaces, shaders, kTileSize, list, progress, frame);
    return frame;
}

}  // namespace burnish
