#include <burnish/shading/dense.h>

#include <burnish/shading/tile_shading.h>

namespace burnish {

ShadedFrame shade_dense(const Surfaces& surfaces, const Assignment& assignment, const std::vector<MaterialShader>& shaders,
                        const Progress& progress) {
    ShadedFrame frame = shaded_frame(assignment.width, assignment.height, shaders);
    shade_tiles(
        shaders, [&](const Window& tile, int rule, SurfaceBatch& batch) { surfaces.gather(tile, rule, batch); }, progress,
        frame);
    return frame;
}

}  // namespace burnish
