// Reads one picture of light from an untrusted file into plain RGB floats.
#pragma once

#include <burnish/base/image.h>

#include <string>

namespace burnish {

/// What an EXR's `envmap` attribute says of the picture.
enum class EnvmapTag { none, latlong, cube };

struct Picture {
    Image rgb;
    EnvmapTag tag = EnvmapTag::none;
};

/// Reads R, G, B (or the Combined pass of a multilayer file, or a single grey channel) of the first part at full
/// resolution. Sizes that the file cannot hold are refused before anything is allocated. Throws Error(read_failed).
Picture read_picture(const std::string& file);

}  // namespace burnish
