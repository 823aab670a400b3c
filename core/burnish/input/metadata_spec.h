// What stands behind the opaque `Metadata`. Internal: for the sources (and tests) that call OpenImageIO, not for headers.
#pragma once

#include <burnish/input/metadata.h>

#include <OpenImageIO/imageio.h>

namespace burnish {

struct Metadata {
    OIIO::ImageSpec spec;     // of the part that holds the beauty, or of the first one read
    std::string layers = {};  // what the file has, for messages
    ChannelCounts channels = {};
};

}  // namespace burnish
