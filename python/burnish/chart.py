"""`burnish chart`: speed against accuracy of every way to shade, the estimators alone, and the places where methods fail."""

from __future__ import annotations

import difflib
import importlib.util
import os
import pathlib
import sys
import tempfile

from ._command_line import FAILED, SIGNAL_BASE, USAGE, Parser, catch_signals, fail
from .charting import benchmark, collection, estimators, files, shots, speed, stability, table, words
from .charting.progress import Progress
from .charting.store import Store
from .errors import BadArgument, Error, ReadFailed
from .stability.case import every_case

DESCRIPTION = f"""Charts speed against accuracy. For every material of a shot: every estimator with several counts of lookups,
sparse shading and other light for what is worth it, its time stage by stage and its error (display PSNR in dB, relative RMS,
largest error) against the converged reference. Shots are shot files, or one EXR with the options of burnish composite (--env,
--material, --assign, ...). Without a shot: the fixed benchmark set, the demo's frames and spheres under stress lights; with --data
real lights and scenes that Cycles rendered, too. Writes DIR/report.html, DIR/rows.csv and DIR/rows.json; DIR/measured holds what
was measured, so that the same command goes on after it was stopped.

--estimators charts spheres alone: DIR/estimators.csv (errors relative, PSNR in dB, shading in nanoseconds per pixel and tables in
seconds, both of one thread) and DIR/estimators.png, and prints what {table.TARGET_DB} dB cost. --stability runs every case of the
stability suite: DIR/stability.html and DIR/stability.json; exit code 1 when a case does not hold."""


def parser():
    """The command line."""
    names = ", ".join(material.name for material in benchmark.MATERIALS)
    line = Parser("burnish chart", description=DESCRIPTION, allow_abbrev=False,
                  epilog=f"Materials of --estimators: {names}. Its lights: {', '.join(benchmark.STRESS_LIGHTS)} and the files of "
                         "--env, by their names without the extension.")
    line.add_argument("shots", metavar="SHOT", nargs="*", type=pathlib.Path, help="shot files (.json), or one EXR")
    line.add_argument("-o", "--output", metavar="DIR", type=pathlib.Path, required=True, help="folder to write to")
    line.add_argument("--quick", action="store_true", help="few settings, a coarse reference, a small set: under two minutes")
    line.add_argument("--data", metavar="FOLDER", type=pathlib.Path, default=os.environ.get("BURNISH_DATA") or None,
                      help="folder with cycles and public/env, for the benchmark set [$BURNISH_DATA]")
    line.add_argument("--threads", metavar="N", type=int, default=0, help="worker threads; 0: all cores [0]")
    line.add_argument("-q", "--quiet", action="store_true", help="no progress")
    line.add_argument("--estimators", action="store_true", help="chart the estimators on spheres, on one thread")
    line.add_argument("--env", metavar="FILE", action="append", default=[],
                      help="environment map of an EXR; with --estimators a further light, Y up; repeatable")
    line.add_argument("--materials", metavar="NAME", nargs="+", help="only these materials (of a shot: as the rows call them)")
    line.add_argument("--lights", metavar="NAME", nargs="+", help="--estimators: only these lights")
    line.add_argument("--size", metavar="PIXELS", type=int,
                      help=f"--estimators: diameter of the sphere whose pixels have a reference, 8 to 1024 [{estimators.SIZE}]")
    line.add_argument("--stability", action="store_true", help="run the stability suite")
    line.add_argument("--cases", metavar="NAME", nargs="+", help="--stability: only these cases")
    return line


def main(arguments=None):
    """Run the command; returns its exit code."""
    line = parser()
    options, more = line.parse_known_args(arguments)
    if options.estimators and options.stability:
        line.error("--estimators or --stability, not both")
    catch_signals()
    try:
        return run(options, more)
    except Error as error:
        return fail(error.code, error, USAGE if isinstance(error, BadArgument) else FAILED)
    except KeyboardInterrupt as stopped:
        return fail("E_CANCELLED", "stopped; the same command goes on with what was measured", SIGNAL_BASE + stopped.args[0])


