"""Seams of the cube: light that changes smoothly must not jump or bend where one face ends and the next begins.

Facets seen along their normals walk in small steps over an edge and past a corner of the cube under smooth light.
"""

from __future__ import annotations

import numpy as np

from . import panels, scenes
from .case import Outcome, case

STEP_DEG = 0.5
WALKS = {"edge": ((1, 0.15, 1), (1, 0, -1)), "corner": ((1, 1, 1), (1, -0.6, -0.4))}
"""Name -> where a walk is half way, and where it is going."""
WIDTHS = (0.02, 0.1, 0.3)
ESTIMATORS = {"fitted": 0, "regular": 0, "filtered_importance": 16, "preconvolved": 16, "split_sum": 0}


def smooth(d):
    """Light without edges that changes by half within a face."""
    x, y, z = np.moveaxis(d, -1, 0)
    return 2 + 0.8 * x * z + 0.5 * y - 0.4 * x * y + 0.3 * z


def walk(name, steps=161):
    """Normals along a great circle, `steps` of STEP_DEG, the seam in the middle."""
    middle, aim = map(scenes.unit, WALKS[name])
    side = scenes.unit(aim - middle * (aim @ middle))
    angle = np.radians(STEP_DEG) * (np.arange(steps) - steps // 2)[:, None]
    return np.cos(angle) * middle + np.sin(angle) * side


def bends(shown):
    """Second difference at every step as a display shows it, in steps of 255."""
    return np.abs(np.diff(255 * panels.encode(panels.exposure_of(shown) * shown), 2))


@case("cube-seams", "Does smooth light jump or bend where two faces of the cube meet?", "display steps of 255",
      why="twice docs/measured.md (0.024); a display hides half a step", at_most=0.05)
def cube_seams():
    """The largest bend of all walks, widths and estimators."""
    light = scenes.environment(scenes.sky(smooth, 128))
    figures, pictures = {}, []
    for place in WALKS:
        normal = walk(place)
        frame = scenes.facets(normal[None], normal[None])
        for m in WIDTHS:
            for name, samples in ESTIMATORS.items():
                shown = scenes.overlay(frame, light, scenes.lobe("beckmann", m), estimator=name, samples=samples)[0, :, 0]
                figures[place, name, m] = float(bends(shown).max())
                if name == "fitted":
                    pictures.append(panels.curves([shown, 2 + bends(shown)], 1.5, 3, 100, 150))
    return Outcome(max(figures.values()), np.concatenate([panels.beside(*pictures[:3]), panels.beside(*pictures[3:])]),
                   "over an edge and past a corner below each other, m 0.02, 0.1, 0.3: brightness black; its bend in display steps red",
                   tuple((f"{name}, m {m:g}, {place}", value) for (place, name, m), value in figures.items()))
