"""What a worker does: a few frames of one shot, with the core's own pipeline; light and tables are made once a run and worker.

A task is a dict of plain values, never pixels, and so is what became of its frames: both travel between processes and machines.
"""

from __future__ import annotations

import contextlib
import os
import sys
import threading
import time
from typing import TYPE_CHECKING, Any

from .. import _core
from ..errors import BadArgument, Cancelled, ColorSpaceError, Error

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from .._core import Progress

    Task = dict[str, Any]
    Outcome = dict[str, Any]

TRANSIENT = ("E_READ_FAILED", "E_WRITE_FAILED", "E_TIMEOUT", "E_LOST_WORKER")
WORST_FIRST = ("failed", "missing", "done", "skipped")
OF_THE_JOB = (BadArgument, ColorSpaceError, Cancelled)  # whatever the frame, they would come again


class TimedOut(Error):
    """Frames took longer than they may."""

    code = "E_TIMEOUT"


def make_task(document: dict[str, Any], frames: list[int], timeout: float | None, run: str = "") -> Task:
    """Make the task of a few frames. `run`: tasks with the same one share light and tables; "": with no other task."""
    return {"burnish": _core.__version__, "shot": document, "frames": frames, "timeout": timeout, "run": run}


def run_task(task: Task, progress: Progress | None = None) -> list[Outcome]:
    """Run the frames of a task; what fails does not keep the others from being done. Raises what is wrong with the job itself."""
    if task["burnish"] != _core.__version__:
        raise BadArgument(f"this worker has burnish {_core.__version__}, the job is of {task['burnish']}; install the same everywhere")
    clock = _Clock(task, progress)
    try:
        with KEPT.runner(task) as runner:
            return outcomes_of(clock.timed(runner, ",".join(map(str, task["frames"]))))
    except OF_THE_JOB:
        raise
    except Exception as error:
        if error is clock.raised:
            raise
        if len(task["frames"]) == 1:
            return [failure(task["frames"][0], getattr(error, "code", "E_INTERNAL"), str(error))]
    alone = [{**task, "frames": [frame]} for frame in task["frames"]]
    return [outcome for one in alone for outcome in run_task(one, progress)]


def failure(frame: int, code: str, message: str) -> Outcome:
    """Tell of a frame that failed."""
    return {"frame": frame, "status": "failed", "code": code, "message": message}


def outcomes_of(report: dict[str, Any]) -> list[Outcome]:
    """What became of each frame, of the core's report. A frame with several entries, its views, is as bad as the worst of them."""
    outcomes: dict[int, Outcome] = {}
    for entry in report["frames"]:
        new = _outcome(entry)
        known = outcomes.setdefault(new["frame"], new)
        if known is not new:
            worst = min(known, new, key=lambda outcome: WORST_FIRST.index(outcome["status"]))
            known.update({key: worst[key] for key in ("status", "code", "message")}, seconds=known["seconds"] + new["seconds"],
                         warnings=known["warnings"] + new["warnings"])
    return list(outcomes.values())


def _outcome(entry: dict[str, Any]) -> Outcome:
    code, _, message = entry.get("error", "").partition(" ")
    is_missing = entry["status"] == "failed" and not os.path.exists(entry["input"])
    return {"frame": entry["frame"], "status": "missing" if is_missing else entry["status"], "code": code, "message": message,
            "seconds": sum(entry["seconds"].values()), "output": entry["output"], "warnings": entry["warnings"]}


class _Clock:
    """Runs the core, and ends it when the time of its frames is over."""

    def __init__(self, task: Task, progress: Progress | None) -> None:
        self.seconds, self.progress = task["timeout"], progress
        self.end = time.monotonic() + (self.seconds * len(task["frames"]) if self.seconds else float("inf"))
        self.is_over = False
        self.raised: BaseException | None = None  # by the callback

    def timed(self, runner: _core.ShotRunner, frames: str) -> dict[str, Any]:
        """The core's report. Raises TimedOut, and what the core and the callback raise."""
        try:
            return runner.run(frames, self._tell)
        except Cancelled as error:
            if self.is_over:
                raise TimedOut(f"took longer than {self.seconds:g} s a frame") from error
            raise

    def _tell(self, stage: str, done: float) -> bool:
        """Hand on; False where the work is to end."""
        self.is_over = time.monotonic() > self.end
        try:
            return not self.is_over and (self.progress is None or self.progress(stage, done) is not False)
        except BaseException as error:
            self.raised = error
            raise


class Kept:
    """Light and tables of the run that this process works for: made by its first task, dropped when it is over or another begins."""

    def __init__(self) -> None:
        self.lock = threading.Lock()
        self.run, self.idle = "", list[_core.ShotRunner]()

    @contextlib.contextmanager
    def runner(self, task: Task) -> Iterator[_core.ShotRunner]:
        """One that no other thread uses meanwhile."""
        with self.lock:
            if task["run"] != self.run:
                self.run, self.idle = task["run"], []
            runner = self.idle.pop() if self.idle else None
        runner = runner or _core.ShotRunner({"threads": _slots_of_worker(), **task["shot"]})
        yield runner
        with self.lock:
            if task["run"] and task["run"] == self.run:
                self.idle.append(runner)

    def forget(self, run: str) -> None:
        """Drop what was kept for a run."""
        with self.lock:
            if run == self.run:
                self.run, self.idle = "", []


KEPT = Kept()


def forget(run: str) -> None:
    """Drop what this process kept for a run."""
    KEPT.forget(run)


def _slots_of_worker() -> int:
    """Threads that a dask worker has for its tasks; 0, all cores, elsewhere."""
    distributed = sys.modules.get("distributed")
    if distributed is None:
        return 0
    get_worker: Callable[[], Any] = distributed.get_worker
    try:
        return get_worker().state.nthreads
    except ValueError:  # this is no worker
        return 0
