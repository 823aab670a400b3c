// A header that OpenEXR's C library has opened. Internal: for sources that ask it what OpenImageIO does not tell.
#pragma once

#include <openexr.h>

#include <memory>
#include <string>
#include <type_traits>

namespace burnish {

struct CloseExr {
    void operator()(exr_context_t context) const { exr_finish(&context); }
};
using ExrContext = std::unique_ptr<std::remove_pointer_t<exr_context_t>, CloseExr>;

/// Reads the header only. Throws Error(read_failed) when it is damaged or out of bounds (exr_header.h).
ExrContext open_exr(const std::string& file);

}  // namespace burnish
