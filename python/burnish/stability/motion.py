"""What moves by less than a pixel, or changes by less than a person notices: does the picture stay as still as it should?

Flicker is the RMS of the temporal second difference of the error (measures.py). The truth of every frame is dense, with hundreds
of filtered samples, whose own error is the same from frame to frame.
"""

from __future__ import annotations

import numpy as np

from . import panels, scenes
from .case import Outcome, case
from .measures import difference, flicker
from .room import pinhole, way_to_ball

FRAMES = 5
TRUTH = {"estimator": "filtered_importance", "samples": 512}
MATERIAL = scenes.lobe("ggx", 0.05)
SEEN = 0.15
WHY = "Twice what it is today ({today}), and {part} of the one step that a person can see."


def lamps(d):
    """Light of smooth waves and three lamps with soft edges, 4 to 10 degrees wide: all of it can be integrated well."""
    light = 0.5 + 0.4 * np.sin(5 * d[..., 0] + 1) * np.cos(4 * d[..., 1])
    for middle, sharpness, strength in (((0.3, 0.6, 0.8), 200, 30), ((-0.6, 0.2, 0.7), 400, 20), ((0.7, -0.3, 0.3), 60, 5)):
        light = light + strength * np.exp(sharpness * (d @ scenes.unit(middle) - 1))
    return light


def ball_from(eye, width=112, height=84):
    """A unit ball that fills the height, seen from any place; and where it is, two pixels from its outline."""
    camera = {"position": list(eye), "look_at": [eye[0], eye[1], 0], "up": [0, 1, 0], "fov_x_deg": 26}
    d = pinhole(camera, width, height)
    way = way_to_ball(np.asarray(eye), d, (0, 0, 0), 1)
    place = np.where(way < np.inf, np.asarray(eye) + np.minimum(way, 1e3) * d, 0)
    mask = np.pad(way[..., 0] < np.inf, 2)
    inside = np.lib.stride_tricks.sliding_window_view(mask, (5, 5)).all((2, 3))
    return scenes.surface(place, place), inside


def _still(shots):
    """The outcome of frames: (arguments of `scenes.overlay`, settings, mask) one after the other."""
    def run(**settings):
        return [scenes.overlay(*arguments, **more, **settings) for arguments, more, _ in shots]

    masks = [mask for *_, mask in shots]
    truth, dense, sparse = run(**TRUTH), run(), run(density="sparse")
    exposure = panels.exposure_of(truth[0][masks[0]])
    errors = [difference(picture, true, exposure) * mask[..., None] for picture, true, mask in zip(sparse, truth, masks)]
    bend = errors[0] - 2 * errors[1] + errors[2]
    figure = flicker(sparse, truth, masks)
    return Outcome(figure, panels.beside(panels.compared(sparse[1], truth[1], 8), 0.5 + 0.5 * bend),
                   "burnish | truth | difference, times 8 | its second difference in time, two display steps over the greys",
                   (("sparse", figure), ("dense", flicker(dense, truth, masks)),
                    ("largest bend of one pixel", float(np.abs(bend).max()))))


@case("motion-of-camera", "Do reflections flicker while the camera moves by an eighth of a pixel a frame?",
      "display steps", why=WHY.format(today="0.074, dense 0.058", part="a seventh"), at_most=0.15)
def motion_of_camera():
    """Right and up."""
    light = scenes.environment(scenes.sky(lamps, 256))
    pixel = 2 * 6 * np.tan(np.radians(13)) / 112
    shots = []
    for frame in range(FRAMES):
        eye = (pixel * frame / 8, pixel * frame / 16, 6.0)
        ball, mask = ball_from(eye)
        shots.append(((ball, light, MATERIAL), {"camera": eye}, mask))
    return _still(shots)


@case("motion-of-light", "Do reflections flicker while the light turns by a tenth of a degree a frame?",
      "display steps", why=WHY.format(today="0.025, dense 0.009", part="a twentieth"), at_most=0.05)
def motion_of_light():
    """About the vertical; a texel of the map is 0.7 degrees wide."""
    ball, mask = ball_from(scenes.CAMERA)
    picture = scenes.sky(lamps, 256)
    lights = [scenes.environment(picture, env_rotate=0.1 * frame) for frame in range(FRAMES)]
    return _still([((ball, light, MATERIAL), {}, mask) for light in lights])


@case("motion-of-roughness", "Do reflections flicker while the roughness rises by a hundredth of itself a frame?",
      "display steps", why=WHY.format(today="0.048, dense 0.015", part="a tenth"), at_most=0.1)
def motion_of_roughness():
    """Every frame has tables and predictions of its own."""
    ball, mask = ball_from(scenes.CAMERA)
    light = scenes.environment(scenes.sky(lamps, 256))
    lobes = [scenes.lobe("ggx", 0.05 * 1.01**frame) for frame in range(FRAMES)]
    return _still([((ball, light, lobe), {}, mask) for lobe in lobes])
