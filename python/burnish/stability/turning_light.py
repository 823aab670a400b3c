"""Block shapes of filtered light: a cube map's texels and box filters are not the same every way, so a turning light may pulse.

Facets turn with the light about a slanting axis: nothing may change. Whatever does is the light's representation.
"""

from __future__ import annotations

import numpy as np

from . import panels, scenes
from .case import Outcome, case

AXIS = scenes.unit((0.3, 0.8, 0.5))
STEPS_DEG = np.arange(0, 45, 4.5)
WIDTHS = (0.03, 0.1, 0.3)
ESTIMATORS = {"fitted": 0, "regular": 0, "filtered_importance": 16, "preconvolved": 16, "split_sum": 0}
SPOTS = [((0.2, 0.5, 0.9), 8, 60), ((-0.6, 0.3, 0.4), 20, 10), ((0.3, -0.9, 0.5), 5, 100)]


def turn(degrees):
    """The matrix that turns columns about AXIS."""
    angle = np.radians(degrees)
    cross = np.cross(np.eye(3), -AXIS)
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def facets_on_spots():
    """Normals on the spots and on their slopes, (n, 3)."""
    centres = [scenes.unit(place[0]) for place in SPOTS]
    return np.array([scenes.unit(centre + offset * np.cross(centre, AXIS)) for centre in centres for offset in (-0.12, 0, 0.12)])


def turned():
    """(estimator, m) -> what facets show, (steps, facets, 3), as light and facets turn together; each is seen along its normal."""
    shown = {}
    for degrees in STEPS_DEG:
        matrix = turn(degrees)
        light = scenes.environment(scenes.sky(lambda d: scenes.spots(SPOTS)(d @ matrix), 128), env_suns="keep")
        normal = facets_on_spots() @ matrix.T
        frame = scenes.facets(normal[None], normal[None])
        for m in WIDTHS:
            for name, samples in ESTIMATORS.items():
                result = scenes.overlay(frame, light, scenes.lobe("beckmann", m), estimator=name, samples=samples)
                shown.setdefault((name, m), []).append(result[0])
    return {key: np.array(rows) for key, rows in shown.items()}


@case("turning-light", "Does filtered light pulse as it turns?", "of the brightness",
      why="below 1.8 %, which is one step of an 8-bit display at middle grey", at_most=0.018)
def turning_light():
    """The worst facet's RMS deviation from its mean over the turn."""
    figures, pictures = {}, []
    for (name, m), shown in turned().items():
        mean = shown.mean(0, keepdims=True)
        figures[name, m] = float(np.sqrt(np.mean((shown / mean - 1) ** 2, 0)).max())
        if name == "fitted":
            pictures.append(panels.compared(shown, np.broadcast_to(mean, shown.shape), 8, (4, 12)))
    return Outcome(max(value for (name, _), value in figures.items() if name == "fitted"), np.concatenate(pictures),
                   "facets from left to right, the light turns from top to bottom; m 0.03, 0.1, 0.3: result, its mean, 8 x difference",
                   tuple((f"{name}, m {m:g}", value) for (name, m), value in figures.items()))
