// Factors to files that other programs open as pictures: one EXR with a part a map, the formula in its header.
#pragma once

#include <burnish/factor/stored_factors.h>

#include <string>

namespace burnish {

/// Half floats (ZIP), or floats where a texel is beyond what halves hold; whole or not at all; same factors, same bits. Read by
/// read_factors. Throws Error(bad_argument) for another extension than .exr, Error(write_failed).
void write_factors(const std::string& file, const StoredFactors& stored);

}  // namespace burnish
