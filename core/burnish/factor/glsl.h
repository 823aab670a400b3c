// Factors as a piece of GLSL that shades from their maps: for engines, viewers and material editors.
//
// The piece declares what it needs and holds one function for callers,
//
//     vec3 burnish_factored(vec3 n, vec3 wo)      radiance of a material under its light; world axes
//     vec3 burnish_factored(vec3 wi, vec3 wo)     BRDF, 1/sr; the surface's frame, z along the normal
//
// of unit vectors that point away from the surface. It begins without #version: 1.30 of desktop GLSL, or newer, takes it.
#pragma once

#include <burnish/factor/quantise.h>
#include <burnish/factor/stored_factors.h>

#include <string>

namespace burnish {

/// For the maps of an EXR.
std::string glsl_of(const StoredFactors& stored);
/// For the 8-bit maps of the same.
std::string glsl_of(const StoredFactors& stored, const QuantisedFactors& eight_bit);

}  // namespace burnish
