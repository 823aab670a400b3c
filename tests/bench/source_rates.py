"""Frames a second at the sources' sizes and counts of samples: surfaces and shading, what a GPU does in its fragment program.

Reading and writing files, the light's levels and the lobe's tables are not in them, as the sources keep theirs on the card.
"""

import json

import burnish
import numpy as np

import room
from source_setups import RATES, SCATTERGLOSS

SIZE, FULL_HD = (1680, 1050), (1920, 1080)
FLOOR = {"model": "kurt", "m": 0.09, "r0": 0.9, "alpha": 0.4}
CURVE = (7, 19, 30, 61)
BALL_M = 0.3


def part_of(frame, share):
    """The frame with this share of its columns covered, from the left."""
    normal = frame["normal"].copy()
    normal[:, round(share * normal.shape[1]):] = 0
    return {**frame, "normal": normal}


def ball_screen(size, centre):
    """A ball that fills the screen, and the eye before it: Z up, seen along +Y."""
    width, height = size
    x = 0.8 * (2 * (np.arange(width) + 0.5) / width - 1)
    z = 0.8 * height / width * (1 - 2 * (np.arange(height) + 0.5) / height)
    x, z = np.meshgrid(x, z)
    normal = np.stack([x, -np.sqrt(1 - x * x - z * z), z], -1).astype(np.float32)
    position = (np.asarray(centre) + BALL_M * normal).astype(np.float32)
    frame = {"position": position, "normal": normal, "beauty": np.zeros_like(normal)}
    return frame, tuple(np.asarray(centre, float) + (0, -10 * BALL_M, 0))


def floor_screen(size, described):
    """The floor z = 0 filling the screen: the lower part of what the room's camera sees, drawn out."""
    camera = described["camera"]
    to_world, (width, height) = np.array(camera["matrix_world"]), size
    half = np.tan(np.radians(camera["fov_x_deg"]) / 2)
    x = half * (2 * (np.arange(width) + 0.5) / width - 1)
    y = -half * 9 / 16 * np.linspace(0.5, 1, height)
    x, y = np.meshgrid(x, y)
    d = np.stack([x, y, -np.ones_like(x)], -1) @ to_world[:3, :3].T
    eye = to_world[:3, 3]
    position = (eye - d * (eye[2] / d[..., 2:])).astype(np.float32)
    normal = np.broadcast_to(np.float32([0, 0, 1]), position.shape)
    return {"position": position, "normal": normal.copy(), "beauty": np.zeros_like(position)}, tuple(eye)


def rate(frame, eye, material, light, threads, repeats, **settings):
    """Frames a second, of the fastest run."""
    lights = {} if isinstance(light, burnish.Environment) else {"lights": light, "default_light": list(light)}
    environment = None if lights else light
    runs = [burnish.composite(frame, environment, material, camera=eye, threads=threads, **lights, **settings)["report"]["seconds"]
            for _ in range(repeats)]
    return 1 / min(run["surface"] + run["shading"] for run in runs)


def regular(samples):
    """Settings of the sources' estimator."""
    return {"estimator": "regular", "samples": samples, "density": "dense"}


def walkthrough(folder, threads, repeats, size=SIZE):
    """(table, samples or "default") -> (screen full, half full)."""
    described, lights, found = json.loads((folder / "room.json").read_text()), room.lights_of(folder), {}
    scenes = {
        "curved": (*ball_screen(size, lights["planes"]["centre"]), SCATTERGLOSS, {"planes": lights["planes"]}),
        "planar": (*floor_screen(size, described), FLOOR, {"mirror": lights["mirror"]}),
    }
    for name, (frame, eye, material, light) in scenes.items():
        for samples in (*RATES[name], "default"):
            settings = {} if samples == "default" else regular(samples)
            found[name, samples] = [rate(part_of(frame, share), eye, material, light, threads, repeats, **settings)
                                    for share in (1, 0.5)]
    return found


def full_hd(light, threads, repeats, size=FULL_HD):
    """Samples or "default" -> rates with 100, 50 and 25 % of the screen covered: Regular's figure 7."""
    frame, eye = ball_screen(size, (0, 0, 0))
    return {samples: [rate(part_of(frame, share), eye, SCATTERGLOSS, light, threads, repeats,
                           **({} if samples == "default" else regular(samples))) for share in (1, 0.5, 0.25)]
            for samples in (*CURVE, "default")}
