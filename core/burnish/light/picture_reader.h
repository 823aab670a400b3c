// Reads one picture of light from an untrusted file into plain floats: its colour, or what lies beside it.
#pragma once

#include <burnish/base/image.h>

#include <string>

namespace burnish {

/// What an EXR's `envmap` attribute says of the picture.
enum class EnvmapTag { none, latlong, cube };

/// `color`: RGB. `alpha`, `distance`: one channel.
enum class PictureLayer { color, alpha, distance };

struct Picture {
    Image pixels;
    EnvmapTag tag = EnvmapTag::none;
};

/// Reads the first part at full resolution. Colour is R, G, B or the combined layer of a multilayer file, or a single grey
/// channel; alpha is A beside it; distance is the depth layer, or the only channel. Layers go by the names that frames' layers go
/// by (input/roles.h). Sizes that the file cannot hold are refused before anything is allocated.
/// Throws Error(read_failed), and Error(missing_channel) where there is no such layer.
Picture read_picture(const std::string& file, PictureLayer layer = PictureLayer::color);

/// Whether the file has that layer; reads the header only. Throws Error(read_failed).
bool has_layer(const std::string& file, PictureLayer layer);

}  // namespace burnish
