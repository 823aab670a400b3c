"""Light as it comes: texels that are not numbers, infinite or negative, pictures of one texel, no light at all, and light whose
numbers are tiny or huge.
"""

from __future__ import annotations

import numpy as np

from . import panels, scenes
from .case import Outcome, case

ESTIMATORS = ("fitted", "regular", "filtered_importance", "preconvolved", "split_sum", "reference")
LOBE = scenes.lobe("ggx", 0.1)
SIZE = 24


def shown(light, **settings):
    """A sphere by every estimator, (estimators, size, size, 3)."""
    frame, light = scenes.sphere(SIZE), scenes.environment(light)
    return np.array([scenes.overlay(frame, light, LOBE, estimator=name, max_samples=1024, **settings) for name in ESTIMATORS])


def hall(d):
    """A lamp in a sky that fades downwards, coloured."""
    lamp = scenes.spots([((0.4, 0.5, 0.9), 12, 40)], 0)(d)
    return (1 + 0.5 * d[..., 1:2]) * np.array([0.8, 1, 1.2]) + lamp[..., None]


def worst_beside(result, truth, times=3):
    """Two rows of spheres, and the difference."""
    pictures = [panels.enlarged(panels.compared(a, b, 8), times) for a, b in zip(result, truth)]
    return np.concatenate([panels.beside(*pictures[i : i + 2]) for i in range(0, len(pictures), 2)])


def relative(result, truth):
    """The largest error over the largest value; infinite where something is not a number."""
    error = np.abs(result - truth).max() / np.abs(truth).max()
    return float(error) if np.isfinite(result).all() else np.inf


@case("broken-texels", "Do texels of light that are NaN, infinite or negative stay where they are?", "of the brightest",
      why="the same light, so exact; room for sums in another order", at_most=1e-6)
def broken_texels():
    """The same light with those texels as they are said to be read: NaN and negative ones black, infinite ones the largest finite."""
    whole = scenes.sky(hall, 64)
    broken, mended = whole.copy(), whole.copy()
    for y, x, value, read in ((20, 40, np.nan, 0), (31, 90, np.inf, whole.max()), (40, 64, -5, 0), (0, 0, -np.inf, 0)):
        broken[y, x], mended[y, x] = value, read
    result, truth = shown(broken), shown(mended)
    return Outcome(relative(result, truth), worst_beside(result, truth, 2), "by " + ", ".join(ESTIMATORS) + ": result, mended light, difference")


@case("no-light", "Is black light, and light that is nothing but NaN, black everywhere?", "radiance", why="what is lit by nothing is black, exactly", at_most=0)
def no_light():
    pictures = [np.zeros((8, 16, 3), np.float32), np.zeros((1, 2, 3), np.float32), np.full((4, 8, 3), np.nan, np.float32)]
    found = np.array([shown(picture) for picture in pictures])
    figure = float(np.abs(found).max()) if np.isfinite(found).all() else np.inf
    lit = shown(scenes.sky(hall, 64))
    return Outcome(figure, worst_beside(found[0], lit, 2), "no light, and light to compare with")


@case("one-texel", "Is light of one texel the same from everywhere?", "of the brightest",
      why="rounding of a float, ten times", at_most=1e-6)
def one_texel():
    """Pictures of 2 x 1 and 1 x 1 texels against a large one of the same colour."""
    colour = np.array([0.2, 1, 3], np.float32)
    truth = shown(np.broadcast_to(colour, (64, 128, 3)).copy())
    found = [shown(np.broadcast_to(colour, shape + (3,)).copy()) for shape in ((1, 2), (1, 1))]
    return Outcome(max(relative(result, truth) for result in found), worst_beside(found[0], truth, 2), "2 x 1 texels, 128 x 64 texels, difference")


@case("light-scale", "Does the overlay scale with light of 1e-20 and 1e20?", "of the brightest",
      why="rounding of a float, ten times; the overlay is linear in the light", at_most=1e-6)
def light_scale():
    """The pictures themselves hold such numbers; suns among them."""
    picture = scenes.sky(scenes.spots([((0.4, 0.5, 0.9), 1.5, 5000)]), 128)
    truth = shown(picture)
    details, results = [], []
    for scale in (1e-30, 1e-20, 1e-6, 1e6, 1e20, 1e30):
        results.append(shown((picture * np.float32(scale)).astype(np.float32)) / scale)
        details += [(f"{name}, {scale:g}", relative(a, b)) for name, a, b in zip(ESTIMATORS, results[-1], truth)]
    return Outcome(max(relative(result, truth) for result in results), worst_beside(results[0], truth, 2), "by " + ", ".join(ESTIMATORS) + ": light times 1e-30, the light itself, difference",
                   tuple(details))
