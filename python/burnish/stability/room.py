"""A room that is known everywhere: a box whose walls shine as a smooth function of place, and a ball in it; y is up.

Rays are followed exactly, so that what a cube map or a mirror sees of the room is known to the last digit, and with it the true
reflection: an integral over rays drawn from the lobe that uses nothing of the library but the lobe itself.
"""

from __future__ import annotations

import dataclasses
import importlib.util
import pathlib

import numpy as np

from .. import Lobe, WriteFailed
from .scenes import directions, unit

RISE = np.array([0.3, 1.1, 2.0])
AWAY = np.array([0.1, 0.3, -1.0])  # no normal of a surface that is seen
TINT = np.array([1.0, 0.9, 0.8])


@dataclasses.dataclass(frozen=True)
class Room:
    """Walls from corner to corner, one ball or none; `waves`: radians of the walls' pattern per scene unit."""

    low: tuple = (-2.0, -1.2, -4.0)
    high: tuple = (2.0, 1.8, 7.0)
    ball: tuple = (0.0, 0.0, 0.0)
    radius: float = 0.0
    glow: float = 0.0  # radiance of the ball
    waves: float = 3.0

    def follow(self, p, d):
        """What rays from inside meet, (..., 3) each: radiance, place, unit normal."""
        low, high = np.asarray(self.low), np.asarray(self.high)
        with np.errstate(divide="ignore", invalid="ignore"):
            ways = np.where(d > 0, (high - p) / d, np.where(d < 0, (low - p) / d, np.inf))
        axis = ways.argmin(-1)[..., None]
        t = np.take_along_axis(ways, axis, -1)
        n = np.where(np.arange(3) == axis, -np.sign(d), 0.0)
        place = p + t * d
        light = (0.5 + 0.14 * np.sin(self.waves * place + RISE).sum(-1, keepdims=True)) * TINT
        near = way_to_ball(p, d, self.ball, self.radius)
        is_ball, at_ball = near < t, p + np.minimum(near, t) * d
        outward = (at_ball - np.asarray(self.ball)) / max(self.radius, 1e-30)
        return np.where(is_ball, self.glow, light), np.where(is_ball, at_ball, place), np.where(is_ball, outward, n)

    def planes(self):
        """Its walls as burnish takes them."""
        return [{"point": list(corner), "normal": list(row)} for corner in (self.low, self.high) for row in np.eye(3)]

    def cube_map(self, folder, centre, proxy, height=256):
        """Writes what is seen from a point, as a lat-long; returns the light."""
        file = pathlib.Path(folder) / "room.exr"
        write_exr(file, "RGB", self.follow(np.asarray(centre), directions(height))[0])
        return {"type": "cubemap", "file": str(file), "centre": list(centre), "convention": "openexr", "up": "y", "proxy": proxy}

    def mirror(self, folder, eye, width=256, height=192, fov_x_deg=60.0, look_at=(0.0, 0.0, -3.0)):
        """Writes what the floor y = 0 shows an eye, seen by a camera under it; returns the light."""
        below = np.array([eye[0], -eye[1], eye[2]])
        camera = {"position": below.tolist(), "look_at": list(look_at), "up": [0, 1, 0], "fov_x_deg": fov_x_deg}
        d = pinhole(camera, width, height)
        through = below - d * (below[1] / np.where(d[..., 1:2] > 0, d[..., 1:2], 1))
        parts = [np.where(d[..., 1:2] > 0, part, 0) for part in self.follow(through, d)]
        file = pathlib.Path(folder) / "mirror.exr"
        names = ["R", "G", "B", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z"]
        write_exr(file, names, np.concatenate(parts, -1))
        return {"type": "mirror", "file": str(file), "camera": camera, "plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}}

    def reflection(self, frame, lobe, eye, samples=256):
        """The overlay of a frame that wears one lobe: the mean over rays drawn from it, the same for all pixels."""
        p, n = frame["position"].astype(np.float64), frame["normal"].astype(np.float64)
        wo = unit(np.asarray(eye) - p)
        x = unit(np.cross(n, AWAY))
        axes = np.stack([x, np.cross(n, x), n], -2)  # rows: the local axes
        local = np.einsum("...ij,...j->...i", axes, wo).reshape(-1, 3)
        brdf, total = Lobe(lobe), np.zeros_like(local)
        for u in (np.arange(1, samples + 1)[:, None] * [0.7548776662466927, 0.5698402909980532]) % 1:
            wi = brdf.sample(local, np.broadcast_to(u, (len(local), 2)).astype(np.float32))
            pdf = brdf.pdf(local, wi)[:, None]
            weight = np.where((pdf > 0) & (wi[:, 2:] > 0), brdf.eval(local, wi) * wi[:, 2:] / np.maximum(pdf, 1e-30), 0)
            d = np.einsum("...ij,...i->...j", axes.reshape(-1, 3, 3), wi)
            total += weight * self.follow(p.reshape(-1, 3), unit(d))[0]
        return (total / samples).reshape(p.shape)


def way_to_ball(p, d, centre, radius):
    """Distance along rays from outside, (..., 1); infinity where the ball is missed."""
    towards = np.asarray(centre) - p
    b = (d * towards).sum(-1, keepdims=True)
    root = b * b - (towards**2).sum(-1, keepdims=True) + radius**2
    return np.where((root > 0) & (b > 0), b - np.sqrt(np.maximum(root, 0)), np.inf)


def pinhole(camera, width, height):
    """Unit directions through the pixels of a camera, (height, width, 3)."""
    ahead = unit(np.subtract(camera["look_at"], camera["position"]))
    right = unit(np.cross(ahead, camera["up"]))
    half = np.tan(np.radians(camera["fov_x_deg"]) / 2)
    x = half * ((2 * np.arange(width) + 1) / width - 1)
    y = half * (1 - (2 * np.arange(height) + 1) / height) * height / width
    return unit(ahead + x[:, None] * right + y[:, None, None] * np.cross(right, ahead))


def write_exr(file, names, pixels):
    """Channels in the order given, as float."""
    if importlib.util.find_spec("OpenImageIO") is None:
        raise WriteFailed("OpenImageIO is not installed; apt install python3-openimageio, or pip install openimageio")
    import OpenImageIO

    pixels = np.ascontiguousarray(pixels, np.float32)
    spec = OpenImageIO.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], OpenImageIO.FLOAT)
    spec.channelnames = tuple(names)
    picture = OpenImageIO.ImageOutput.create(str(file))
    if picture is None or not picture.open(str(file), spec) or not picture.write_image(pixels) or not picture.close():
        raise WriteFailed(f"{file}: {OpenImageIO.geterror() if picture is None else picture.geterror()}")
