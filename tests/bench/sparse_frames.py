"""Sparse against dense shading of whole frames, through the job: the scenes that Cycles rendered, and shots of `burnish demo`.

    python3 tests/bench/sparse_frames.py objects DATA/cycles/spheres spheres
    python3 tests/bench/sparse_frames.py flicker DATA/cycles/anim
    python3 tests/bench/sparse_frames.py shot demo/shot.json
    python3 tests/bench/sparse_frames.py sweep DATA/cycles/spheres spheres --setting safety --values 0.25 0.5 1 2 4

Prints CSV. Times are wall times of one thread, the least of the repeats. Needs burnish and OpenImageIO on PYTHONPATH.
"""

import argparse
import json
import pathlib
import sys

import burnish
import numpy as np
from burnish.stability.measures import CODES, flicker

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import cycles
import scenes


def shaded(job, repeats=1, **settings):
    """Layers of the job's frame, and the least seconds that shading took."""
    runs = [burnish.composite(**job, **settings, threads=1) for _ in range(repeats)]
    return runs[0], min(run["report"]["seconds"]["shading"] for run in runs)


def compared(job, repeats, **settings):
    """dB, seconds of dense and sparse, share of pixels shaded, both overlays."""
    dense, dense_seconds = shaded(job, repeats, density="dense")
    sparse, sparse_seconds = shaded(job, repeats, density="sparse", **{"safety": 1} | settings)
    valid = dense["validity"] == 0
    db = burnish.compare(sparse["overlay"], dense["overlay"], valid.astype(np.float32))["psnr_db"]
    return db, dense_seconds, sparse_seconds, (sparse["samples"] > 0).sum() / valid.sum(), dense["overlay"], sparse["overlay"]


def material_index(job):
    return scenes.read_exr(job["aovs"])["ViewLayer.IndexMA.X"]


def print_objects(options):
    """A row for each object's interior, and one for the whole frame, edges included."""
    job = cycles.job_of(options.folder, options.name)
    db, dense_s, sparse_s, share, dense, sparse = compared(job, options.repeats)
    print("object,psnr_db,shaded_%,dense_ms,sparse_ms,ratio")
    print(f"all,{db:.1f},{100 * share:.1f},{1e3 * dense_s:.1f},{1e3 * sparse_s:.1f},{dense_s / sparse_s:.2f}")
    index = material_index(job)
    for rule in job["assign"]:
        mask = cycles.interior(index, rule["material_index"])
        print(f"{rule['material']},{burnish.compare(sparse, dense, mask)['psnr_db']:.1f},,,,")


def print_sweep(options):
    job = cycles.job_of(options.folder, options.name)
    print(f"{options.setting},psnr_db,shaded_%,sparse_ms")
    for value in options.values:
        setting = {options.setting: int(value) if options.setting == "directions" else value}
        db, _, seconds, share, _, _ = compared(job, options.repeats, **setting)
        print(f"{value:g},{db:.1f},{100 * share:.1f},{1e3 * seconds:.1f}", flush=True)


def print_flicker(options):
    """Of dense and sparse against the truth, object by object and over all of them."""
    names = [f"anim_{frame:04d}" for frame in range(1, options.frames + 1)]
    jobs = [cycles.job_of(options.folder, name) | {"camera": options.folder / f"{name}.json"} for name in names]
    jobs = [job | {"estimator": options.estimator} for job in jobs]
    dense = [burnish.composite(**job, density="dense")["overlay"] for job in jobs]
    sparse = [burnish.composite(**job, density="sparse", safety=options.safety)["overlay"] for job in jobs]
    exact = {"estimator": options.truth, "samples": options.samples, "max_samples": options.samples, "tolerance": 1e-6}
    truth = [burnish.composite(**job | exact, density="dense")["overlay"] for job in jobs]
    indices = [material_index(job) for job in jobs]
    print("object,dense,sparse,ratio,sparse_against_dense")
    objects = {rule["material"]: [cycles.interior(index, rule["material_index"]) for index in indices]
               for rule in jobs[0]["assign"]}
    objects["all"] = [np.logical_or.reduce(masks) for masks in zip(*objects.values())]
    for name, masks in objects.items():
        of_dense, of_sparse, own = (flicker(*pair, masks) / CODES for pair in ((dense, truth), (sparse, truth), (sparse, dense)))
        print(f"{name},{of_dense:.5f},{of_sparse:.5f},{of_sparse / of_dense:.3f},{own:.5f}", flush=True)


def print_shot(options):
    """A shot file's first frame: dense and sparse, run as files, compared by its overlay layer."""
    folder = options.file.parent
    seconds, overlays = {}, {}
    for density in ("dense", "sparse"):
        output = {"file": str(folder / f"{density}.exr"), "diagnostics": True}
        shot = json.loads(options.file.read_text()) | {"output": output}
        for key, light in shot["lights"].items():
            light["file"] = str(folder / light["file"])
        shot["aovs"] = str(folder / shot["aovs"])
        shot["quality"] = {}
        reports = [burnish.run(shot, density=density, safety=1, threads=1) for _ in range(options.repeats)]
        seconds[density] = min(report["frames"][0]["seconds"]["shading"] for report in reports)
        overlays[density] = scenes.read_exr(output["file"])
    stack = {key: scenes.stacked(layers, *(f"burnish_spec.{c}" for c in "RGB")) for key, layers in overlays.items()}
    counts = {key: next(v for k, v in layers.items() if "samples" in k) for key, layers in overlays.items()}
    mask = (counts["dense"] > 0).astype(np.float32)
    db = burnish.compare(stack["sparse"], stack["dense"], mask)["psnr_db"]
    share = (counts["sparse"] > 0).sum() / mask.sum()
    print("shot,psnr_db,shaded_%,dense_ms,sparse_ms,ratio")
    print(f"{options.file},{db:.1f},{100 * share:.1f},{1e3 * seconds['dense']:.1f},{1e3 * seconds['sparse']:.1f},"
          f"{seconds['dense'] / seconds['sparse']:.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    for name, run in (("objects", print_objects), ("sweep", print_sweep), ("flicker", print_flicker), ("shot", print_shot)):
        command = commands.add_parser(name)
        command.set_defaults(run=run)
        command.add_argument("--repeats", type=int, default=5)
        if name == "shot":
            command.add_argument("file", type=pathlib.Path)
            continue
        command.add_argument("folder", type=pathlib.Path)
        if name == "flicker":
            command.add_argument("--frames", type=int, default=8)
            command.add_argument("--samples", type=int, default=1024, help="of the truth")
            command.add_argument("--estimator", default="fitted")
            command.add_argument("--safety", type=float, default=1)
            command.add_argument("--truth", choices=("reference", "filtered_importance"), default="filtered_importance",
                                 help="the latter is smoothed a little, but free of noise [default]")
            continue
        command.add_argument("name")
        if name == "sweep":
            command.add_argument("--setting", choices=("safety", "directions"), required=True)
            command.add_argument("--values", type=float, nargs="+", required=True)
    options = parser.parse_args()
    options.run(options)


if __name__ == "__main__":
    main()
