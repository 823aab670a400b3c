#include <burnish/shading/dense.h>

#include <burnish/base/parallel.h>
#include <burnish/shading/tile_shading.h>

namespace burnish {

ShadedFrame shade_dense(const Surfaces& surfaces, const Assignment& assignment, const std::vector<MaterialShader>& shaders,
                        const Progress& progress) {
    ShadedFrame frame = shaded_frame(assignment.width, assignment.height, shaders);
    const auto list = [&](const Window& tile, PixelLists& pixels) {
        for (int y = tile.y; y < tile.y + tile.height; ++y) {
            const size_t row = static_cast<size_t>(y) * static_cast<size_t>(assignment.width);
            for (size_t pixel = row + static_cast<size_t>(tile.x); pixel < row + static_cast<size_t>(tile.x + tile.width);
                 ++pixel)
                if (surfaces.validity(pixel) == Validity::valid)
                    pixels[static_cast<size_t>(assignment.rule[pixel])].push_back(static_cast<uint32_t>(pixel));
        }
    };
    shade_tiles(surfaces, shaders, kTileSize, list, progress, frame);
    return frame;
}

}  // namespace burnish
