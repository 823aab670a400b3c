// Docstrings of the compiled classes that stand for reflectance, numpydoc. Shapes, units and errors are stated here once; _core.pyi has the types.
#pragma once

namespace burnish::python::docs {

inline constexpr const char* Lobe =
    R"(One lobe of a material, free of tint and strength, on arrays of local directions (z along the normal).

Parameters
----------
description : dict
    A lobe as the shot file spells it, e.g. {"model": "ggx", "mx": 0.1, "my": 0.1}.

Raises
------
BadArgument
    A field is unknown or out of range.)";

inline constexpr const char* Lobe_eval = R"(The reflectance f, Fresnel included, without the cosine.

Parameters
----------
wo, wi : ndarray, shape (n, 3)
    Unit directions to the viewer and to the light.

Returns
-------
ndarray, shape (n, 3), float32
    Per steradian and colour channel; 0 where a direction is on the wrong side.

Raises
------
SizeMismatch
    The shapes differ.)";

inline constexpr const char* Lobe_pdf = R"(Density of `sample` in solid angle of wi.

Parameters
----------
wo, wi : ndarray, shape (n, 3)
    Unit directions to the viewer and to the light.

Returns
-------
ndarray, shape (n,), float32
    Per steradian.

Raises
------
SizeMismatch
    The shapes differ.)";

inline constexpr const char* Lobe_sample = R"(Draw directions to the light.

Parameters
----------
wo : ndarray, shape (n, 3)
    Unit directions to the viewer.
u : ndarray, shape (n, 2)
    Numbers in [0, 1).

Returns
-------
ndarray, shape (n, 3), float32
    Unit directions wi; below the surface where the draw missed.

Raises
------
SizeMismatch
    The shapes differ.)";

inline constexpr const char* Lobe_D = R"(Density of microfacet normals.

Parameters
----------
wm : ndarray, shape (n, 3)
    Unit microfacet normals.

Returns
-------
ndarray, shape (n,), float32
    Per steradian; D times cos(theta) integrates to 1.

Raises
------
SizeMismatch
    The shape is another one.)";

inline constexpr const char* Lobe_albedo =
    R"(Directional albedo: the share of light from everywhere that leaves along wo, tint and strength included.

Parameters
----------
wo : ndarray, shape (n, 3)
    Unit directions to the viewer.
samples : int
    Points of the quasi-Monte-Carlo estimate.

Returns
-------
ndarray, shape (n, 3), float32
    Unitless, per colour channel.

Raises
------
SizeMismatch
    The shape is another one.)";

inline constexpr const char* Measured =
    R"(A measured reflectance, from MERL's .binary, Cornell's .brdf, ALTA's .alta and .dat, or burnish's own text.

Parameters
----------
path : str or os.PathLike
    The file.

Raises
------
ReadFailed
    The file is absent, or no measurement.)";

inline constexpr const char* Measured_eval = R"(The reflectance f between the measured directions, without the cosine.

Parameters
----------
wo, wi : ndarray, shape (n, 3)
    Unit directions to the viewer and to the light; wi below the surface: light that comes through.

Returns
-------
ndarray, shape (n, 3), float32
    1/sr, per colour channel; 0 below the surface unless it transmits.

Raises
------
SizeMismatch
    The shapes are other ones.)";

inline constexpr const char* Measured_samples = R"(What was measured.

Returns
-------
tuple of ndarray, shape (n, 3), float32
    wo, wi and f in 1/sr. Of MERL's tables every eighth cell.)";

inline constexpr const char* Measured_info = R"(What the measurement holds.

Returns
-------
dict
    "file"; "kind"; "merl_name", its name in MERL's database where it is one of those files, untouched; "isotropic";
    "transmits"; "samples", how many are valid; "theta_i_deg", least and largest; and of the material made of it "kd",
    "width" and "albedo" from 45 degrees.)";

inline constexpr const char* Measured_write_merl = R"(Write it as a MERL table; one that is a MERL table keeps its bytes.

Parameters
----------
path : str or os.PathLike
    The file, which appears whole or not at all.

Raises
------
BadArgument
    It is anisotropic.
WriteFailed
    The file cannot be written.)";

inline constexpr const char* LobeBandwidth =
    R"(Which frequencies of the light a lobe lets through, found by wavelets.

Parameters
----------
lobe : Lobe
    Its tint and strength do not matter.)";

inline constexpr const char* LobeBandwidth_nu_rho = R"(The frequency below which 95 % of the lobe's spectrum lies.

Parameters
----------
cos_o : ndarray, shape (n,)
    Cosine between the view and the normal. Of a lobe that is not round, the largest value over the azimuths.

Returns
-------
ndarray, shape (n,), float32
    Cycles per radian of the direction to the light.

Raises
------
SizeMismatch
    The shape is another one.)";

inline constexpr const char* LobeBandwidth_at = R"(Local bandwidth of the lobe as a function of the direction to the light.

Parameters
----------
wo, wi : ndarray, shape (n, 3)
    Unit directions to the viewer and to the light, z along the normal.

Returns
-------
ndarray, shape (n,), float32
    Cycles per radian.

Raises
------
SizeMismatch
    The shapes differ.)";

}  // namespace burnish::python::docs
