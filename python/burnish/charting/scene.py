"""What is charted: a frame under its light, taken apart into the materials in it.

A Part is the pixels of one material, shaded alone, or the whole frame. A Source says what a scene is without loading it.
"""

from __future__ import annotations

import dataclasses
import hashlib
import json
import pathlib
from collections.abc import Callable

import numpy as np

from .. import composite, library, presets
from .lights import Lights
from .setting import Setting

WHOLE = "whole frame"


@dataclasses.dataclass(frozen=True)
class Part:
    """Pixels and what they wear: arguments of `composite` besides frame and light."""

    name: str
    parameters: str  # of the material: "ggx 0.06x0.4 + kurt 0.01"
    job: dict
    coverage: np.ndarray  # shape (height, width), 0 where it is not


@dataclasses.dataclass(frozen=True)
class Scene:
    """A loaded frame, its light and its parts; `own` is the setting it would be shaded with if nobody asked."""

    name: str
    light: str
    frame: object  # as `composite` takes it
    job: dict  # arguments of `composite` that all parts share
    lights: Lights
    parts: tuple[Part, ...]
    own: Setting | None
    grazing: np.ndarray | None = None  # mask, where the angle of view is known

    def shade(self, part, setting, threads=0, only=None, **more):
        """The layers of a part under a setting; `only`: the mask of the pixels to shade."""
        environment, _ = self.lights.get(*setting.light())
        job = {**self.job, **part.job, **setting.shading(), **more, "threads": threads}
        if only is not None:
            job["assign"] = {name: coverage * only for name, coverage in part.job["assign"].items()}
        return composite(self.frame, environment, **job)


@dataclasses.dataclass(frozen=True)
class Source:
    """A scene before it is loaded."""

    name: str
    count: int  # of parts, as far as it is known
    identity: object  # whatever tells it from another of the same name; JSON
    load: Callable[[], Scene]

    def digest(self, *more):
        """Twelve hexadecimal digits that change when the scene or `more` do."""
        text = json.dumps([self.name, self.identity, *more], sort_keys=True, default=str)
        return hashlib.sha1(text.encode()).hexdigest()[:12]


def file_stamps(value):
    """Size and time of every file that strings inside a value name."""
    if isinstance(value, dict):
        return [stamp for entry in value.values() for stamp in file_stamps(entry)]
    if isinstance(value, (list, tuple)):
        return [stamp for entry in value for stamp in file_stamps(entry)]
    try:
        found = pathlib.Path(value).stat()
    except (OSError, TypeError, ValueError):
        return []
    return [[str(value), found.st_size, found.st_mtime_ns]]


def parameters_of(material):
    """The lobes of a material, or of a preset by its name, in a few words."""
    if isinstance(material, str):
        material = presets().get(material) or library().get(material) or material
    lobes = material.get("lobes", [material]) if isinstance(material, dict) else []
    return " + ".join(lobe_text(lobe) for lobe in lobes) or str(material)


def lobe_text(lobe):
    """Model, widths, and whether it lets light through."""
    mx, my = lobe.get("mx", lobe.get("m")), lobe.get("my", lobe.get("m"))
    width = "" if mx is None else f" {mx:.4g}" + (f"x{my:.4g}" if my != mx else "")
    return lobe.get("model", "?") + width + (" through" if "kt" in lobe else "")
