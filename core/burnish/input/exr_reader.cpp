#include <burnish/input/exr_reader.h>

#include <burnish/input/frame_reader.h>

#include <limits>

namespace burnish {

AovFrame read_frame(const std::string& file, const ReadOptions& options) {
    return FrameReader(file, options, std::numeric_limits<size_t>::max()).read_band();
}

}  // namespace burnish
