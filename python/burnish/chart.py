"""`burnish chart`: error against lookups and against time, as CSV and as picture."""

from __future__ import annotations

import argparse
import contextlib
import difflib
import importlib.util
import os
import pathlib
import signal
import sys

from .charting import benchmark, measure, picture, table
from .errors import BadArgument, Error, ReadFailed, WriteFailed

DESCRIPTION = f"""Measures every estimator with several counts of lookups, on every material, under every light of a
fixed benchmark set, against the converged reference. Writes DIR/estimators.csv (errors relative, PSNR in dB, shading in
nanoseconds per pixel and tables in seconds, both of one thread) and DIR/estimators.png, and prints what
{table.TARGET_DB} dB cost."""
FAILED, USAGE, SIGNAL_BASE = 1, 2, 128
QUICK = dict(size=24, step=4, tolerance=0.03, seconds=0.0)


class Parser(argparse.ArgumentParser):
    """argparse, with burnish's one line for errors."""

    def error(self, message):
        """End with wrong usage."""
        sys.exit(fail("E_USAGE", f"{message}; see burnish chart --help", USAGE))


def fail(name, message, code):
    """Say on one line why the run ends; returns the exit code."""
    print(f"burnish: error: {name} {' '.join(str(message).split())}", file=sys.stderr)
    return code


def parser():
    """The command line."""
    names = ", ".join(material.name for material in benchmark.MATERIALS)
    words = Parser("burnish chart", description=DESCRIPTION,
                   epilog=f"Materials: {names}. Lights: {', '.join(benchmark.STRESS_LIGHTS)} and the files of --env, "
                          "by their names without the extension.")
    words.add_argument("--estimators", action="store_true", help="chart the estimators (the one chart there is)")
    words.add_argument("-o", "--output", metavar="DIR", type=pathlib.Path, required=True, help="folder to write to")
    words.add_argument("--env", metavar="FILE", action="append", default=[],
                       help="environment map as a further light, Y up; repeatable")
    words.add_argument("--materials", metavar="NAME", nargs="+", help="only these materials")
    words.add_argument("--lights", metavar="NAME", nargs="+", help="only these lights")
    words.add_argument("--size", metavar="PIXELS", type=int,
                       help=f"diameter of the sphere whose pixels have a reference, 8 to 1024 [{measure.Effort.size}]")
    words.add_argument("--quick", action="store_true",
                       help="a small sphere, a coarse reference, one run each: seconds a material")
    words.add_argument("--threads", metavar="N", type=int, default=0,
                       help="worker threads of the reference; 0: all cores [0]")
    words.add_argument("-q", "--quiet", action="store_true", help="no progress")
    return words


def main(arguments=None):
    """Run the command; returns its exit code."""
    words = parser()
    options = words.parse_args(arguments)
    if not options.estimators:
        words.error("what to chart? --estimators is what there is")
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, stop)
    try:
        run(options)
    except Error as error:
        return fail(error.code, error, USAGE if isinstance(error, BadArgument) else FAILED)
    except KeyboardInterrupt as stopped:
        return fail("E_CANCELLED", "stopped; nothing was written", SIGNAL_BASE + stopped.args[0])
    return 0


def stop(number, _):
    """Let a signal end the run as Ctrl-C does, also where the shell had it ignored."""
    raise KeyboardInterrupt(number)


def run(options):
    """Check everything that can be wrong, measure, write."""
    if importlib.util.find_spec("matplotlib") is None:
        raise ReadFailed("matplotlib is not installed; apt install python3-matplotlib, or pip install matplotlib")
    check_folder(options.output)
    effort = effort_of(options)
    materials = chosen("--materials", {material.name: material for material in benchmark.MATERIALS}, options.materials)
    sources = chosen("--lights", benchmark.light_sources(options.env), options.lights)
    lights = {name: benchmark.load_light(source) for name, source in sources.items()}
    pairs = [(name, light, material) for name, light in lights.items() for material in materials.values()]
    bench = measure.Bench(effort)
    rows = [row for pair in announced(pairs, options.quiet) for row in bench.rows(*pair)]
    write(options.output, rows)
    print("\n".join(table.summary(rows)))


def effort_of(options):
    """How carefully to measure."""
    wanted = {"threads": options.threads, **(QUICK if options.quick else {})}
    if options.size is not None:
        wanted["size"] = options.size
    effort = measure.Effort(**wanted)
    for name, value, low, high in (("--size", effort.size, 8, 1024), ("--threads", effort.threads, 0, 1024)):
        if not low <= value <= high:
            raise BadArgument(f"{name}: expected a whole number in [{low}, {high}], found {value}")
    return effort


def chosen(option, everything, names):
    """The entries that an option names; without names all."""
    for name in names or ():
        if name not in everything:
            near = difflib.get_close_matches(name, everything, 1)
            raise BadArgument(f"{option}: no '{name}'" + (f", did you mean {near[0]}?" if near else ";")
                              + f" there are {', '.join(everything)}")
    return {name: everything[name] for name in names or everything}


def announced(pairs, quiet):
    """The pairs, one after the other, with progress on standard error."""
    if importlib.util.find_spec("tqdm"):
        from tqdm import tqdm

        yield from tqdm(pairs, unit="pair", disable=quiet)
        return
    for count, (light, lit, material) in enumerate(pairs, 1):
        if not quiet:
            print(f"{count:3} of {len(pairs)}  {light}, {material.name}", file=sys.stderr)
        yield light, lit, material


def check_folder(folder):
    """Refuse before measuring what could not be written after it."""
    nearest = next(path for path in (folder.absolute(), *folder.absolute().parents) if path.exists())
    if not nearest.is_dir():
        raise WriteFailed(f"{nearest} is a file, expected a folder; choose another with -o")
    if not os.access(nearest, os.W_OK):
        raise WriteFailed(f"{nearest} is not writable; choose another folder with -o")


def write(folder, rows):
    """Write CSV and picture, both or none."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with beside(folder / "estimators.csv") as lines, beside(folder / "estimators.png") as image:
            with open(lines, "w", encoding="utf-8") as file:
                table.write_csv(rows, file)
            picture.save(picture.draw(rows), image)
    except OSError as error:
        raise WriteFailed(f"{folder}: {error.strerror or error}; choose another folder with -o") from error


@contextlib.contextmanager
def beside(path):
    """A file to write, renamed to `path` when all went well and removed when not."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


if __name__ == "__main__":
    sys.exit(main())
