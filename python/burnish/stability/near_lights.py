"""Cube maps and mirrors: where what stands for the room changes, ends, or hides something."""

from __future__ import annotations

import tempfile

import numpy as np

from . import panels, scenes
from .case import Outcome, case
from .measures import difference, psnr
from .room import Room

HALL = {"low": (-2, 0, -6), "high": (2, 3, 2)}
"""A room whose floor y = 0 is the mirror."""
CENTRE = (0, 1.5, -2)
BALL = {"ball": (0.15, 0.55, -3.4), "radius": 0.4, "glow": 2.5}


@case("plane-switch-tears",
      "Does the overlay jump where the wall that reflected rays end on changes?",
      "display steps between neighbouring pixels",
      why="A tear is as large at any resolution; of the smooth error these 1024 pixels, 0.14 degrees apart, show 0.24 at most, so "
          "half a step is a tear.",
      at_most=0.5)
def plane_switch():
    """Normals along a curve whose reflections cross from wall to floor, wall, ceiling and wall again."""
    turn = np.sin(np.radians(np.linspace(-70, 70, 1024)))
    normal = scenes.unit(np.stack([turn, 0.1 + 0.35 * turn, np.sqrt(1 - turn**2)], -1))[None]
    frame, room, jumps = scenes.surface(normal, normal), Room(), {}
    with tempfile.TemporaryDirectory() as folder:
        light = room.cube_map(folder, (0.3, 0.2, 1.6), {"planes": room.planes()})
        for m in (0.05, 0.1, 0.2, 0.4):
            truth = room.reflection(frame, scenes.lobe("ggx", m), scenes.CAMERA)
            result = scenes.overlay(frame, None, scenes.lobe("ggx", m), lights={"room": light}, up="y")
            jumps[m] = float(np.abs(np.diff(difference(result, truth), axis=1)).max())
            if m == 0.1:
                shown = [panels.curves([truth[0, :, 0], result[0, :, 0]], 0, 1),
                         panels.curves([0.05 * difference(result, truth)[0, :, 0]], -0.5, 0.5)]
    return Outcome(max(jumps.values()), panels.beside(*shown),
                   "radiance along the curve (black: truth, red: burnish) | difference, 20 display steps over the height; m 0.1",
                   tuple((f"m {m}", jump) for m, jump in jumps.items()))


def _on_the_floor(hall, lobe, lights, width=64):
    """What lights by name make of a floor, and the truth."""
    frame, eye = scenes.floor(width, 3 * width // 4, top_deg=11, bottom_deg=28)
    result = scenes.overlay(frame, None, lobe, lights=lights(eye), default_light=list(lights(eye)), camera=eye, up="y")
    return result, hall.reflection(frame, lobe, eye)


@case("mirror-depth-edges",
      "What does a mirror's picture make of a bright ball before a wall, where cones of rays meet both?",
      "dB",
      why="A picture taken from one place does not know how wide a cone is at the ball when its middle passes beside it, nor the "
          "ball's far side, as the method's source says too. 29.1 dB today, at m 0.1; half a decibel less would be something new.",
      at_least=28.6)
def mirror_depth_edges():
    """A floor that reflects a ball which only the mirror's picture knows; a cube map holds the walls."""
    hall, found = Room(**HALL, **BALL), {}
    with tempfile.TemporaryDirectory() as folder:
        def lights(eye):
            return {"mirror": hall.mirror(folder, eye), "room": Room(**HALL).cube_map(folder, CENTRE, {"planes": hall.planes()})}

        for m in (0.01, 0.03, 0.1):
            result, truth = _on_the_floor(hall, scenes.lobe("ggx", m), lights)
            found[m] = psnr(result, truth)
    return Outcome(min(found.values()), panels.compared(result, truth, 4, 2), "burnish | truth | difference, times 4; m 0.1",
                   tuple((f"m {m}", value) for m, value in found.items()))


@case("mirror-unseen-regions",
      "Does the floor stay lit where its mirror's picture ends?",
      "display steps darker than the truth",
      why="1.3 today, which is the estimator's own error where the picture has everything (1.2); 130 if nothing took over.",
      at_most=2)
def mirror_unseen():
    """The picture of the mirror is smaller than the mirror; a cube map holds the rest."""
    hall, found = Room(**HALL), {}
    with tempfile.TemporaryDirectory() as folder:
        def lights(eye):
            return {"mirror": hall.mirror(folder, eye, 128, 128, fov_x_deg=11, look_at=(0.35, 0, -3)),
                    "room": hall.cube_map(folder, CENTRE, {"planes": hall.planes()})}

        for m in (0.01, 0.1, 0.2):
            result, truth = _on_the_floor(hall, scenes.lobe("ggx", m), lights)
            found[m] = float(-difference(result, truth).min())
    return Outcome(max(found.values()), panels.compared(result, truth, 20, 2), "burnish | truth | difference, times 20; m 0.2",
                   tuple((f"m {m}", value) for m, value in found.items()))
