// Factors read from the EXR that they were written to: one part a map, the formula in its header. Files are not trusted.
#pragma once

#include <burnish/factor/stored_factors.h>

#include <string>

namespace burnish {

/// Attribute of the first part that holds the JSON of stored_factors.h.
inline constexpr const char* kFactorsAttribute = "burnish:factors";

/// Throws Error(read_failed) where the file is absent, damaged, lacks a map, or holds one of another size or with texels that are no
/// numbers; Error(bad_argument) where its header says what cannot be.
StoredFactors read_factors(const std::string& file);

}  // namespace burnish
