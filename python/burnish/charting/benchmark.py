"""The fixed benchmark set: a sphere, materials, lights, and how many lookups each estimator is tried with.

All of it is made in code, so that figures of today and of next year compare. Names are those of the CSV.
"""

from __future__ import annotations

import dataclasses
import pathlib

import numpy as np

from .. import BadArgument, Environment

CAMERA = (0.0, 0.0, 6.0)
"""Where the sphere is seen from: y up, the sphere fills the frame."""

GRAZING = np.cos(np.radians(75))
"""The view cosine below which errors are told apart."""

LOOKUPS = {
    "fitted": (1, 2, 3, 4, 6, 8, 12),
    "regular": (4, 7, 12, 19, 30, 61),
    "filtered_importance": (4, 7, 16, 32, 64),
    "preconvolved": (4, 7, 16, 32, 64),
    "split_sum": (1,),
    "factored": (1,),
}
"""Estimator -> lookups asked for, in the order of the legend; `regular` takes the pattern nearest to each, `factored` what its maps need."""


@dataclasses.dataclass(frozen=True)
class Material:
    """One lobe of a model with Gaussian-like slopes of widths mx and my, without Fresnel and tint."""

    model: str
    mx: float
    my: float

    @property
    def name(self):
        """As the command line takes it: "ggx-0.1", "beckmann-0.2x0.02"."""
        return f"{self.model}-{self.mx:g}" + (f"x{self.my:g}" if self.mx != self.my else "")

    @property
    def kind(self):
        """The row of the picture it belongs to."""
        return f"{self.model} {'isotropic' if self.mx == self.my else 'anisotropic'}"

    def lobe(self):
        """As `burnish.composite` takes it."""
        return {"model": self.model, "mx": self.mx, "my": self.my}


MATERIALS = tuple(Material(model, m, m) for model in ("beckmann", "ggx") for m in (0.02, 0.05, 0.1, 0.2, 0.4)) + (
    Material("beckmann", 0.2, 0.075),
    Material("beckmann", 0.2, 0.02),
)


def sphere(size):
    """Role name -> array: a unit sphere of `size` pixels seen from CAMERA, its beauty black; background P = N = 0."""
    distance = CAMERA[2]
    half = 1 / np.sqrt(distance**2 - 1)  # tangent of the angle the outline is seen under
    x = half * (2 * (np.arange(size) + 0.5) / size - 1)
    d = np.stack([*np.meshgrid(x, -x), -np.ones((size, size))], -1)
    d /= np.linalg.norm(d, axis=-1, keepdims=True)
    b = distance * d[..., 2]
    root = b * b - (distance**2 - 1)
    near = -b - np.sqrt(np.maximum(root, 0))
    position = np.where(root[..., None] > 0, CAMERA + near[..., None] * d, 0).astype(np.float32)
    return {"position": position, "normal": position, "beauty": np.zeros_like(position)}


def view_cosines(frame):
    """wo . n of every pixel, shape (size, size); 0 in the background."""
    wo = np.asarray(CAMERA) - frame["position"]
    return (wo * frame["normal"]).sum(-1) / np.linalg.norm(wo, axis=-1)


def stress_light(seed, height=512, spots=40):
    """A lat-long, (height, 2 height, 3): spots of 2-10 degrees, up to 3000:1 (log-uniform), on a background of 1."""
    random = np.random.default_rng(seed)
    theta = np.pi * (np.arange(height) + 0.5) / height
    phi = np.pi * (np.arange(2 * height) + 0.5) / height
    light = np.ones((height, 2 * height))
    for z, turn, diameter, strength in random.random((spots, 4)):
        cosine = 2 * z - 1
        across = np.sqrt(1 - cosine**2) * np.sin(theta)[:, None] * np.cos(phi - 2 * np.pi * turn)
        angle = np.arccos(np.clip(across + cosine * np.cos(theta)[:, None], -1, 1))
        radius = np.radians(2 + 8 * diameter) / 2
        coverage = np.clip((radius - angle) * height / np.pi + 0.5, 0, 1)  # an edge one texel wide
        light = np.maximum(light, 1 + (3000.0**strength - 1) * coverage)
    return np.repeat(light[..., None], 3, -1).astype(np.float32)


STRESS_LIGHTS = {"stress-1": 1, "stress-2": 2}
"""Name -> seed."""


def light_sources(files):
    """Name -> seed or file, in the order they are measured: the stress lights, then the files by their names."""
    sources = dict(STRESS_LIGHTS)
    for file in files:
        name = pathlib.Path(file).stem
        if name in sources:
            raise BadArgument(f"--env: two lights are called {name}; rename {file}")
        sources[name] = file
    return sources


def light_picture(source):
    """The picture of a seed, or the file."""
    return stress_light(source) if isinstance(source, int) else source


def load_light(source):
    """The light of a seed or a file, y up."""
    return Environment(light_picture(source))
