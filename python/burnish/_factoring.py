"""From a material and its light to small maps: the Python face of ``burnish factor``."""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING, Any

from . import _core

if TYPE_CHECKING:
    from numpy.typing import ArrayLike as Array

    from ._core import Environment, Factors, Progress

    Path = str | PathLike[str]


def factor(
    material: str | dict,
    light: Path | Array | Environment | None = None,
    output: Path | None = None,
    *,
    parametrization: str | None = None,
    quality: str = "normal",
    progress: Progress | None = None,
    **fields: Any,
) -> dict[str, Any]:
    """Turn a material under its light, or its BRDF, into a product of two to four small maps.

    Parameters
    ----------
    material : str or dict
        A preset, "merl:NAME", a file, a measured table, or the material itself. Under a light it must be isotropic.
    light : str or os.PathLike or ndarray or Environment, optional
        Environment map, as in `composite`. None: the BRDF alone is factored.
    output : str or os.PathLike, optional
        EXR to write.
    parametrization : str, optional
        What the maps are looked up by: "re", "nr", "nre", "nrv", "nrhd"; of BRDFs "io", "hd", "pqp". By default "nre", and "pqp".
    quality : str, optional
        "preview", "normal" or "high": texels and samples.
    progress : callable, optional
        ``progress(stage, done)``, done in [0, 1]; returning False cancels.
    **fields
        The other options of ``burnish factor`` by name, with underscores (``png="maps"``, ``terms=2``, ``env_rotate=90``); switches
        as True or False (``alpha=False``, ``polish=False``).

    Returns
    -------
    dict
        "factors" : Factors; "error" at the samples: average_absolute, max_absolute, average_relative, max_relative, rms;
        "eight_bit_error" of the pictures in `png`, and "eight_bit", by what they are multiplied; "display_psnr_db" against the estimator
        "reference", under a light only; "parametrization", "terms", "samples", "seconds" by stage, "files" written.

    Raises
    ------
    BadArgument
        The material cannot be factored (it is anisotropic, or takes numbers from layers), or an option is out of range.
    ReadFailed, WriteFailed
        A file cannot be read or written.
    Cancelled
        `progress` returned False.
    """
    given = {"material": material, "output": output, "parametrization": parametrization, "quality": quality, **fields}
    factors, report = _core.factor(light, {name: value for name, value in given.items() if value is not None}, progress)
    return {"factors": factors, **report}


def read_factors(path: Path) -> Factors:
    """Read the maps that `factor` or ``burnish factor`` wrote.

    Parameters
    ----------
    path : str or os.PathLike
        The EXR.

    Returns
    -------
    Factors
        They can be evaluated on directions of shape (n, 3).

    Raises
    ------
    ReadFailed, BadArgument
        The file is absent, damaged, or holds no factors.
    """
    return _core.Factors(path)
