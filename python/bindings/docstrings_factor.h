// What Python's help says of factors.
#pragma once

namespace burnish::python::docs {

inline constexpr const char* Factors = R"(A BRDF, or a material under its light, as a product of small maps.

Parameters
----------
path : str or os.PathLike
    An EXR that `burnish.factor` or ``burnish factor`` wrote.

Raises
------
ReadFailed
    The file is absent, damaged, or holds no factors.
BadArgument
    Its header says what cannot be.)";

inline constexpr const char* Factors_evaluate = R"(What the maps say.

Parameters
----------
a, b : ndarray, shape (n, 3)
    Unit directions. Lighting: normal and direction to the viewer, world axes. BRDF: directions to the light and to the viewer, z along
    the normal.

Returns
-------
ndarray, shape (n, 3), float32
    Radiance, linear RGB; or the BRDF, 1/sr.

Raises
------
SizeMismatch
    The shapes differ.)";

inline constexpr const char* Factors_map = R"(The texels of a map.

Parameters
----------
name : str
    "normal", "reflection", ...; "normal_2" of the second term.

Returns
-------
ndarray, shape (height, width, 3), float32
    Row 0 first, as textures have it.

Raises
------
BadArgument
    There is no such map.)";

inline constexpr const char* Factors_glsl = R"(A shader that shades from the maps: ``vec3 burnish_factored(vec3, vec3)``.

Returns
-------
str)";

inline constexpr const char* Factors_write = R"(Write the maps as an EXR of half floats.

Parameters
----------
path : str or os.PathLike
    Ends in .exr.

Raises
------
WriteFailed
    The file cannot be written.)";

}  // namespace burnish::python::docs
