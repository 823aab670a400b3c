"""One frame in memory: composited at once, or refined while someone looks."""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING, Any

from . import _core
from ._image_buffers import frames_on_disk, to_array

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from numpy.typing import ArrayLike as Array
    from OpenImageIO import ImageBuf

    from ._core import Environment, Frame, Progress

    Path = str | PathLike[str]


def composite(
    aovs: dict | Path | Frame | ImageBuf,
    light: Path | Array | Environment | ImageBuf | None,
    materials: str | dict | None = None,
    *,
    fine_aovs: dict | Path | Frame | ImageBuf | None = None,
    assign: list | dict | None = None,
    camera: dict | Path | Sequence[float] | None = None,
    progress: Progress | None = None,
    **settings: Any,
) -> dict[str, Any]:
    """Shade one frame in memory and composite the overlay over it.

    Parameters
    ----------
    aovs : str or os.PathLike or dict or Frame or OpenImageIO.ImageBuf
        An EXR, or role name -> ndarray of shape (height, width, channels) or (height, width), float32, linear; see
        `roles`. A beauty of four channels holds alpha in the fourth. Wherever an array is taken an ImageBuf is, too; one that holds a
        whole frame stands for its EXR.
    light : str or os.PathLike or ndarray or Environment or OpenImageIO.ImageBuf
        Environment map: a file, a picture of shape (height, width, 3), or one that is loaded already. None: that of the
        settings `env` or `lights`, if there is one.
    materials : str or dict, optional
        What the frame wears: a preset or file, one material (a dict with "lobes"), or name -> material for `assign`.
    fine_aovs : str or os.PathLike or dict or Frame, optional
        For anti-aliasing: the surfaces of the same frame (positions, normals, ids, ...) at a multiple of its width and
        height, as `aovs`; `aovs` is then read for the picture alone, and masks in `assign` have the size of these.
    assign : list or dict, optional
        Rules as in the shot file, or material name -> mask of shape (height, width) with coverage in [0, 1]; later ones
        win. Without it the whole frame wears the one material.
    camera : dict or str or os.PathLike or sequence of 3 floats, optional
        Camera JSON, its file, or the point the frame is seen from; by default as found in the frame.
    progress : callable, optional
        ``progress(stage, done)``, done in [0, 1]; returning False cancels.
    **settings
        Settings by name.

    Returns
    -------
    dict
        "beauty" : ndarray, shape (height, width, 4), float32, linear, associated alpha;
        "overlay" : ndarray, shape (height, width, 3), float32, what was added;
        "diffuse" : ndarray, shape (height, width, 3), only where the frame has no beauty;
        "validity" : ndarray, shape (height, width), 0 where shaded, else why not (the order of the report's "pixels");
        "samples" : ndarray, shape (height, width), lookups spent;
        "error" : ndarray, shape (height, width), standard error, estimator "reference" only;
        "report" : dict.

    Raises
    ------
    BadArgument, MissingChannel, SizeMismatch, ReadFailed, ColorSpaceError
        What went wrong.
    Cancelled
        `progress` returned False.
    """
    with frames_on_disk(aovs, fine_aovs) as (aovs, fine_aovs):
        return _core.composite(*_arguments(aovs, light, materials, fine_aovs, assign, camera, progress, settings))


def refine(
    aovs: dict | Path | Frame | ImageBuf,
    light: Path | Array | Environment | ImageBuf | None,
    materials: str | dict | None = None,
    *,
    fine_aovs: dict | Path | Frame | ImageBuf | None = None,
    assign: list | dict | None = None,
    camera: dict | Path | Sequence[float] | None = None,
    progress: Progress | None = None,
    **settings: Any,
) -> Iterator[dict[str, Any]]:
    """Composite one frame while someone looks at it: a first picture at once, then better and better ones.

    Each step comes nearer to the exact picture, down to the estimator "reference" at the settings `tolerance` and
    `max_samples`. Stop looking whenever you like (``break``, or ``close()``); after a change begin anew, with the
    `Environment` that is loaded already.

    Parameters
    ----------
    aovs, light, materials, fine_aovs, assign, camera, progress
        As for `composite`; `progress` goes from 0 to 1 in every step.
    **settings
        Settings by name, but no target (psnr, max_error, time).

    Returns
    -------
    iterator of dict
        What `composite` returns, and
        "step" : int, from 0;
        "label" : str, "first look", "as set", "dense, 256 lookups", then "reference, 512 lookups" and twice as many each;
        "is_final" : bool, whether every pixel meets the tolerance or has as many lookups as it may;
        "error" : ndarray, shape (height, width), expected error of the steps that the reference takes part in.

    Raises
    ------
    BadArgument, MissingChannel, SizeMismatch, ReadFailed, ColorSpaceError
        What went wrong, before the first step.
    Cancelled
        `progress` returned False.

    Examples
    --------
    >>> for layers in burnish.refine("shot.exr", light, "chrome"):      # doctest: +SKIP
    ...     show(layers["beauty"])
    ...     if changed(): break
    """
    with frames_on_disk(aovs, fine_aovs) as (aovs, fine_aovs):
        return _steps(_core.Refinement(*_arguments(aovs, light, materials, fine_aovs, assign, camera, progress, settings)))


def _steps(refinement):
    while (layers := refinement.next()) is not None:
        yield layers


def _arguments(aovs, light, materials, fine_aovs, assign, camera, progress, settings):
    """What the compiled module takes, from what `composite` takes."""
    frame = aovs if isinstance(aovs, (dict, _core.Frame)) else None
    if frame is None:
        settings["aovs"] = aovs
    if materials is not None:
        settings.update(one_material(materials, True))
    fine = fine_aovs if isinstance(fine_aovs, (dict, _core.Frame)) else None
    if fine is None and fine_aovs is not None:
        settings["fine_aovs"] = fine_aovs
    masks = {name: to_array(mask, f"assign: {name}") for name, mask in assign.items()} if isinstance(assign, dict) else None
    if masks is None and assign is not None:
        settings["assign"] = assign
    if camera is not None:
        settings["camera"] = placed_camera(camera)
    return frame, fine, to_array(light, "light", 3), masks, settings, progress


def placed_camera(camera: dict | Path | Sequence[float]) -> Any:
    """The setting `camera`; three numbers are its position."""
    return camera if isinstance(camera, (str, dict, PathLike)) else {"position": camera}


def one_material(materials: str | dict, is_worn: bool) -> dict[str, Any]:
    """The settings that say what `materials` means: a preset or file, one material, or several by name. `is_worn`: where there is one,
    the whole frame wears it.
    """
    if not isinstance(materials, dict):
        return {"material": materials}
    if "lobes" in materials or "model" in materials:
        return {"materials": {"material": materials}, "material": "material"}
    wardrobe = {"materials": materials}
    if is_worn and len(materials) == 1:
        wardrobe["material"] = next(iter(materials))
    return wardrobe
