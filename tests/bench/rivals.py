"""What a user may do instead of burnish, on one chart: Cycles, OpenImageIO's blurred environment, split sum; time against dB.

    python3 tests/bench/rivals.py ../shared/data -o rivals

Twelve objects at 640x360 under two HDRs, the same surfaces and lights for all, on the same threads. Writes rivals.csv, rivals.md and
rivals.png into the folder; nothing of an earlier run is used. Needs Blender, matplotlib, OpenImageIO, a build with benches
(BURNISH_BUILD, default build/release) and its Python package on PYTHONPATH.
"""

import argparse
import csv
import os
import pathlib
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BURNISH_BUILD", ROOT / "build" / "release"))
sys.path[:0] = [str(ROOT / "tests"), str(BUILD / "python")]

import rival_picture  # noqa: E402
import rival_runs  # noqa: E402
import rival_scene  # noqa: E402
import rival_table  # noqa: E402

RIVALS = ("cycles", "burnish", "openimageio")


def parser():
    """The command line."""
    words = argparse.ArgumentParser("rivals.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("data", type=pathlib.Path, help="folder with cycles/ and public/env/")
    words.add_argument("-o", "--output", type=pathlib.Path, required=True, help="folder to write to")
    words.add_argument("--scenes", nargs="+", choices=rival_scene.LIGHTS, default=list(rival_scene.LIGHTS))
    words.add_argument("--only", nargs="+", choices=RIVALS, default=RIVALS, help="these rivals alone")
    words.add_argument("--samples", type=int, nargs="+", default=(16, 64, 256), help="of Cycles, a pixel")
    words.add_argument("--reference", type=int, metavar="SAMPLES", default=4096, help="most samples a pixel of the reference")
    words.add_argument("--rungs", type=int, default=len(rival_runs.LADDER), help="only so many settings of burnish")
    words.add_argument("--repeats", type=int, default=3, help="runs of each setting of burnish and OpenImageIO, the fastest counts")
    words.add_argument("--threads", type=int, default=2)
    words.add_argument("--blender", default="blender")
    return words


def runs_of(scene, judge, options):
    """All runs of a scene, one after the other."""
    if "cycles" in options.only:
        script = options.data / "cycles" / "make_scene.py"
        for samples in options.samples:
            yield rival_runs.run_cycles(scene, options.blender, script, options.output, samples, options.threads)
    if "openimageio" in options.only:
        yield rival_runs.run_openimageio(scene, judge, BUILD / "tests/bench/burnish_oiio_blur", options.output, options.threads,
                                         options.repeats)
    if "burnish" in options.only:
        for rung in rival_runs.LADDER[:options.rungs]:
            yield rival_runs.run_burnish(scene, BUILD / "bin/burnish", options.output, *rung, options.threads, options.repeats)


def rows_of(name, options):
    """One dict a run and part of the frame: a line of the CSV."""
    scene = rival_scene.scene_of(name, options.data, options.output)
    judge = rival_scene.Judge(scene, options.reference)
    print(f"{name}: noise of the reference {judge.noise_db():.1f} dB; Cycles' 1024 samples against it, dB:",
          {part: round(db, 1) for part, db in judge.agreement_db().items()}, file=sys.stderr)
    for run in runs_of(scene, judge, options):
        exact, cycles = judge.db(run.overlay, judge.reference), judge.db(run.overlay, judge.cycles)
        print(f"{name}: {run.setting}: {exact[rival_scene.WHOLE]:.1f} dB, {run.frame_s:.3f} s", file=sys.stderr)
        for part, db in exact.items():
            yield dict(scene=name, rival=run.rival, family=run.family, setting=run.setting, part=part, db=db,
                       db_to_cycles=cycles.get(part), frame_s=run.frame_s, once_s=run.once_s, process_s=run.process_s,
                       cpu_s=run.cpu_s)


def main():
    """Measure, then write everything."""
    options = parser().parse_args()
    if "cycles" in options.only and shutil.which(options.blender) is None:
        sys.exit(f"rivals.py: no program '{options.blender}'; install Blender, or leave Cycles out with --only burnish openimageio")
    options.data, options.output = options.data.resolve(), options.output.resolve()
    options.output.mkdir(parents=True, exist_ok=True)
    rows = [row for name in options.scenes for row in rows_of(name, options)]
    with open(options.output / "rivals.csv", "w", newline="", encoding="utf-8") as file:
        lines = csv.DictWriter(file, rows[0], lineterminator="\n")
        lines.writeheader()
        lines.writerows({name: f"{value:.6g}" if isinstance(value, float) else value for name, value in row.items()} for row in rows)
    text = rival_table.markdown(rows)
    (options.output / "rivals.md").write_text(text)
    rival_picture.save(rows, options.output / "rivals.png")
    print(text, end="")


if __name__ == "__main__":
    main()
