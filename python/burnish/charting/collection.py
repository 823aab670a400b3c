"""The fixed benchmark set: the demo's frames, spheres under stress lights and real ones, and the scenes that Cycles rendered.

Figures of today and of next year compare: all of it is made in code, but for the real data, a folder that is named.
"""

from __future__ import annotations

import dataclasses
import pathlib
import shutil
import subprocess
import sys

import numpy as np

from .. import ReadFailed
from . import benchmark, cycles
from .benchmark import GRAZING, light_picture, sphere, view_cosines
from .lights import Lights
from .scene import Part, Scene, Source, file_stamps, parameters_of
from .setting import own_setting
from .shots import shot_source, source_of

MATERIALS = {
    "mirror": "mirror",
    "ggx-0.05": {"model": "ggx", "m": 0.05},
    "ggx-0.2": {"model": "ggx", "m": 0.2},
    "beckmann-0.1": {"model": "beckmann", "m": 0.1},
    "beckmann-0.4": {"model": "beckmann", "m": 0.4},
    "brushed-steel": "brushed-steel",
    "beckmann-0.2x0.02": {"model": "beckmann", "mx": 0.2, "my": 0.02},
    "merl:brass": "merl:brass",
    "merl:blue-metallic-paint": "merl:blue-metallic-paint",
    "clear-glass": "clear-glass",
    "frosted-glass": "frosted-glass",
}
"""From mirror to rough, anisotropic, measured, transmission."""
QUICK_MATERIALS = ("mirror", "ggx-0.2", "brushed-steel", "merl:brass")
ROOM_MATERIALS = ("lacquer", "gold", "chrome", "frosted-glass")
"""Of the demo's room: mirrors over a traced room, cube maps, what is behind a pane."""


@dataclasses.dataclass(frozen=True)
class Size:
    """How large the set is."""

    sphere: int = 128  # pixels across
    demo: tuple = (320, 180)
    scenes: tuple = ("table", "room")  # of the demo
    lights: int = 8  # real environments at the most
    materials: tuple = tuple(MATERIALS)
    cycles: bool = True


QUICK = Size(96, (160, 90), ("table",), 1, QUICK_MATERIALS, False)


def sources(size, scratch, data=None):
    """The Sources of the set; demo shots are made in the folder `scratch` when they are loaded."""
    found = [demo_source(scene, size.demo, scratch) for scene in size.scenes]
    lights = dict(list(benchmark.STRESS_LIGHTS.items())[: 1 if size == QUICK else None])
    found += [sphere_source(name, light, size) for name, light in lights.items()]
    if data is None:
        return found
    if not (data / "public/env").is_dir() and not (data / "cycles").is_dir():
        raise ReadFailed(f"{data}: there is neither cycles nor public/env in it; name the folder of the test data with --data")
    files = sorted((data / "public/env").glob("*.hdr"))[: size.lights]
    found += [sphere_source(file.stem, str(file), size) for file in files]
    if size.cycles:
        found += [source_of(name, settings) for name, settings in cycles.jobs(data / "cycles").items()]
    return found


def sphere_source(name, light, size):
    """A sphere in each of the materials, one after the other, under one light."""
    chosen = {material: MATERIALS[material] for material in size.materials}
    return Source(f"sphere {name}", len(chosen), [size.sphere, light, chosen, file_stamps(light)],
                  lambda: sphere_scene(f"sphere {name}", name, light, chosen, size.sphere))


def sphere_scene(name, light_name, light, materials, size):
    """Loaded."""
    frame = sphere(size)
    cosines = view_cosines(frame)
    covered = (cosines > 0).astype(np.float32)
    parts = [Part(material, parameters_of(worn), job_of(material, worn, covered), covered) for material, worn in materials.items()]
    return Scene(name, light_name, frame, {"camera": benchmark.CAMERA}, Lights(light_picture(light)), tuple(parts),
                 own_setting({}, size * size, is_near=False), cosines < GRAZING)


def job_of(name, worn, covered):
    """One material on a mask: a preset by its name, any other under its own."""
    if isinstance(worn, str):
        return {"assign": {worn: covered}}
    return {"materials": {name: worn}, "assign": {name: covered}}


def demo_source(scene, size, scratch):
    """A frame of `burnish demo`; of the room, whose lights are read for every run, a few materials."""
    count = {"table": 11, "room": len(ROOM_MATERIALS)}[scene]

    def load():
        folder = scratch / scene
        run_demo(scene, size, folder)
        loaded = shot_source(folder / "shot.json").load()
        parts = [part for part in loaded.parts if scene == "table" or part.name.split(" (")[0] in ROOM_MATERIALS]
        return dataclasses.replace(loaded, name=f"demo {scene}", parts=tuple(parts))

    return Source(f"demo {scene}", count, list(size), load)


def run_demo(scene, size, folder):
    """Make a shot with the burnish program that belongs to this package."""
    program = shutil.which("burnish", path=str(pathlib.Path(sys.argv[0]).resolve().parent)) or shutil.which("burnish")
    command = [program] if program else [sys.executable, "-m", "burnish"]
    words = ["demo", "--scene", scene, "-o", folder, "--width", size[0], "--height", size[1]]
    done = subprocess.run([*command, *map(str, words)], capture_output=True, text=True)
    if done.returncode:
        raise ReadFailed(f"burnish demo --scene {scene} failed: {done.stderr.strip()}")
