"""OpenImageIO.ImageBuf in and out, through numpy. OpenImageIO is imported only where a caller has given one, or asks for one."""

from __future__ import annotations

import contextlib
import pathlib
import tempfile
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import BadArgument, ReadFailed, WriteFailed

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray
    from OpenImageIO import ImageBuf

COMPONENTS = ("rgba", "rgb", "xyz")
LAYERS = {"beauty": ["R", "G", "B", "A"]} | {
    key: [f"burnish_{name}.{component}" for component in components] for key, name, components in (
        ("overlay", "spec", "RGB"), ("diffuse", "diffuse", "RGB"), ("validity", "validity", "X"), ("samples", "samples", "X"),
        ("error", "error", "X"))}


def is_imagebuf(value: object) -> bool:
    """Whether it is one."""
    return type(value).__name__ == "ImageBuf" and type(value).__module__.startswith("OpenImageIO")


def to_imagebuf(layers: dict[str, Any]) -> ImageBuf:
    """Make one OpenImageIO.ImageBuf of the layers of a frame, its channels named as in the EXRs that burnish writes.

    Parameters
    ----------
    layers : dict
        What `composite`, `refine` or `Shot.composite` gives: name -> ndarray of shape (height, width, channels) or (height, width), float32.

    Returns
    -------
    OpenImageIO.ImageBuf
        R, G, B, A, burnish_spec.R, ...: pixels of shape (height, width, channels), float32, linear, associated alpha.

    Raises
    ------
    BadArgument
        There is no layer.
    ImportError
        OpenImageIO is not installed.
    """
    import OpenImageIO as oiio

    found = {name: channels for name, channels in LAYERS.items() if name in layers}
    if not found:
        raise BadArgument(f"layers: expected what composite gives, such as beauty, found {', '.join(layers) or 'nothing'}")
    pixels = np.ascontiguousarray(np.dstack([layers[name] for name in found]), np.float32)
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], oiio.FLOAT)
    spec.channelnames = tuple(channel for channels in found.values() for channel in channels)
    buffer = oiio.ImageBuf(spec)
    buffer.set_pixels(oiio.ROI(), pixels)
    return buffer


def to_array(value: Any, name: str, channels: int = 0) -> Any:
    """An ImageBuf as an array, channels found by their names; anything else as it is. `channels`: that are wanted; 0: all."""
    if not is_imagebuf(value):
        return value
    pixels = _pixels(value, name)
    components = [channel.rpartition(".")[2].lower() for channel in value.spec().channelnames]
    for wanted in COMPONENTS:
        if channels in (0, len(wanted)) and set(wanted) <= set(components):
            return np.ascontiguousarray(pixels[..., [components.index(component) for component in wanted]])
    return pixels[..., 0] if pixels.shape[2] == 1 else pixels


def to_layers(layers: dict[str, Any]) -> dict[str, Any]:
    """Layers by role as arrays."""
    return {role: to_array(value, role, 0 if role == "beauty" else 3) for role, value in layers.items()}


@contextlib.contextmanager
def frames_on_disk(*frames: Any) -> Iterator[list[Any]]:
    """Frames with an ImageBuf that holds all of one as an EXR that lasts as long: what its channels are, its windows, camera and cryptomattes
    are then found as in any file. Other frames as they are.
    """
    with contextlib.ExitStack() as stack:
        yield [stack.enter_context(_frame_on_disk(frame)) if is_imagebuf(frame) else
               to_layers(frame) if isinstance(frame, dict) else frame for frame in frames]


@contextlib.contextmanager
def _frame_on_disk(buffer: ImageBuf) -> Iterator[pathlib.Path]:
    import OpenImageIO as oiio

    pixels = _pixels(buffer, "aovs")
    spec = oiio.ImageSpec(buffer.spec())
    spec.set_format(oiio.FLOAT)
    spec.attribute("compression", "none")
    with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
        path = pathlib.Path(folder) / "frame.exr"
        output = oiio.ImageOutput.create(str(path))
        if not (output.open(str(path), spec) and output.write_image(pixels) and output.close()):
            raise WriteFailed(f"{path}: cannot be written: {output.geterror()}")
        yield path


def _pixels(buffer: ImageBuf, name: str) -> NDArray[np.float32]:
    """All pixels of the data window, shape (height, width, channels)."""
    import OpenImageIO as oiio

    pixels = buffer.get_pixels(oiio.FLOAT)
    if buffer.has_error or pixels is None or pixels.size == 0:
        raise ReadFailed(f"{name}: the ImageBuf has no pixels: {buffer.geterror()}")
    return pixels
