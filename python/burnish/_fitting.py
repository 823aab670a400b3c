"""From measured tables to materials: the Python face of ``burnish fit``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core

if TYPE_CHECKING:
    from os import PathLike

    from ._core import Progress


def fit(
    table: str | PathLike[str],
    model: str | None = None,
    *,
    lobes: int = 3,
    all_lobes: bool = False,
    bounds: dict[str, float | tuple[float, float]] | None = None,
    progress: Progress | None = None,
) -> dict[str, Any]:
    """Fit a material of a few numbers to a measured table.

    Parameters
    ----------
    table : str or os.PathLike
        A file that `read_measured` reads.
    model : str, optional
        Name of a reflectance model (see `models`); by default what describes the data best with the fewest numbers.
    lobes : int, optional
        Lobes at most on each side of the surface, 1 to 3; fewer where more do not pay.
    all_lobes : bool, optional
        As many lobes as `lobes` says, whether they pay or not.
    bounds : dict, optional
        Parameter name -> (min, max), or a number to fix it; "2.m" speaks of the second lobe's m alone.
    progress : callable, optional
        ``progress(stage, done)``, done in [0, 1]; returning False cancels.

    Returns
    -------
    dict
        "material": for `composite` and the shot file; "errors" of the fit taken, "tried": all fits with their errors,
        "notes": what to know about the data; "residuals" by the light's angle, degrees; "curves" of data and fit, 1/sr.

    Raises
    ------
    BadArgument
        A model, bound or number of lobes that there is not, or a table without a valid value.
    ReadFailed
        The table cannot be read.
    Cancelled
        `progress` returned False.
    """
    ranges = {name: (value, value) if isinstance(value, (int, float)) else tuple(value)
              for name, value in (bounds or {}).items()}
    return _core.fit(table, model, lobes, all_lobes, ranges, progress)
