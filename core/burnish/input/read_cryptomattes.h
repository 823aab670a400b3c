// The cryptomattes of an open file: which attributes and channels hold them, whatever parts they lie in.
#pragma once

#include <burnish/input/exr_file.h>

#include <string>
#include <vector>

namespace burnish {

/// All cryptomattes of the file, without their pixels; see decode_cryptomattes for what is left out.
std::vector<Cryptomatte> find_cryptomattes(const ExrFile& file, std::vector<std::string>& warnings);

/// The channels of a cryptomatte of that file, two a rank.
std::vector<Channel> channels_of(const ExrFile& file, const Cryptomatte& cryptomatte);

/// Reads the ranks of a cryptomatte of that file, laid out as `window`, bits untouched.
void read_ranks(const ExrFile& file, const Window& window, Cryptomatte& cryptomatte);

}  // namespace burnish
