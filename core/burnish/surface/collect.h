// Which pixels of a row wear a material, with the widest vectors the processor has.
#pragma once

#include <burnish/surface/validity.h>

#include <vector>

namespace burnish {

/// Appends those of the pixels [first, first + count) of a frame that are valid and wear `rule`. `validity`, `rules`: of the
/// frame's pixels.
void collect(const Validity* validity, const int16_t* rules, int rule, size_t first, size_t count,
             std::vector<uint32_t>& pixels);

}  // namespace burnish
