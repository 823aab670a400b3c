"""One lookup a pixel: the fewest there can be. The picture is coarse, but its mean is the light's, and nothing breaks."""

from __future__ import annotations

import numpy as np

from ..charting import benchmark
from . import panels, scenes
from .case import Outcome, case

LOBES = (scenes.lobe("beckmann", 0.05), scenes.lobe("ggx", 0.2), scenes.lobe("kurt", 0.1, 0.03))
SIZE = 24


def outcome(names):
    """The worst of these estimators on all lobes."""
    light, frame = scenes.environment(benchmark.stress_light(1, 128)), scenes.sphere(SIZE)
    inside = scenes.view_cosines(frame) > 0
    figures, pictures = {}, []
    for lobe in LOBES:
        truth = scenes.reference(frame, light, lobe, tolerance=0.02)
        row = [scenes.overlay(frame, light, lobe, estimator=name, samples=1) for name in names]
        for name, result in zip(names, row):
            error = abs(float(result[inside].mean() / truth[inside].mean()) - 1)
            figures[f"{name}, {lobe['model']} {lobe['mx']:g}"] = error if np.isfinite(result).all() else np.inf
        shown = panels.exposure_of(truth)
        pictures.append(panels.beside(*(panels.enlarged(panels.encode(shown * panel), 3) for panel in (truth, *row))))
    return Outcome(max(figures.values()), np.concatenate(pictures), "Beckmann 0.05, GGX 0.2, Kurt 0.1 x 0.03: reference, " + ", ".join(names),
                   tuple(figures.items()))


@case("one-lookup", "Is the mean of a sphere right with one lookup a pixel?", "of the mean",
      why="a third above docs/measured.md (10 %)", at_most=0.137)
def one_lookup():
    return outcome(("fitted", "regular"))


@case("one-sample", "Is the mean of a sphere right with one importance sample a pixel?", "of the mean",
      why="a third above docs/measured.md (9.1 %)", at_most=0.122)
def one_sample():
    return outcome(("filtered_importance", "preconvolved"))
