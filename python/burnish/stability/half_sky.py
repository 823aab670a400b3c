"""Light with a hard edge, seen by whole lobes: half a sky, fifty times as bright as the other half.

Fitted Gaussians are the best for a lobe as a whole. Where most of it lies in the dark, what counts is how each of them ends, and
from one view to the next another fit may be the best one.
"""

from __future__ import annotations

import numpy as np

from ..charting.measure import encode
from . import panels, scenes
from .case import Outcome, case
from .measures import CODES

EDGE = scenes.unit((0.8, 0.3, 0.1))
LOBES = (scenes.lobe("ggx", 0.1), scenes.lobe("ggx", 0.2), scenes.lobe("ggx", 0.3), scenes.lobe("beckmann", 0.1))


def half_sky(d):
    """Radiance."""
    return np.where(d @ EDGE > 0.1, 1, 0.02)


def views(turn_deg, cosines):
    """One row of pixels: a normal that turns from the rim to the viewer, towards one side."""
    across, turn = np.sqrt(1 - cosines**2), np.radians(turn_deg)
    normal = np.stack([across * np.cos(turn), across * np.sin(turn), cosines], -1)
    return scenes.facets(normal[None], np.array([0.0, 0, 1]))


@case("lines-under-half-a-sky", "Does a line run where the fit of a lobe changes from one view to the next, in the dark half?",
      "display steps between views 0.002 apart in cosine",
      why="16.3 today, at ggx 0.3 seen at 77 degrees, where the truth is smooth to 0.3 steps; one step more would be a new line.",
      at_most=17.5)
def lines_under_half_a_sky():
    """Views from 84 degrees on, towards two sides; white is the bright half's radiance."""
    light, found, shown = scenes.environment(scenes.sky(half_sky, 256)), {}, None
    for lobe in LOBES:
        name = f"{lobe['model']} {lobe['mx']:g}"
        found[name] = 0.0
        for turn_deg in (200, 235):
            row = views(turn_deg, np.linspace(0.1, 0.98, 440))
            result = CODES * encode(scenes.overlay(row, light, lobe)[0, :, 0])
            truth = CODES * encode(scenes.overlay(row, light, lobe, estimator="filtered_importance", samples=512)[0, :, 0])
            jump = float(np.abs(np.diff(result - truth)).max())
            found[name] = max(found[name], jump)
            if jump >= max(found.values()):
                shown = panels.curves([truth, result], 0, 80, width=440)
    return Outcome(max(found.values()), shown, "display steps, 0 to 80, over the cosine of the view, 0.1 to 0.98; black: truth, red: burnish",
                   tuple(found.items()))
