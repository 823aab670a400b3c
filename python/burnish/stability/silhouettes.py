"""Where surfaces end inside a pixel, or are hardly wider than one: averaged normals, and wires."""

from __future__ import annotations

import numpy as np

from . import panels, scenes
from .case import Outcome, case
from .measures import difference, psnr
from .motion import lamps

FINE, SIZE = 4, 48
MATERIAL = scenes.lobe("ggx", 0.05)


def means(image):
    """Of every pixel's FINE x FINE samples."""
    height, width = image.shape[0] // FINE, image.shape[1] // FINE
    return image.reshape(height, FINE, width, FINE, -1).mean((1, 3))


def brightest_around(image):
    """Of the samples of every pixel and its eight neighbours."""
    height, width = image.shape[0] // FINE, image.shape[1] // FINE
    own = np.pad(image.reshape(height, FINE, width, FINE, -1).max((1, 3)), ((1, 1), (1, 1), (0, 0)))
    return np.lib.stride_tricks.sliding_window_view(own, (3, 3), (0, 1)).max((-2, -1))


def averaged(frame):
    """As a renderer averages the samples of a pixel: positions and normals alike, nothing made unit again."""
    return scenes.surface(means(frame["position"]), means(frame["normal"]))


def ball_before_wall():
    """A ball, FINE samples to a pixel, before a wall that faces the camera; and which samples are the ball."""
    ball = scenes.sphere(SIZE * FINE)
    hit = ball["position"].any(-1, keepdims=True)
    x = 1.2 * ((2 * np.arange(SIZE * FINE) + 1) / (SIZE * FINE) - 1)
    wall = np.stack([*np.meshgrid(x, -x), np.full((len(x), len(x)), -1.0)], -1)
    both = scenes.surface(np.where(hit, ball["position"], wall), np.where(hit, ball["normal"], [0.0, 0, 1]))
    return both, hit


@case("averaged-normals-over-nothing",
      "Do pixels at a silhouette over nothing, whose normals are short, sparkle?",
      "display steps above the brightest sample around",
      why="An average of the normals of one smooth surface lies between them, so nothing may shine that no sample shows; one step "
          "is what rounding may do.",
      at_most=1)
def over_nothing():
    """The ball alone: normals of an edge pixel are short, and so are its positions."""
    light, fine = scenes.environment(scenes.sky(lamps, 256)), scenes.sphere(SIZE * FINE)
    samples = scenes.overlay(fine, light, MATERIAL)
    result, truth = scenes.overlay(averaged(fine), light, MATERIAL), means(samples)
    exposure = panels.exposure_of(truth)
    edge = (0 < truth.any(-1)) & ~fine["normal"].any(-1).reshape(SIZE, FINE, SIZE, FINE).all((1, 3))
    return Outcome(float(difference(result, brightest_around(samples), exposure).max()),
                   panels.compared(result, truth, 2, 3), "burnish | mean of 16 samples | difference, times 2",
                   (("brightest of edge pixels above the mean, steps", float(difference(result, truth).max())),
                    ("dB of edge pixels", psnr(result, truth, edge))))


@case("averaged-normals-between-surfaces",
      "How wrong are pixels that average the normals of a ball and the wall behind it, where a lamp is seen in between?",
      "dB of the edge pixels",
      why="20.2 dB today: one average cannot say what two surfaces reflect. Finer AOVs can, so a lower figure would only be tolerated "
          "as a rounding of half a decibel.",
      at_least=19.7)
def between_surfaces():
    """An average that no surface has may reflect a lamp that neither sees; AOVs finer than the frame have none of it."""
    light = scenes.environment(scenes.sky(lamps, 256))
    fine, hit = ball_before_wall()
    samples = scenes.overlay(fine, light, MATERIAL)
    result, truth = scenes.overlay(averaged(fine), light, MATERIAL), means(samples)
    part = means(hit)[..., 0]
    edge = (0 < part) & (part < 1)
    above = difference(result, brightest_around(samples), panels.exposure_of(truth)).max(-1)
    surfaces = {role: fine[role] for role in ("position", "normal")}
    remedy = scenes.overlay({"beauty": np.zeros_like(result, np.float32)}, light, MATERIAL, fine_aovs=surfaces, filter="box")
    return Outcome(psnr(result, truth, edge), panels.compared(result, truth, 2, 3),
                   "burnish | mean of 16 samples | difference, times 2",
                   (("sparkling pixels, of 100 at the edge", 100 * float((above > 1).sum() / edge.sum())),
                    ("with fine AOVs, dB", psnr(remedy, truth, edge))))


def wires(size=128):
    """Straight wires 1, 2 and 3 pixels wide at five angles before a wall: the frame, and where each is."""
    x = (2 * np.arange(size) + 1) / size - 1
    place = np.stack([*np.meshgrid(x, -x), np.zeros((size, size))], -1)
    normal, mask = np.broadcast_to(np.array([0.0, 0, 1]), place.shape).copy(), np.zeros((size, size), bool)
    for i, angle in enumerate(np.radians([3, 40, 75, 110, 150])):
        for width in (1, 2, 3):
            across = np.array([np.sin(angle), -np.cos(angle), 0])
            away = (place @ across - 0.45 * (width - 2) - 0.06 * i) * size / (2 * width)
            here = (np.abs(away) < 0.5) & ~mask
            lean = 1.9 * away[here, None]
            normal[here] = lean * across + np.sqrt(1 - lean**2) * [0, 0, 1]
            mask |= here
    return scenes.surface(place, normal), mask


@case("thin-wires",
      "Does sparse shading show wires one to three pixels wide as dense does, and leak nothing beside them?",
      "display steps",
      why="Nothing is to be seen: one step of a display.",
      at_most=1)
def thin_wires():
    """Polished wires before nothing, a rough wall, and one that is as polished."""
    frame, mask = wires()
    light = scenes.environment(scenes.sky(lamps, 256))
    polished, wire = scenes.lobe("ggx", 0.05), mask.astype(np.float32)
    worn = {"before nothing": ({"wire": polished}, {"wire": wire}),
            "before a wall": ({"wire": polished, "wall": scenes.lobe("ggx", 0.3)}, {"wall": 1 - wire, "wire": wire}),
            "before a wall of the same": (polished, None)}
    found = {}
    for name, (materials, masks) in worn.items():
        dense, sparse = (scenes.overlay(frame, light, materials, assign=masks, density=density) for density in ("dense", "sparse"))
        found[name] = float(np.abs(difference(sparse, dense)).max())
    return Outcome(max(found.values()), panels.compared(sparse, dense, 20), "sparse | dense | difference, times 20; all of one lobe",
                   tuple(found.items()))
