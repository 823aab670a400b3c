"""Local bandwidth of images."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _core

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


def local_bandwidth(
    image: ArrayLike,
    rule: str = "energy",
    *,
    quantile: float = 0.95,
    epsilon: float = 0.01,
    contrast: float = 0.005,
    surround: str = "zero",
) -> NDArray[np.float32]:
    """How fast an image varies around each of its pixels, found by wavelets.

    Parameters
    ----------
    image : ndarray, shape (height, width)
        One channel.
    rule : str
        "energy": what holds `quantile` of the local energy; "maxima": what is above `epsilon` of the largest coefficient.
    quantile, epsilon : float
        In (0, 1), see `rule`.
    contrast : float
        Variation of this size, relative to the local value, competes with the image's own.
    surround : str
        What is around the image: "zero", "repeat" (itself) or "latlong" (itself, over the poles above and below).

    Returns
    -------
    ndarray, shape (height, width), float32
        Cycles per sample, in [0, 0.5].

    Raises
    ------
    SizeMismatch
        The image has more than one channel.
    BadArgument
        A number is out of range, or a name unknown.
    """
    return _core.local_bandwidth(image, rule, quantile, epsilon, contrast, surround)
