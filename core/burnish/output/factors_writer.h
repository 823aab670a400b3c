// Factors to files that other programs open as pictures: one EXR with a part a map, the formula in its header; or 8-bit PNGs, a file
// a map, with the formula beside them.
#pragma once

#include <burnish/factor/quantise.h>
#include <burnish/factor/stored_factors.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace burnish {

/// Half floats (ZIP), or floats where a texel is beyond what halves hold; whole or not at all; same factors, same bits. Read by
/// read_factors. Throws Error(bad_argument) for another extension than .exr, Error(write_failed).
void write_factors(const std::string& file, const StoredFactors& stored);

/// White, colour, scale and prescale factors: what 8-bit maps are multiplied by.
nlohmann::json eight_bit_to_json(const QuantisedFactors& eight_bit);

/// FOLDER/NAME_<map>.png, RGBA, and FOLDER/NAME.json, which holds what the EXR's header does and the above as "eight_bit"; each whole or not at all. Returns the files. Throws Error(write_failed).
std::vector<std::string> write_quantised(const std::string& folder, const std::string& name, const StoredFactors& stored,
                                         const QuantisedFactors& eight_bit);

}  // namespace burnish
