// Which pixels of a window wear a material, with the widest vectors the processor has.
#pragma once

#include <burnish/base/image.h>
#include <burnish/surface/validity.h>

#include <vector>

namespace burnish {

/// A frame's pixels, row-major.
struct WornRules {
    const Validity* validity;
    const int16_t* rule;
    size_t width;  // of the frame
};

/// Appends the pixels of `window` that are valid and wear `rule`, row by row.
void collect(const WornRules& frame, const Window& window, int rule, std::vector<uint32_t>& pixels);

}  // namespace burnish