def run(options, more):
    """Check everything that can be wrong, measure, write; returns the exit code."""
    for module, remedy in (("matplotlib", "matplotlib"), ("PIL", "pil")):
        if importlib.util.find_spec(module) is None:
            raise ReadFailed(f"{module} is not installed; apt install python3-{remedy}, or pip install {remedy.replace('pil', 'pillow')}")
    if not 0 <= options.threads <= 1024:
        raise BadArgument(f"--threads: expected a whole number in [0, 1024], found {options.threads}")
    if more and (options.estimators or options.stability or not is_picture(options.shots)):
        raise BadArgument(f"{more[0]}: no such option; options of burnish composite go with one EXR, see burnish chart --help")
    files.check_folder(options.output)
    if options.stability:
        return run_stability(options)
    return run_estimators(options) if options.estimators else run_speed(options, more)


def is_picture(names):
    """Whether an EXR is charted, whose options follow."""
    return len(names) == 1 and names[0].suffix.lower() != ".json"


def run_speed(options, more):
    """Shots, or the benchmark set."""
    with tempfile.TemporaryDirectory(prefix="burnish-chart-") as scratch:
        sources = sources_of(options, more, pathlib.Path(scratch))
        sweep = speed.sweep_of(Store(options.output), Progress(options.quiet), options.quick, options.threads,
                                tuple(options.materials or ()))
        note_others(sweep, sources)
        try:
            sweep.run(sources)
        finally:
            if sweep.rows(sources):
                speed.write(options.output, sweep, sources)
        print("\n".join(speed.summary(sweep, sources)))
    return 0


def sources_of(options, more, scratch):
    """What to chart."""
    if is_picture(options.shots):
        picture = options.shots[0]
        light = {"env": options.env[0]} if options.env else {}
        return [shots.source_of(picture.stem, {"aovs": str(picture), **light, **words.settings_of(more)})]
    if options.shots:
        stems = {shot.stem for shot in options.shots}
        names = [shot.stem if len(stems) == len(options.shots) else shot.parent.name for shot in options.shots]
        return [shots.shot_source(shot, name) for shot, name in zip(options.shots, names)]
    return collection.sources(collection.QUICK if options.quick else collection.Size(), scratch, options.data)


def note_others(sweep, sources):
    """Say where the folder holds rows that are not today's."""
    others = sweep.store.others({sweep.digest(source) for source in sources})
    if others:
        print(f"burnish: warning: {sweep.store.folder}: {others} rows are of another version, other settings or other shots; "
              "they are left aside", file=sys.stderr)


def run_estimators(options):
    """Spheres under lights."""
    size = options.size if options.size is not None else estimators.QUICK_SIZE if options.quick else estimators.SIZE
    if not 8 <= size <= 1024:
        raise BadArgument(f"--size: expected a whole number in [8, 1024], found {size}")
    materials = chosen("--materials", {material.name: material for material in benchmark.MATERIALS}, options.materials)
    lights = chosen("--lights", benchmark.light_sources(options.env), options.lights)
    for light in lights.values():
        benchmark.load_light(light)
    sources = estimators.sources_of(lights, materials, size)
    store, effort = Store(options.output), estimators.effort_of(size, options.quick, options.threads)
    print("\n".join(estimators.run(options.output, store, Progress(options.quiet), sources, effort)))
    return 0


def run_stability(options):
    """Cases of the suite."""
    cases = chosen("--cases", every_case(), options.cases)
    failing = stability.run(options.output, cases, lambda each: announced(each, options.quiet))
    print(f"{len(cases) - len(failing)} of {len(cases)} cases hold" + (f"; these do not: {', '.join(failing)}" if failing else ""))
    return FAILED if failing else 0


def announced(cases, quiet):
    """The cases, one after the other, with progress on standard error."""
    for count, case in enumerate(cases, 1):
        if not quiet:
            print(f"{count:3} of {len(cases)}  {case.name}", file=sys.stderr, flush=True)
        yield case


def chosen(option, everything, names):
    """The entries that an option names; without names all."""
    for name in names or ():
        if name not in everything:
            near = difflib.get_close_matches(name, everything, 1)
            raise BadArgument(f"{option}: no '{name}'" + (f", did you mean {near[0]}?" if near else ";")
                              + f" there are {', '.join(everything)}")
    return {name: everything[name] for name in names or everything}


if __name__ == "__main__":
    sys.exit(main())
