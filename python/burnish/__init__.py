"""burnish: the view-dependent specular overlay for rendered frames.

    import burnish
    layers = burnish.composite("beauty.exr", "studio.hdr", "chrome")
    layers["beauty"]            # ndarray, shape (height, width, 4), float32, linear, associated alpha

Arrays are (height, width, channels) or (height, width), float32, row 0 on top. Directions are unit vectors that point
away from the surface; of a lobe they are local, z along the normal.
"""

from __future__ import annotations

from os import PathLike as _PathLike
from typing import TYPE_CHECKING as _TYPE_CHECKING, Any as _Any

from ._core import Environment, Factors, Frame, LightBandwidth, Lobe, LobeBandwidth, Measured, __version__
from . import _core, _documentation
from ._bandwidth import local_bandwidth
from ._compositing import composite, refine
from ._factoring import factor, read_factors
from ._fitting import fit
from ._image_buffers import to_imagebuf
from ._shot import Frames, Shot
from ._tables import library, models, presets, roles, settings, shot_schema
from .errors import (
    BadArgument,
    Cancelled,
    ColorSpaceError,
    Error,
    FramesFailed,
    LostConnection,
    MissingChannel,
    ReadFailed,
    SizeMismatch,
    WriteFailed,
)
from . import sequence

if _TYPE_CHECKING:
    from ._core import Progress as _Progress
    from numpy.typing import ArrayLike as _Array

    _Path = str | _PathLike[str]

__all__ = [
    "BadArgument",
    "Cancelled",
    "ColorSpaceError",
    "Environment",
    "Error",
    "Factors",
    "Frame",
    "Frames",
    "FramesFailed",
    "LightBandwidth",
    "Lobe",
    "LobeBandwidth",
    "LostConnection",
    "Measured",
    "MissingChannel",
    "ReadFailed",
    "Shot",
    "SizeMismatch",
    "WriteFailed",
    "check_energy",
    "compare",
    "composite",
    "factor",
    "fit",
    "info",
    "library",
    "local_bandwidth",
    "models",
    "presets",
    "preview",
    "read_factors",
    "read_materials",
    "read_measured",
    "refine",
    "roles",
    "run",
    "sequence",
    "settings",
    "shot_schema",
    "to_imagebuf",
]


def run(job: dict | _Path, progress: _Progress | None = None, **settings: _Any) -> dict[str, _Any]:
    """Run a job: read, shade, composite and write its frames.

    Parameters
    ----------
    job : dict or str or os.PathLike
        The shot document, or the path of a shot file (see `shot_schema`).
    progress : callable, optional
        ``progress(stage, done)`` with done in [0, 1] over the whole run; returning False cancels.
    **settings
        Settings by name; they win over the job's own.

    Returns
    -------
    dict
        The report: what was found, done and how long it took, frame by frame.

    Raises
    ------
    BadArgument, MissingChannel, SizeMismatch, ReadFailed, WriteFailed, ColorSpaceError
        What went wrong; nothing half-written is left behind.
    Cancelled
        `progress` returned False.
    """
    return _core.run(job, settings, progress)


def check_energy(material: str | dict) -> dict[str, float]:
    """The largest directional albedo of a material; above 1 it creates energy.

    Parameters
    ----------
    material : str or dict
        A preset, a JSON file, or the material itself.

    Returns
    -------
    dict
        {"max_albedo": float, unitless, "theta_o_deg": float, degrees from the normal}.

    Raises
    ------
    BadArgument
        The material is unknown or has a field out of range.
    """
    return _core.check_energy(material)


def info(path: _Path) -> dict[str, _Any]:
    """What burnish sees in an EXR, and what it lacks.

    Parameters
    ----------
    path : str or os.PathLike
        The EXR.

    Returns
    -------
    dict
        Windows, layers, roles with the reason for each, camera, cryptomattes, notes and warnings.

    Raises
    ------
    ReadFailed
        The file is absent, corrupt, deep or no EXR.
    """
    return _core.info(path)


def read_materials(path: _Path) -> list[dict[str, _Any]]:
    """The materials of a glTF (.gltf, .glb) or MaterialX (.mtlx) file, their constants as burnish's lobes.

    Parameters
    ----------
    path : str or os.PathLike
        The file; a job names one of its materials by "FILE#NAME".

    Returns
    -------
    list of dict
        {"name": str, "material": dict as shot files hold it, "notes": list of what was left out}, in the order of the file. Colours
        are as in the file, linear Rec.709.

    Raises
    ------
    ReadFailed
        The file is absent, corrupt or holds no such material.
    BadArgument
        A number is out of range; the message names the field.
    """
    return _core.read_materials(path)


def read_measured(path: _Path) -> Measured:
    """Read a measured reflectance.

    Parameters
    ----------
    path : str or os.PathLike
        MERL's .binary, Cornell's .brdf, ALTA's .alta or .dat, or a text that begins with "# burnish gonio 1".

    Returns
    -------
    Measured
        It can be evaluated on directions of shape (n, 3); as a material it is ``{"model": "table", "table": path}``, or its path.

    Raises
    ------
    ReadFailed
        The file is absent, or no measurement.
    """
    return Measured(path)


def preview(material: str | dict, environment: str | _Path | None = None, size: int = 256) -> _Array:
    """A ball of a material, as `burnish preview` shows it.

    Parameters
    ----------
    material : str or dict
        A preset, "merl:NAME", a JSON file, or the material itself.
    environment : str or os.PathLike, optional
        A picture of the light from all around, Z up; by default a sky with a small sun and soft boxes.
    size : int
        Pixels across and down, 1 to 4096.

    Returns
    -------
    ndarray, shape (size, size, 4), float32
        Linear RGBA, associated alpha: 0 around the ball.

    Raises
    ------
    BadArgument
        The material is unknown or has a field out of range; `size` is.
    ReadFailed
        A file cannot be read.
    """
    return _core.preview(material, environment, size)


def compare(a: _Array, b: _Array, mask: _Array | None = None) -> dict[str, _Any]:
    """Measure how far picture `a` is from the reference `b`.

    Parameters
    ----------
    a, b : ndarray, shape (height, width, channels) or (height, width), float32
        Linear pictures of the same shape; the first three channels count.
    mask : ndarray, shape (height, width), optional
        Pixels above 0 are measured; by default all.

    Returns
    -------
    dict
        psnr_db (display encoded, dB), relative_rms, relmse, largest_error (linear), largest_at (x, y), pixels, non_finite.

    Raises
    ------
    SizeMismatch
        The shapes differ.
    """
    return _core.compare(a, b, mask)


_documentation.add_settings(run, composite, refine)
