// Which packings change what is stored: fine for pictures, not for positions, normals and ids.
#pragma once

#include <burnish/input/layers.h>

#include <string>
#include <vector>

namespace burnish {

/// Names of those channels that `compression` changes, by OpenEXR's rules: DWA by how a name ends, B44 half, PXR24 32-bit float.
std::vector<std::string> changed_channels(const std::string& compression, const std::vector<Channel>& channels);

}  // namespace burnish
