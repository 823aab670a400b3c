// The cryptomattes of an open file: which attributes and channels hold them, whatever parts they lie in.
#pragma once

#include <burnish/input/exr_file.h>

#include <string>
#include <vector>

namespace burnish {

/// All cryptomattes of the file, their layers laid out as `window`; see decode_cryptomattes for what is left out.
std::vector<Cryptomatte> read_cryptomattes(const ExrFile& file, const Window& window, std::vector<std::string>& warnings);

}  // namespace burnish
