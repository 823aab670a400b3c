// Shades listed pixels of a tile and puts the results in their places: what dense and sparse shading share.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/shading/dense.h>

#include <functional>

namespace burnish {

/// An empty frame of results for these shaders.
ShadedFrame shaded_frame(int width, int height, const std::vector<MaterialShader>& shaders);

/// For every tile of the frame: `gather(tile, rule, batch)` lists and fills the pixels to shade with shaders[rule]; results go to
/// `frame`. Reports progress under "shading".
void shade_tiles(const std::vector<MaterialShader>& shaders,
                 const std::function<void(const Window& tile, int rule, SurfaceBatch& batch)>& gather, const Progress& progress,
                 ShadedFrame& frame);

}  // namespace burnish
