// Shades listed pixels of a tile and puts the results in their places: what dense and sparse shading share.
#pragma once

#include <burnish/base/progress.h>
#include <burnish/shading/dense.h>

#include <functional>

namespace burnish {

/// A frame for the results of these shaders; its overlay is unset until its tiles are shaded.
ShadedFrame shaded_frame(int width, int height, const std::vector<MaterialShader>& shaders, bool with_samples);

/// The pixels of a tile to be shaded, by rule; row-major.
using PixelLists = std::vector<std::vector<uint32_t>>;

/// For every tile of `tile_size` pixels a side: `list` adds the pixels to shade, each valid, to the lists, which come empty;
/// results go to `frame`. Reports progress under "shading".
void shade_tiles(const Surfaces& surfaces, const std::vector<MaterialShader>& shaders, int tile_size,
                 const std::function<void(const Window& tile, PixelLists& pixels)>& list, const Progress& progress,
                 ShadedFrame& frame);

}  // namespace burnish
