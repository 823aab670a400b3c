"""Numbers at their limits: coarse positions, tiny frames, enormous and tiny units, and any number of threads."""

from __future__ import annotations

import tempfile

import numpy as np

from ..charting import benchmark
from ..charting.measure import encode
from . import panels, scenes
from .case import Outcome, case
from .measures import difference, psnr
from .motion import lamps
from .room import Room

WALLS = Room(low=(-3, -3, -3), high=(4, 4, 4))
CENTRE = (0.0, 0.0, 2.0)
LAMP = [[-2.0, 1, 3], [0, 1, 3], [0, 3, 3], [-2, 3, 3]]


def placed(size, scale=1.0, offset=(0, 0, 0)):
    """The unit ball and what stands around it, in other units and at another place: the frame, and a maker of the lights' settings."""
    ball, offset = scenes.sphere(size), np.asarray(offset, np.float64)
    hit = ball["normal"].any(-1, keepdims=True)
    frame = scenes.surface(np.where(hit, ball["position"] * np.float64(scale) + offset, 0), ball["normal"])

    def moved(point):
        return (scale * np.asarray(point, np.float64) + offset).tolist()

    def lights(folder):
        room = WALLS.cube_map(folder, CENTRE, {"box": {"min": moved(WALLS.low), "max": moved(WALLS.high)}}, 128)
        lamp = {"type": "area", "corners": [moved(corner) for corner in LAMP], "radiance": 5, "two_sided": True}
        return {"lights": {"room": {**room, "centre": moved(CENTRE)}, "lamp": lamp}, "default_light": ["lamp", "room"], "up": "y"}

    return frame, lights, {"camera": tuple(moved(scenes.CAMERA))}


def under_both(frame, lights, settings, lobe):
    """The overlays under a distant light, and under a room with a lamp."""
    with tempfile.TemporaryDirectory() as folder:
        near = scenes.overlay(frame, None, lobe, **settings, **lights(folder))
    return {"distant": scenes.overlay(frame, scenes.environment(scenes.sky(lamps, 128)), lobe, **settings), "near": near}


@case("half-float-positions", "How much of the reflection is lost where positions far from the origin are half floats?",
      "dB to float positions",
      why="Halves are 8 units apart here, a twelfth of the ball's radius: the view is off by up to 0.4 degrees and reflections of the "
          "the lamp, three radii away, by more. 42.8 dB today; 1 dB less would be a loss of the library's own.",
      at_least=42)
def half_float_positions():
    """A ball of radius 100 at (10000, 3000, -10000), sharp and dull, dense and sparse."""
    frame, lights, settings = placed(72, 100.0, (10000, 3000, -10000))
    coarse = {**frame, "position": frame["position"].astype(np.float16).astype(np.float32)}
    hit, found, shown = frame["normal"].any(-1), {}, None
    for m in (0.02, 0.1):
        fine = under_both(frame, lights, settings, scenes.lobe("ggx", m))
        for density in ("dense", "sparse"):
            rough = under_both(coarse, lights, {**settings, "density": density}, scenes.lobe("ggx", m))
            shown = panels.compared(rough["near"], fine["near"], 8, 2) if shown is None else shown
            found.update({f"{name}, m {m}, {density}": psnr(rough[name], fine[name], hit) for name in fine})
    return Outcome(min(found.values()), shown, "half floats | floats | difference, times 8; near lights, m 0.02", tuple(found.items()))


@case("scene-units", "Is a scene the same in any unit, from a millionth to a million?", "display steps",
      why="Half a step is what no display shows; 0.37 today, at a millionth under near lights.", at_most=0.5)
def scene_units():
    """Frame, room and lamp, scaled."""
    found, lobe, shown = {}, scenes.lobe("ggx", 0.05), []
    known = under_both(*placed(72), lobe)
    for scale in (1e-6, 1e-3, 1e3, 1e6):
        scaled = under_both(*placed(72, scale), lobe)
        found.update({f"{name}, times {scale:g}": float(np.abs(difference(scaled[name], known[name])).max()) for name in known})
        shown.append(encode(panels.exposure_of(known["near"]) * scaled["near"]))
    return Outcome(max(found.values()), panels.beside(*shown), "units of 1e-6 | 1e-3 | 1e3 | 1e6", tuple(found.items()))


SHAPES = {"one pixel": np.s_[16:17, 10:11], "a row": np.s_[16:17, :], "a column": np.s_[:, 16:17], "background": np.s_[:1, :1]}


@case("one-pixel-frames", "Are pixels the same in frames that are one pixel wide, high or both?", "pixels that are not",
      why="A pixel is shaded from its own surface: the same bits in any frame. The reference draws by place: 5 of its own standard "
          "errors, which one of a million exceeds.",
      at_most=0)
def one_pixel_frames():
    """Parts of a frame, by every estimator, dense and sparse; sparse has nothing to interpolate here."""
    frame, lights, settings = placed(33)
    light, lobe, found = scenes.environment(scenes.sky(lamps, 128)), scenes.lobe("ggx", 0.1), {}
    whole = {}
    for estimator in (*benchmark.LOOKUPS, "reference"):
        run = {**settings, "estimator": estimator, "tolerance": 0.1}
        whole[estimator] = scenes.layers(frame, light, lobe, **run)
        allowed = 5 * whole[estimator].get("error", np.zeros(frame["normal"].shape[:2]))
        found[estimator] = 0
        for part in SHAPES.values():
            for density in ("dense",) if estimator == "reference" else ("dense", "sparse"):
                alone = scenes.layers({role: np.ascontiguousarray(array[part]) for role, array in frame.items()}, light, lobe,
                                      **{**run, "density": density})
                away = np.abs(alone["overlay"] - whole[estimator]["overlay"][part]).max(-1)
                found[estimator] += int((~(away <= allowed[part] + 5 * alone.get("error", 0))).sum())
    shown = [panels.enlarged(encode(0.3 * whole[name]["overlay"]), 3) for name in ("fitted", "regular", "reference")]
    return Outcome(sum(found.values()), panels.beside(*shown), "the whole frame by fitted | regular | reference", tuple(found.items()))


@case("threads", "Does the number of threads show?", "values that differ", why="The same job gives the same bits.", at_most=0)
def threads():
    """Sparse shading of a frame of several bands, under distant and near lights, by one thread and by more."""
    frame, lights, settings = placed(156)
    settings, lobe = {**settings, "density": "sparse"}, scenes.lobe("ggx", 0.1)
    one = under_both(frame, lights, {**settings, "threads": 1}, lobe)
    found = {}
    for count in (2, 3):
        more = under_both(frame, lights, {**settings, "threads": count}, lobe)
        found.update({f"{name}, {count} threads": int((more[name] != one[name]).sum()) for name in one})
    return Outcome(sum(found.values()), panels.compared(more["near"], one["near"]), "three threads | one | difference, times 8",
                   tuple(found.items()))
