// Docstrings of the compiled classes that stand for light, numpydoc. Shapes, units and errors are stated here once; _core.pyi has the types.
#pragma once

namespace burnish::python::docs {

inline constexpr const char* Environment = R"(Distant light: an environment map and its pyramid.

Directions are in the light's own axes; turn a world direction w with ``w @ world_to_light``. Radiance is linear RGB, without
`gain`.

Parameters
----------
source : str or os.PathLike or ndarray or Environment
    Environment map: a file, or a picture of shape (height, width, 3), lat-long or a layout of cube faces. Of one that is
    there already: the same light turned, flipped, scaled or tinted otherwise, at no cost.
**settings
    Settings that start with env, and up.

Attributes
----------
world_to_light : ndarray, shape (3, 3)
    World direction (a row) to light axes.
gain : tuple of 3 floats
    Scale times tint, which the overlay is multiplied with.
face_size, level_count : int
    Texels along a cube face of the finest level; number of levels.
notes, warnings : list of str
    What was found and what was scrubbed.

Raises
------
ReadFailed
    The file is absent, corrupt or no picture.
BadArgument
    A setting is unknown or out of range.)";

inline constexpr const char* Environment_radiance = R"(Unfiltered radiance.

Parameters
----------
d : ndarray, shape (n, 3)
    Unit directions in light axes.

Returns
-------
ndarray, shape (n, 3), float32
    Linear RGB.

Raises
------
SizeMismatch
    The shape is another one.)";

inline constexpr const char* Environment_lookup = R"(Radiance filtered to a level of the pyramid, trilinear.

Parameters
----------
d : ndarray, shape (n, 3)
    Unit directions in light axes.
level : float or ndarray, shape (n,)
    0 is the finest level. Suns are in the pyramid with env_suns="keep" only.

Returns
-------
ndarray, shape (n, 3), float32
    Linear RGB.

Raises
------
SizeMismatch
    The shapes do not fit.)";

inline constexpr const char* Environment_level = R"(The level at which a texel covers a solid angle.

Parameters
----------
d : ndarray, shape (n, 3)
    Unit directions in light axes.
solid_angle : float
    Steradian.

Returns
-------
ndarray, shape (n,), float32
    Level; may be negative.

Raises
------
SizeMismatch
    The shape is another one.)";

inline constexpr const char* Environment_sample = R"(Draw directions with density proportional to luminance.

Parameters
----------
u : ndarray, shape (n, 2)
    Numbers in [0, 1).

Returns
-------
d : ndarray, shape (n, 3), float32
    Unit directions in light axes.
pdf : ndarray, shape (n,), float32
    Per steradian.

Raises
------
SizeMismatch
    The shape is another one.)";

inline constexpr const char* Environment_pdf = R"(Density of `sample`.

Parameters
----------
d : ndarray, shape (n, 3)
    Unit directions in light axes.

Returns
-------
ndarray, shape (n,), float32
    Per steradian.

Raises
------
SizeMismatch
    The shape is another one.)";

inline constexpr const char* LightBandwidth = R"(How fast distant light varies with direction, found by wavelets.

Parameters
----------
light : Environment
    Suns that are apart count as well.)";

inline constexpr const char* LightBandwidth_at = R"(Upper bound of the local bandwidth in a cone of directions.

Parameters
----------
d : ndarray, shape (n, 3)
    Directions in light axes.
radius : float
    Half angle of the cone, radian, up to pi / 4.

Returns
-------
ndarray, shape (n,), float32
    Cycles per radian.

Raises
------
SizeMismatch
    The shape is another one.)";

}  // namespace burnish::python::docs
