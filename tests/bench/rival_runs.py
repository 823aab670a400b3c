"""The rivals at work: each is run as its user runs it, as a program of its own, and timed.

`frame_s` is what every further frame of a sequence costs, `once_s` what a light and its materials cost once (burnish's tables,
OpenImageIO's texture) or a scene does (Cycles' synchronisation), `process_s` the whole program by the clock, and `cpu_s` its
processor time, which other work on the machine stretches least.
"""

import dataclasses
import json
import re
import resource
import subprocess
import time

import numpy as np

import scenes
from rival_scene import glossy

SEED = 1  # that of the data is 0
FACTORS = (0.25, 0.35, 0.5, 0.7, 1, 1.4, 2, 2.8)  # radius of OpenImageIO's disc over 2 alpha, the lobe's own about the mirror direction
LADDER = (
    ("split_sum", 1, {"density": "dense"}),
    *(("fitted", n, {"samples": n, "density": "dense"}) for n in (2, 4, 6, 12)),
    ("default", 6, {"density": "dense"}),
    *(("default", 6, {"density": "sparse", "safety": safety}) for safety in (1, 2)),
    *(("regular", n, {"samples": n, "density": "dense"}) for n in (7, 19, 61)),
    *(("filtered_importance", n, {"samples": n, "density": "dense"}) for n in (16, 64, 96, 256)),
)
"""Family, lookups, settings of the command line."""


@dataclasses.dataclass(frozen=True)
class Run:
    """One picture, and what it took."""

    rival: str  # "cycles", "burnish", "openimageio"
    family: str  # points of one line of the picture
    setting: str
    frame_s: float
    once_s: float
    process_s: float
    cpu_s: float
    overlay: np.ndarray  # shape (height, width, 3)


def timed(command):
    """Output of a program, its seconds by the clock and of processors; it has to succeed."""
    start, before = time.perf_counter(), processor_seconds()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{command[0]} failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout + done.stderr, time.perf_counter() - start, processor_seconds() - before


def processor_seconds():
    """Of all programs that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run_cycles(scene, blender, script, folder, samples, threads):
    """Cycles with so many samples a pixel, nothing but what the glossy pass needs."""
    tag = f"{scene.name}_{samples}"
    text, *seconds = timed([blender, "-b", "--factory-startup", "-t", threads, "--debug-cycles", "--python", script, "--",
                            "--scene", "spheres", "--lean", "--out", folder, "--tag", tag, "--hdri", scene.name,
                            "--env-rot", scene.rotation_deg, "--spp", samples, "--seed", SEED])
    whole, frame = (float(re.search(rf"{name}: ([\d.e+-]+)", text).group(1))
                    for name in ("Total render time", r"Render time \(without synchronization\)"))
    return Run("cycles", "Cycles", f"{samples} samples", frame, whole - frame, *seconds, glossy(folder / f"{tag}.exr"))


def run_burnish(scene, program, folder, family, lookups, settings, threads, repeats):
    """The command line on the scene as a shot file; of the repeats the least of each figure."""
    shot, output, report = (folder / f"burnish.{end}" for end in ("json", "exr", "report.json"))
    shot.write_text(json.dumps({**scene.shot(), "output": {"file": str(output), "report": str(report)}, "threads": threads}))
    estimator = {} if family == "default" else {"estimator": family}
    words = [f"--{name}={value}" for name, value in {**estimator, **settings}.items()]
    times = []
    for _ in range(repeats):
        _, *seconds = timed([program, "composite", shot, "--quiet", *words])
        said = json.loads(report.read_text())
        once, frame = said["seconds"], said["frames"][0]["seconds"]
        times.append((frame["surface"] + frame["shading"], once["light"] + frame["tables"], *seconds))
    overlay = scenes.stacked(scenes.read_exr(output), *(f"burnish_spec.{c}" for c in "RGB"))
    density = settings["density"] + (f", safety {settings['safety']}" if "safety" in settings else "")
    name = f"default ({density})" if family == "default" else f"{family} {lookups}, {density}"
    return Run("burnish", family, name, *(float(least) for least in np.min(times, 0)), overlay)


def blurred(scene, program, folder, radii, threads, repeats):
    """OpenImageIO's picture for radii by material name, its seconds, and those of the process and its processors."""
    output = folder / "openimageio.exr"
    words = ",".join(f"{of['pass_index']}={radii[name]:.6g}" for name, of in scene.materials.items())
    text, *seconds = timed([program, scene.frame, scene.light, "--rotate", scene.rotation_deg, "--radius", words, "-o", output,
                             "--threads", threads, "--repeats", repeats])
    tints = np.ones((max(of["pass_index"] for of in scene.materials.values()) + 1, 3), np.float32)
    for of in scene.materials.values():
        tints[of["pass_index"]] = of["color"]
    index = scenes.read_exr(scene.frame)["ViewLayer.IndexMA.X"].astype(int)
    return scenes.stacked(scenes.read_exr(output), "R", "G", "B") * tints[index], json.loads(text), seconds


def run_openimageio(scene, judge, program, folder, threads, repeats):
    """One blurred lookup a pixel; each material is given the radius of FACTORS that does it best."""
    best = {name: (-np.inf, None) for name in scene.materials}
    for factor in FACTORS:
        radii = {name: factor * 2 * of["alpha"] for name, of in scene.materials.items()}
        overlay, _, _ = blurred(scene, program, folder, radii, threads, 1)
        found = judge.db(overlay, judge.reference)
        best = {name: max(best[name], (found[name], radii[name])) for name in best}
    radii = {name: radius for name, (_, radius) in best.items()}
    overlay, said, seconds = blurred(scene, program, folder, radii, threads, repeats)
    return Run("openimageio", "OpenImageIO", "environment(), blur by roughness", said["lookups_s"], said["texture_s"], *seconds,
               overlay)
