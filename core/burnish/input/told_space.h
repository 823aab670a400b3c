// What a picture's header says of its colours: by attributes that renderers write, or by its primaries.
#pragma once

#include <burnish/input/metadata.h>

#include <string>

namespace burnish {

struct ToldSpace {
    std::string space;     // "lin_rec709", "ACEScg", "ACES2065-1"; "" = it does not say, or something else
    std::string evidence;  // "arnold/color_space = ACES - ACEScg"; "" = it does not say
};

/// The space among those three that a name in use means, "" for another.
std::string common_space(const std::string& name);

ToldSpace told_space(const Metadata& metadata);
/// Of the first part of an EXR; nothing for any other file, or one that cannot be read.
ToldSpace told_space(const std::string& file);

}  // namespace burnish
