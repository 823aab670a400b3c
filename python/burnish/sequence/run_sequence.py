"""`burnish.sequence.run`: the frames of a shot in this process, in several, or on a farm."""

from __future__ import annotations

import functools
import math
import secrets
import time
from typing import TYPE_CHECKING, Any, Literal

from .._atomic import write_text
from .._shot import Shot
from ..errors import BadArgument
from .dask_pool import DaskPool
from .farm import Farm
from .frame_ranges import parse_frames
from .outputs import Outputs, hold
from .pools import Processes, ThisProcess
from .report import SequenceReport
from .tasks import make_task

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable, Mapping

    from .._core import Progress
    from .farm import Pool

    Path = str | os.PathLike[str]

TASKS_EACH = 8  # of a worker; the first makes light and tables, which the others use


def run(
    shot: Shot | Path | Mapping[str, Any],
    frames: str | Iterable[int] | None = None,
    *,
    client: Any = None,
    processes: int | None = None,
    chunk: int | None = None,
    skip_existing: bool = True,
    bad_frames: Literal["error", "skip", "hold"] = "error",
    retries: int = 1,
    timeout: float | None = None,
    progress: Progress | None = None,
    **settings: Any,
) -> SequenceReport:
    """Composite the frames of a shot: in this process, in several, or on a dask farm. The bits are the same in every case.

    It can be called again at any time, also after it was stopped or lost its farm: frames that are up to date are left out, and
    outputs are there whole or not at all.

    Parameters
    ----------
    shot : Shot or str or os.PathLike or dict
        The shot, its file or its document; `aovs` and `output` are patterns (``shot.####.exr``).
    frames : str or iterable of int, optional
        Such as "1-24" (see `parse_frames` for other dialects); by default those the shot names, or all on disk.
    client : dask.distributed.Client, optional
        Tasks go to the workers of its scheduler, which have burnish and see the same files by the same paths.
    processes : int, optional
        Tasks go to so many processes of this machine; by default all is done in this one.
    chunk : int, optional
        Frames a task. By default by frames and workers; 1 where the shot has a target (psnr, max_error, time), as it plans once a task.
        Light and tables are made once a worker, or with a target once a task.
    skip_existing : bool
        Leave out frames whose output is up to date; the worker looks.
    bad_frames : {"error", "skip", "hold"}
        A frame that fails or has no input: hand out no more frames; go on with the others; or go on, and let the output of the nearest
        frame before it stand in (where there is none, of the next one).
    retries : int
        How often a frame is tried again after an error that may pass: reading, writing, a worker that died, time.
    timeout : float, optional
        Seconds a frame may take, in the mean of its task.
    progress : callable, optional
        ``progress(stage, done)``, done in [0, 1] over all frames; returning False cancels.
    **settings
        Settings by name that differ from the shot's. `report` is where the report of the sequence goes, as JSON.

    Returns
    -------
    SequenceReport
        What became of each frame, seconds of wall time; `to_dict` has it as a dict. Frames that failed are told in it and not raised:
        see `raise_if_failed`.

    Raises
    ------
    BadArgument, ColorSpaceError
        What is wrong with the shot or an argument, whatever the frame.
    Cancelled
        `progress` returned False; the frames that are done stay.
    LostConnection
        The scheduler is gone; the same call goes on where this one stopped.
    """
    _check(client, processes, chunk, bad_frames, retries, timeout)
    given = Shot(shot, **settings, skip_existing=skip_existing, bad_frames="skip")
    outputs = Outputs(given)
    numbers = _numbers(given, frames)
    document = {key: value for key, value in given.document.items() if key != "frames"}
    document.get("output", {}).pop("report", None)
    pool: Pool = DaskPool(client) if client is not None else Processes(processes) if processes else ThisProcess()
    keeps = not _has_target(given)
    size = chunk or (default_chunk(len(numbers), pool.workers) if keeps else 1)
    name = secrets.token_hex(8) if keeps else ""
    begin = time.monotonic()
    make = functools.partial(make_task, document, timeout=timeout, run=name)
    farm = Farm(pool, make, numbers, retries, bad_frames == "error", progress)
    try:
        farm.run(size)
    finally:
        pool.stop(name)
        if client is None or farm.open == 0:  # else workers may still write
            outputs.sweep(numbers)
    if bad_frames == "hold":
        hold(list(farm.outcomes.values()), outputs)
    report = SequenceReport(list(farm.outcomes.values()), time.monotonic() - begin, pool.workers, size)
    if given.report:
        write_text(given.report, report.to_json() + "\n")
    return report


def default_chunk(frames: int, workers: int) -> int:
    """Frames a task: so few that no worker is idle for long at the end, and that progress is told often."""
    return max(1, math.ceil(frames / (workers * TASKS_EACH)))


def _check(client: Any, processes: int | None, chunk: int | None, bad_frames: str, retries: int, timeout: float | None) -> None:
    """Refuse what cannot be meant, by the name of the argument."""
    if client is not None and processes is not None:
        raise BadArgument("processes: there is a client, whose workers do the work; leave processes out")
    if client is not None and getattr(client, "asynchronous", False):
        raise BadArgument("client: it is asynchronous; give one that is not")
    for name, value, least in (("processes", processes, 1), ("chunk", chunk, 1), ("retries", retries, 0)):
        if value is not None and (not isinstance(value, int) or value < least):
            raise BadArgument(f"{name}: expected a whole number of at least {least}, found {value!r}")
    if timeout is not None and not timeout > 0:
        raise BadArgument(f"timeout: expected seconds above 0, found {timeout!r}")
    if bad_frames not in ("error", "skip", "hold"):
        raise BadArgument(f"bad_frames: expected error, skip or hold, found {bad_frames!r}")


def _numbers(shot: Shot, frames: str | Iterable[int] | None) -> list[int]:
    """The frames that are asked for."""
    if frames is None:
        numbers = shot.frames().numbers
    else:
        numbers = parse_frames(frames) if isinstance(frames, str) else list(dict.fromkeys(int(frame) for frame in frames))
    if not numbers:
        raise BadArgument(f"frames: no file fits '{shot.aovs}'" if frames is None else "frames: expected at least one")
    return numbers


def _has_target(shot: Shot) -> bool:
    return any(shot.settings.get(name) for name in ("psnr", "max_error", "time"))
