"""Synthetic frames and lights made in code, and EXR files of them."""

import numpy as np
import OpenImageIO as oiio

CAMERA = (0.0, -4.0, 0.0)
"""Where `sphere` and `plane` are seen from: Z up, looking along +Y, 45 degrees wide."""

CAMERA_JSON = {"position": CAMERA, "look_at": [0, 0, 0], "up": [0, 0, 1], "fov_x_deg": 45}


def rays(width, height):
    """Directions through the pixel centres, (height, width, 3), with planar depth 1 along +Y."""
    slope = np.tan(np.radians(45) / 2)
    x = (2 * (np.arange(width) + 0.5) / width - 1) * slope
    z = (1 - 2 * (np.arange(height) + 0.5) / height) * slope * height / width
    d = np.ones((height, width, 3), np.float64)
    d[..., 0], d[..., 2] = x[None, :], z[:, None]
    return d


def sphere(width=64, height=48, radius=1.0, camera=CAMERA):
    """Role name -> array: a sphere at the origin before black, beauty grey 0.2 with alpha."""
    d = rays(width, height)
    eye = np.asarray(camera)
    a, b, c = (d * d).sum(-1), 2 * d @ eye, eye @ eye - radius**2
    disc = b * b - 4 * a * c
    hit = disc > 0
    t = np.where(hit, (-b - np.sqrt(np.maximum(disc, 0))) / (2 * a), 0)
    position = np.where(hit[..., None], eye + t[..., None] * d, 0)
    return _frame(hit, position, position / radius)


def plane(width=64, height=48):
    """Role name -> array: the plane y = 0, tilted 30 degrees about X, filling the frame."""
    normal = np.array([0, -np.cos(np.radians(30)), np.sin(np.radians(30))])
    d = rays(width, height)
    t = -(np.asarray(CAMERA) @ normal) / (d @ normal)
    position = np.asarray(CAMERA) + t[..., None] * d
    return _frame(np.ones(t.shape, bool), position, np.broadcast_to(normal, d.shape))


def _frame(hit, position, normal):
    beauty = np.where(hit[..., None], 0.2, 0) * np.ones(4)
    beauty[..., 3] = hit
    arrays = {"beauty": beauty, "position": position, "normal": np.where(hit[..., None], normal, 0), "object_id": hit * 1.0}
    return {role: np.ascontiguousarray(array, np.float32) for role, array in arrays.items()}


def gradient_sky(width=64):
    """A lat-long picture, (width / 2, width, 3): bright above, coloured around, with a lamp."""
    height = width // 2
    v, u = np.mgrid[0:height, 0:width] + 0.5
    u, v = u / width, v / height
    sky = np.stack([0.4 + 0.3 * np.cos(2 * np.pi * u), 0.5 + 0 * u, 0.6 + 0.4 * np.cos(np.pi * v)], -1)
    sky[(abs(u - 0.25) < 0.05) & (abs(v - 0.3) < 0.06)] = 20
    return sky.astype(np.float32)


CHANNELS = {
    "beauty": ["R", "G", "B", "A"],
    "position": ["P.X", "P.Y", "P.Z"],
    "normal": ["N.X", "N.Y", "N.Z"],
    "depth": ["depth.Z"],
    "object_id": ["IndexOB.X"],
    "roughness": ["roughness.X"],
    "specular_direct": ["specular_direct.R", "specular_direct.G", "specular_direct.B"],
}


def write_frame(path, frame, attributes=None):
    """Write a frame as one EXR, 32-bit float, with the channel names above. Returns the path."""
    return write_exr(path, *channels_of(frame), attributes)


def channels_of(frame):
    """(names, pixels) of a frame's layers, one behind the other."""
    names, planes = [], []
    for role, array in frame.items():
        array = array[..., None] if array.ndim == 2 else array
        names += CHANNELS[role][: array.shape[2]]
        planes.append(array)
    return names, np.concatenate(planes, -1)


def write_exr(path, names, pixels, attributes=None):
    """Write channels in the order given; `attributes` name -> value or (type, value)."""
    return write_parts(path, [part_of(names, pixels, attributes)])


def part_of(names, pixels, attributes=None, kind=oiio.FLOAT, origin=(0, 0), display=None):
    """(spec, pixels) of a part; `origin`: of its data window; `display`: size of the window from 0, 0, else the part's own."""
    pixels = np.ascontiguousarray(pixels, np.float32)
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], kind)
    spec.channelnames = tuple(names)
    spec.x, spec.y = origin
    if display:
        spec.full_width, spec.full_height = display
    for name, value in (attributes or {}).items():
        spec.attribute(name, *value) if isinstance(value, tuple) else spec.attribute(name, value)
    return spec, pixels


def write_parts(path, parts):
    """Write an EXR of one or more parts, which need names ("oiio:subimagename") when there are several."""
    output = oiio.ImageOutput.create(str(path))
    specs = tuple(spec for spec, _ in parts)
    assert output.open(str(path), specs if len(specs) > 1 else specs[0]), output.geterror()
    for i, (spec, pixels) in enumerate(parts):
        assert i == 0 or output.open(str(path), spec, "AppendSubimage"), output.geterror()
        assert output.write_image(pixels), output.geterror()
    output.close()
    return path


def read_exr(path, part=0):
    """Channel name -> (height, width) array of a part."""
    source = oiio.ImageInput.open(str(path))  # an ImageBuf would show what a file held a moment ago
    assert source and source.seek_subimage(part, 0), oiio.geterror()
    names = source.spec().channelnames
    pixels = source.read_image(part, 0, 0, len(names), oiio.FLOAT)
    assert pixels is not None, source.geterror()
    return {name: pixels[..., i] for i, name in enumerate(names)}


def stacked(layers, *names):
    """Channels of `read_exr` as one (height, width, n) array."""
    return np.stack([layers[name] for name in names], -1)
