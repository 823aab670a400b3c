"""Wide lobes with few lookups: where the sources see their sampling pattern in the picture, as ghosts of every bright spot.

A pattern is error that changes from one pixel to the next, so the first figure is the error's second difference as an 8-bit display
shows it; the second is the error itself. The reference's own noise is taken out of both. The third is what fits of lobes may do that
no light does: fall below zero, as some of their Gaussians do.
"""

from __future__ import annotations

import functools

import numpy as np

from ..charting import benchmark, measure
from . import panels, scenes
from .case import Outcome, case

MODELS, WIDTHS, LOOKUPS = ("beckmann", "ggx"), (0.4, 0.6), (3, 5, 7)
ESTIMATORS = ("fitted", "regular", "filtered_importance")
SIZE, APART = 32, 2  # pixels of the sphere, and between those whose errors are compared


@functools.cache
def spheres():
    """(estimator, model, m, lookups) -> what it shows; (model, m) -> the reference's layers."""
    light, frame = scenes.environment(benchmark.stress_light(1, 128)), scenes.sphere(SIZE)
    shown, truths = {}, {}
    for model in MODELS:
        for m in WIDTHS:
            lobe = scenes.lobe(model, m)
            truths[model, m] = scenes.layers(frame, light, lobe, estimator="reference", tolerance=0.015)
            for name in ESTIMATORS:
                for n in LOOKUPS:
                    shown[name, model, m, n] = scenes.overlay(frame, light, lobe, estimator=name, samples=n)
    return shown, truths


def covered():
    """The sphere's pixels."""
    return scenes.view_cosines(scenes.sphere(SIZE)) > 0


def ripple(result, layers):
    """RMS of the second difference of the error across and down, in steps of 255."""
    truth, inside = layers["overlay"].astype(np.float64), covered()
    exposure = panels.exposure_of(truth[inside])
    error = 255 * (measure.encode(exposure * result) - measure.encode(exposure * truth))
    known = measure.truth_of(layers, inside)
    noise = 255 * exposure * known.noise * measure.encoding_slope(exposure * known.radiance)
    squares = []
    for turned, mask in ((error, inside), (error.swapaxes(0, 1), inside.T)):
        whole = mask[:, : -2 * APART] & mask[:, APART:-APART] & mask[:, 2 * APART :]
        bend = turned[:, : -2 * APART] - 2 * turned[:, APART:-APART] + turned[:, 2 * APART :]
        squares.append(measure.mean_square(bend[whole]))
    return float(np.sqrt(max(np.mean(squares) - 6 * measure.mean_square(noise), 0)))  # 6 = 1 + 4 + 1


def psnr_db(result, layers):
    """Display PSNR of the sphere."""
    inside = covered()
    return float(measure.truth_of(layers, inside).psnr_db(result[inside]))


def outcome(measured, worst):
    """The default's worst of all widths and numbers of lookups, and its picture."""
    shown, truths = spheres()
    found = {key: measured(result, truths[key[1:3]]) for key, result in shown.items()}
    key = worst((key for key in found if key[0] == "fitted"), key=found.get)
    details = tuple((f"{name}, {n} lookups: worst", worst(found[k] for k in found if k[0] == name and k[3] == n))
                    for name in ESTIMATORS for n in LOOKUPS)
    truth = truths[key[1:3]]["overlay"].astype(np.float64)
    return Outcome(found[key], panels.compared(shown[key], truth, 4, 4), f"{key[1]} {key[2]:g}, {key[3]} lookups: result, reference, "
                   "4 x difference", details)


@case("wide-lobe-pattern", "Does the pattern of 3 to 7 lookups show on lobes of m 0.4 to 0.6?", "display steps of 255",
      why="a third above docs/measured.md (8.9), and below what any other estimator does with as many lookups (10.9)", at_most=11.8)
def wide_lobe_pattern():
    return outcome(ripple, max)


@case("negative-light", "Does the fit of a wide lobe show less than no light?", "of the mean",
      why="lobes add light or none, whatever the weights of their fits; it was 0.7, a black blot", at_most=0)
def negative_light():
    """The most negative pixel of spheres under another light; 0 where there is none."""
    light, frame, inside = scenes.environment(benchmark.stress_light(4, 128)), scenes.sphere(SIZE), covered()
    found = {}
    for model, m in (("beckmann", 0.4), ("kurt", 0.4), ("kurt", 0.6)):
        for n in LOOKUPS:
            found[model, m, n] = scenes.overlay(frame, light, scenes.lobe(model, m), samples=n)
    figures = {key: float(max(-result[inside].min() / result[inside].mean(), 0)) for key, result in found.items()}
    shown = found[max(figures, key=figures.get)]
    return Outcome(max(figures.values()), panels.compared(shown, np.maximum(shown, 0), 4, 4), "the worst: result, without what is "
                   "negative, 4 x difference", tuple((f"{model} {m:g}, {n} lookups", value) for (model, m, n), value in figures.items()))


@case("wide-lobe-error", "How far off are lobes of m 0.4 to 0.6 with 3 to 7 lookups?", "dB",
      why="1 dB below docs/measured.md (28.4); the best of the others reaches 25 to 29 with as many lookups", at_least=27.4)
def wide_lobe_error():
    return outcome(psnr_db, min)
