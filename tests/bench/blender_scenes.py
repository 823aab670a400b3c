"""How near three clicks in Blender come to Cycles, and how quick a slider is: the spheres of the Cycles data, 960 x 540.

    BURNISH_ADDON=build/release/plugin/burnish_addon-0.1.0.zip blender -b --factory-startup --python-exit-code 1 \\
        --python tests/bench/blender_scenes.py -- DATA [--samples 400] [--filter point|box] [--moves 20]

DATA is the folder with cycles/make_scene.py. Prints dB of every material and of the frame, and the median of a slider's moves.
"""

import argparse
import os
import pathlib
import runpy
import statistics
import sys
import tempfile
import time

import bpy

WORLDS = pathlib.Path(bpy.utils.system_resource("DATAFILES")) / "studiolights" / "world"


def arguments():
    """After the double dash."""
    words = argparse.ArgumentParser("blender_scenes.py")
    words.add_argument("data", type=pathlib.Path)
    words.add_argument("--samples", type=int, default=400)
    words.add_argument("--filter", default="point", choices=["point", "box"])
    words.add_argument("--moves", type=int, default=20)
    return words.parse_args(sys.argv[sys.argv.index("--") + 1:])


def install(zip_file):
    """The add-on, into folders that the environment names (BLENDER_USER_SCRIPTS, BLENDER_USER_CONFIG)."""
    bpy.ops.preferences.addon_install(filepath=os.path.abspath(zip_file))
    bpy.ops.preferences.addon_enable(module="burnish_addon")


def build(options, folder):
    """Make the scene as the data were made, but without a render."""
    keep = sys.argv
    sys.argv = ["make_scene.py", "--", "--scene", "spheres", "--out", folder, "--hdri-dir", str(WORLDS), "--res", "960x540", "--spp",
                str(options.samples), "--filter", options.filter, "--no-render"]
    runpy.run_path(str(options.data / "cycles" / "make_scene.py"), run_name="__main__")
    sys.argv = keep
    return bpy.context.scene


def measure(scene, moves):
    """The three clicks, and what they came to."""
    import json

    from burnish_addon import live

    seconds = {}
    for click in ("prepare", "render", "composite", "compare"):
        start = time.perf_counter()
        getattr(bpy.ops.burnish, click)()
        seconds[click] = time.perf_counter() - start
    found = json.loads(scene.burnish.compared)
    for name, decibels in found["materials"].items():
        print(f"{name:24} {decibels:6.1f} dB")
    print(f"{'frame':24} {found['frame']:6.1f} dB")
    print(", ".join(f"{click} {took:.1f} s" for click, took in seconds.items()))
    for slider in scene.burnish.materials:
        measured = []
        for move in range(moves):
            slider.roughness = slider.roughness * (1.02 if move < moves / 2 else 0.98)
            measured.append(live.latencies(scene)[-1])
        print(f"{slider.name:24} {1000 * statistics.median(measured):6.0f} ms a move of roughness")
    measured = []
    for move in range(moves):
        scene.burnish.settings.env_rotate += 3
        measured.append(live.latencies(scene)[-1])
    print(f"{'light':24} {1000 * statistics.median(measured):6.0f} ms a move of rotation")


def main():
    """Install, build, measure."""
    options = arguments()
    with tempfile.TemporaryDirectory() as folder:
        scene = build(options, folder)
        install(os.environ["BURNISH_ADDON"])
        scene = bpy.context.scene
        scene.burnish.folder = folder
        measure(scene, options.moves)


main()
