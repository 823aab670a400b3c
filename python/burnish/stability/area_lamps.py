"""Area lights where formulas divide by nothing: lamps seen edge-on, standing on the surface, lying in it, below its horizon."""

from __future__ import annotations

import numpy as np

from . import panels, scenes
from .case import Outcome, case
from .measures import psnr

SEEN = {
    "standing on the floor": [[-0.4, 0, -3], [0.4, 0, -3], [0.4, 1, -3], [-0.4, 1, -3]],
    "through the floor": [[-0.4, -0.5, -3], [0.4, -0.5, -3], [0.4, 0.5, -3], [-0.4, 0.5, -3]],
    "edge-on to the eye": [[0, 0.2, -2.6], [0, 0.8, -2.6], [0, 0.8, -3.6], [0, 0.2, -3.6]],
    "close over the floor": [[-0.4, 0.05, -2.6], [0.4, 0.05, -2.6], [0.4, 0.05, -3.2], [-0.4, 0.05, -3.2]],
}
HIDDEN = {
    "lying in the floor": [[-0.4, 0, -2.6], [0.4, 0, -2.6], [0.4, 0, -3.2], [-0.4, 0, -3.2]],
    "under the floor": [[-0.4, -0.1, -2.6], [0.4, -0.1, -2.6], [0.4, -0.1, -3.2], [-0.4, -0.1, -3.2]],
    "in the floor and under it": [[-0.4, 0, -3], [0.4, 0, -3], [0.4, -1, -3], [-0.4, -1, -3]],
}
"""Corners of lamps before an eye at (0, 1, 0) that looks along -z at the floor y = 0."""

WIDTHS = (0.02, 0.1, 0.3)


def lit_by(corners, m, estimator, size=(32, 24)):
    """The floor under one lamp that shines to both sides."""
    frame, eye = scenes.floor(*size, top_deg=8, bottom_deg=35)
    lamp = {"type": "area", "corners": corners, "radiance": 10, "two_sided": True}
    return scenes.overlay(frame, None, scenes.lobe("ggx", m), lights={"lamp": lamp}, camera=eye, up="y", estimator=estimator,
                          tolerance=0.03, max_samples=512)


@case("lamps-at-the-surface", "Are lamps right that touch the surface, cut it, or are seen edge-on?", "dB",
      why="41.7 today, at a lamp that a polished floor sees edge-on; 42.2 against a reference of four times the samples, where the "
          "others rise to 43 and 57.",
      at_least=40)
def lamps_at_the_surface():
    """Against the reference, which knows rays and lamps only."""
    found, shown = {}, {}
    for name, corners in SEEN.items():
        for m in WIDTHS:
            result, truth = (lit_by(corners, m, estimator) for estimator in ("fitted", "reference"))
            found[f"{name}, m {m}"] = psnr(result, truth)
            shown[name] = panels.compared(result, truth, 8, 4)
    return Outcome(min(found.values()), shown["standing on the floor"],
                   "burnish | reference | difference, times 8; standing on the floor, m 0.3", tuple(found.items()))


@case("lamps-below-the-horizon", "Does light leak from lamps under the surface, or in it?", "radiance, of a lamp of 10",
      why="No ray from the surface meets them.", at_most=0)
def lamps_below_the_horizon():
    """The brightest pixel of each; the picture is of half a lamp that is above."""
    found = {f"{name}, m {m}": float(np.abs(lit_by(corners, m, "fitted")).max()) for name, corners in HIDDEN.items() for m in WIDTHS}
    below = lit_by(HIDDEN["in the floor and under it"], 0.1, "fitted")
    above = lit_by(SEEN["through the floor"], 0.1, "fitted")
    return Outcome(max(found.values()), panels.compared(below + above, above, 8, 4),
                   "a lamp through the floor and one under it | the first alone | difference, times 8", tuple(found.items()))
