"""What the cases look at: surfaces as arrays of position and normal, lights as lat-long pictures; y is up.

A surface is what `burnish.composite` takes as `aovs`: role name -> array, its beauty black; P = N = 0 where there is none.
"""

from __future__ import annotations

import numpy as np

from .. import Environment, composite
from ..charting import benchmark

CAMERA = benchmark.CAMERA
"""Where every surface here is seen from, unless it says another place."""


def unit(vectors):
    """Vectors (..., 3) made one long."""
    vectors = np.asarray(vectors, np.float64)
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def surface(position, normal):
    """Role name -> array, of arrays that broadcast to (height, width, 3)."""
    position, normal = np.broadcast_arrays(position, normal)
    return {"position": position.astype(np.float32), "normal": normal.astype(np.float32),
            "beauty": np.zeros(position.shape, np.float32)}


def facets(normal, wo):
    """Pixels that have nothing to do with each other: each its normal and the direction it is seen from, unit vectors."""
    return surface(np.asarray(CAMERA) - wo, normal)


sphere = benchmark.sphere
view_cosines = benchmark.view_cosines


def tilted(degrees):
    """Normals turned from z towards x by angles (...): shape (..., 3)."""
    angle = np.radians(degrees)
    return np.stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)], -1)


def floor(width, height, eye_height=1.0, top_deg=0.25, bottom_deg=30.0):
    """The plane y = 0 and the eye over it: rows go from `top_deg` to `bottom_deg` below the horizon, columns 20 degrees."""
    down = np.radians(np.linspace(top_deg, bottom_deg, height))[:, None]
    turn = np.radians(np.linspace(-10, 10, width))
    away = eye_height / np.tan(down)
    position = np.stack([away * np.sin(turn), np.zeros((height, width)), -away * np.cos(turn)], -1)
    return surface(position, np.array([0.0, 1, 0])), (0.0, eye_height, 0.0)


def waves(width, height, crests=4.0, slope_deg=20.0):
    """A sheet [-1, 1] wide in the plane z = 0 that faces the camera, in waves along x as steep as `slope_deg`."""
    x = (2 * np.arange(width) + 1) / width - 1
    y = (1 - (2 * np.arange(height) + 1) / height) * height / width
    turn, steepest = np.pi * crests * x, np.tan(np.radians(slope_deg))
    plane = np.stack(np.broadcast_arrays(x, y[:, None], steepest / (np.pi * crests) * np.sin(turn)), -1)
    return surface(plane, unit(np.stack([-steepest * np.cos(turn), np.zeros(width), np.ones(width)], -1)))


def directions(height):
    """World directions of the texels of a lat-long picture, shape (height, 2 height, 3)."""
    theta = np.pi * (np.arange(height) + 0.5) / height
    phi = np.pi * (1 - (np.arange(2 * height) + 0.5) / height)
    across = np.sin(theta)[:, None]
    return np.stack(np.broadcast_arrays(across * np.sin(phi), np.cos(theta)[:, None], across * np.cos(phi)), -1)


def sky(radiance, height=64):
    """The lat-long picture (height, 2 height, 3) of a function from directions (..., 3) to radiance (...) or (..., 3)."""
    values = radiance(directions(height))
    return np.broadcast_to(values if values.ndim == 3 else values[..., None], (height, 2 * height, 3)).astype(np.float32)


def spots(places, background=1.0):
    """Light of round spots: a function for `sky`; `places` are (direction, diameter in degrees, radiance)."""
    def radiance(d):
        texel = np.pi / d.shape[0]
        light = np.full(d.shape[:-1], background)
        for direction, diameter, strength in places:
            angle = np.arccos(np.clip(d @ unit(direction), -1, 1))
            coverage = np.clip((np.radians(diameter) / 2 - angle) / texel + 0.5, 0, 1)  # an edge one texel wide
            light = np.maximum(light, background + (strength - background) * coverage)
        return light

    return radiance


def environment(picture, **settings):
    """A lat-long picture of `sky`, loaded."""
    return Environment(picture, env_convention="openexr", up="y", **settings)


def lobe(model, mx, my=None, **more):
    """One lobe of these widths, F = 1."""
    return {"model": model, "mx": mx, "my": mx if my is None else my, **more}


def layers(frame, light, material, **settings):
    """What `burnish.composite` makes of a frame, every pixel shaded, on one thread."""
    settings = {"camera": CAMERA, "density": "dense", "threads": 1, **settings}
    light = environment(light) if isinstance(light, np.ndarray) else light
    return composite(frame, light, material, **settings)


def overlay(frame, light, material, **settings):
    """The overlay alone, (height, width, 3), float64."""
    return layers(frame, light, material, **settings)["overlay"].astype(np.float64)


def reference(frame, light, material, tolerance=0.005, **settings):
    """The overlay of the estimator `reference`, its standard error at most `tolerance` of each pixel."""
    return overlay(frame, light, material, estimator="reference", tolerance=tolerance, **settings)
