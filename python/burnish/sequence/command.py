"""`burnish sequence`: the frames of a shot, over processes or a dask farm."""

from __future__ import annotations

import argparse
import contextlib
import importlib.util
import sys
from typing import TYPE_CHECKING, Any

from .._command_line import FAILED, PARTIAL, SIGNAL_BASE, USAGE, Parser, catch_signals, fail
from .._shot import Shot
from ..charting.words import settings_of
from ..errors import BadArgument, Error, LostConnection, ReadFailed
from .frame_ranges import parse_frames
from .progress_display import FORMATS, ProgressDisplay
from .report import SequenceReport
from .run_sequence import run

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

DESCRIPTION = """Composites the frames of a shot: a shot file, or an EXR pattern (shot.####.exr), with the options of burnish composite
(--env, --material, --samples, ...). In this process, in several, or on the workers of a dask scheduler, which have burnish and see the same
files by the same paths; the bits are the same in every case. Frames whose output is up to date are left out, so that the same command goes on
after it was stopped."""
FOOTER = """Exit codes: 0 done, 1 failed, 2 wrong usage, 3 some frames failed, had no input or were held, 130 stopped by Ctrl-C.
Example: burnish sequence shot.json --frames 1-200 --processes 4"""
CONNECT_S = 10


def parser() -> argparse.ArgumentParser:
    """The command line."""
    line = Parser("burnish sequence", description=DESCRIPTION, epilog=FOOTER, allow_abbrev=False)
    line.add_argument("shot", metavar="SHOT", help="a shot file (.json) or an EXR pattern")
    line.add_argument("-o", "--output", metavar="FILE", help="EXRs to write; #### stands for the frame number")
    line.add_argument("--frames", metavar="RANGE", help="frames to do [those the shot names, or all on disk]")
    line.add_argument("--dialect", choices=("burnish", "openjd", "fileseq", "oiio"), default="burnish",
                      help="how ranges are meant: 1-9:4 is a step for openjd, staggered for fileseq [burnish]")
    line.add_argument("--within", metavar="RANGE", help="frames beyond are none of the job's: for chunks that overshoot its end")
    where = line.add_mutually_exclusive_group()
    where.add_argument("--scheduler", metavar="ADDRESS", help="dask scheduler, such as tcp://host:8786")
    where.add_argument("--processes", metavar="N", type=int, help="processes of this machine [this one]")
    line.add_argument("--chunk", metavar="N", type=int, help="frames a task [by frames and workers]")
    line.add_argument("--retries", metavar="N", type=int, default=1, help="tries more after an error that may pass [1]")
    line.add_argument("--timeout", metavar="SECONDS", type=float, help="that a frame may take")
    line.add_argument("--bad-frames", choices=("error", "skip", "hold"), default="error",
                      help="a frame that fails or has no input: stop; go on; go on, the nearest frame before stands in [error]")
    line.add_argument("--redo", action="store_true", help="also frames whose output is up to date")
    line.add_argument("--progress", metavar="FORMAT", choices=FORMATS, default="auto", help=f"{'|'.join(FORMATS)}, on stderr [auto]")
    line.add_argument("-q", "--quiet", action="store_true", help="print errors only")
    line.add_argument("--json", action="store_true", help="print the report as JSON")
    return line


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit code."""
    options, more = parser().parse_known_args(arguments)
    catch_signals()
    display = ProgressDisplay("none" if options.quiet else options.progress)
    try:
        report = carry_out(options, more, display)
    except Error as error:
        return fail(error.code, error, USAGE if isinstance(error, BadArgument) else FAILED)
    except KeyboardInterrupt as stopped:
        return fail("E_CANCELLED", "stopped; the same command goes on with the frames that are left", SIGNAL_BASE + stopped.args[0])
    finally:
        display.close()
    return tell(report, options)


def carry_out(options: argparse.Namespace, more: list[str], display: ProgressDisplay) -> SequenceReport:
    """Run the sequence."""
    shot = shot_of(options, settings_of(more, "sequence"))
    frames = parse_frames(options.frames, options.dialect) if options.frames else shot.frames().numbers
    if options.within:
        inside = set(parse_frames(options.within, options.dialect))
        frames = [frame for frame in frames if frame in inside]
        if not frames:
            return SequenceReport([], 0, 0, 0)
    with farm_at(options.scheduler) as client:
        return run(shot, frames, client=client, processes=options.processes, chunk=options.chunk, skip_existing=not options.redo,
                   bad_frames=options.bad_frames, retries=options.retries, timeout=options.timeout, progress=display)


def shot_of(options: argparse.Namespace, settings: dict[str, Any]) -> Shot:
    """The shot with the options; repeatable ones add to what it says."""
    shot = Shot(options.shot) if options.shot.endswith(".json") else Shot(aovs=options.shot)
    for name, value in settings.items():
        held = getattr(shot, name)
        settings[name] = {**held, **value} if isinstance(value, dict) else held + value if name == "assign" else value
    return shot.with_(**settings, **({"output": options.output} if options.output else {}))


@contextlib.contextmanager
def farm_at(address: str | None) -> Iterator[Any]:
    """A client of the scheduler, or None where there is none."""
    if address is None:
        yield None
        return
    if importlib.util.find_spec("distributed") is None:
        raise ReadFailed("dask.distributed is not installed; apt install python3-distributed, or pip install distributed")
    from distributed import Client
    from distributed.comm import get_address_host_port

    try:
        get_address_host_port(address)
        client = Client(address, timeout=CONNECT_S, set_as_default=False)
    except (OSError, ValueError) as error:
        raise LostConnection(f"--scheduler: no scheduler at {address} ({error})") from error
    with client:
        yield client


def tell(report: SequenceReport, options: argparse.Namespace) -> int:
    """Print what became of the frames; returns the exit code."""
    for outcome in report.frames:
        if outcome.code and not options.quiet:
            print(f"burnish: warning: frame={outcome.frame} {outcome.status}: {outcome.code} {outcome.message}", file=sys.stderr)
    if options.json:
        print(report.to_json())
    elif not options.quiet:
        print(report.summary())
    if report.is_complete:
        return 0
    first = next(outcome for outcome in report.frames if outcome.code)
    if options.bad_frames == "error" or not report.of("done", "skipped", "held"):
        return fail(first.code, f"frame={first.frame} {first.message}", FAILED)
    return PARTIAL
