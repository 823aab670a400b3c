"""Where tasks run: in this process, in several of this machine, or (dask_pool.py) on a farm.

A pool is handed tasks with `start` and gives them back with `wait`, in any order, each with what became of its frames or with the
exception that it ended with. `Lost` says that the worker died, and `Dropped` that the task never ran to its end through no fault of its own.
"""

from __future__ import annotations

import contextlib
import json
import os
import pathlib
import queue
import signal
import subprocess
import sys
import threading
import time
from typing import TYPE_CHECKING, Any

from .. import errors
from ..errors import Error
from .tasks import TimedOut, forget, run_task

if TYPE_CHECKING:
    from .._core import Progress
    from .tasks import Outcome, Task

    Ended = tuple[Task, list[Outcome] | Exception]


class Lost(Exception):
    """The process that worked on a task died."""


class Dropped(Exception):
    """The farm forgot a task, as the connection to it broke."""


class ThisProcess:
    """Runs one task after the other, here."""

    workers = 1

    def __init__(self) -> None:
        self.tasks: list[Task] = []
        self.shares: dict[int, float] = {}  # frames' worth that is done of tasks under way

    def start(self, task: Task) -> None:
        """Put a task in the queue."""
        self.tasks.append(task)

    def wait(self, progress: Progress) -> list[Ended]:
        """Run the next task; `progress` hears of it."""
        task = self.tasks.pop(0)

        def tell(stage: str, done: float) -> bool | None:
            self.shares = {id(task): done * len(task["frames"])}
            return progress(stage, done)

        try:
            return [(task, run_task(task, tell))]
        except Exception as error:
            return [(task, error)]
        finally:
            self.shares = {}

    def stop(self, run: str) -> None:
        """Forget the queue, and what was kept for the run."""
        self.tasks.clear()
        forget(run)


class Processes:
    """Processes of this machine, each with one task at a time; one that dies loses its task and is replaced."""

    GRACE_S = 10.0  # beyond a task's own time, then its process is killed
    STOP_S = 3.0  # to end in when asked to

    def __init__(self, count: int) -> None:
        self.workers = count
        self.tasks: queue.Queue[Task | None] = queue.Queue()
        self.ended: queue.Queue[Ended] = queue.Queue()
        self.shares: dict[int, float] = {}
        self.is_stopped = False
        self.children: list[subprocess.Popen[str]] = []
        self.drivers = [threading.Thread(target=self._drive, daemon=True) for _ in range(count)]
        for driver in self.drivers:
            driver.start()

    def start(self, task: Task) -> None:
        """Put a task in the queue; every core has its share of threads."""
        threads = task["shot"].get("threads") or max(1, (os.cpu_count() or 1) // self.workers)
        self.tasks.put({**task, "shot": {**task["shot"], "threads": threads}})

    def wait(self, progress: Progress) -> list[Ended]:
        """Whatever ended within a moment."""
        try:
            return [self.ended.get(timeout=0.1)]
        except queue.Empty:
            return []

    def stop(self, _: str) -> None:
        """Ask what runs to end, which leaves nothing half-written, and wait for it."""
        self.is_stopped = True
        for _ in self.drivers:
            self.tasks.put(None)
        for child in list(self.children):
            child.send_signal(signal.SIGINT)
        end = time.monotonic() + self.STOP_S
        for driver in self.drivers:
            driver.join(max(0.0, end - time.monotonic()))
        for child in list(self.children):
            child.kill()
        for driver in self.drivers:
            driver.join(self.STOP_S)

    def _drive(self) -> None:
        """Hand tasks to one process, and to another when it died."""
        child = None
        while (task := self.tasks.get()) is not None and not self.is_stopped:
            if child is None or child.poll() is not None:
                child = self._new_child()
            try:
                ended: list[Outcome] | Exception = self._converse(child, task)
            except Exception as error:
                ended = error
            self.shares.pop(threading.get_ident(), None)
            self.ended.put((task, ended))
        if child is not None:
            with contextlib.suppress(BrokenPipeError):
                child.stdin.close()
            child.wait()

    def _new_child(self) -> subprocess.Popen[str]:
        package = str(pathlib.Path(__file__).resolve().parent.parent.parent)
        path = os.pathsep.join(filter(None, [package, os.environ.get("PYTHONPATH")]))
        command = [sys.executable, "-m", "burnish.sequence.process_worker"]
        child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, start_new_session=True,
                                 env={**os.environ, "PYTHONPATH": path})
        self.children.append(child)
        return child

    def _converse(self, child: subprocess.Popen[str], task: Task) -> list[Outcome]:
        """A line with the task, then lines with its progress until one with its end."""
        is_late = threading.Event()

        def kill() -> None:
            is_late.set()
            child.kill()

        killer = threading.Timer((task["timeout"] or 0) * len(task["frames"]) + self.GRACE_S, kill)
        if task["timeout"]:
            killer.start()
        try:
            child.stdin.write(json.dumps(task) + "\n")
            child.stdin.flush()
            for line in child.stdout:
                told = json.loads(line)
                if "done" not in told:
                    return _result(told)
                self.shares[threading.get_ident()] = told["done"] * len(task["frames"])
        except BrokenPipeError:
            pass
        finally:
            killer.cancel()
        code = child.wait()
        if is_late.is_set():
            raise TimedOut(f"took longer than {task['timeout']:g} s a frame, without a sign of life")
        raise Lost(f"its process died with {'signal ' + str(-code) if code < 0 else 'exit code ' + str(code)}")


def _result(told: dict[str, Any]) -> list[Outcome]:
    """The outcomes of a task, or the exception it ended with."""
    if "outcomes" in told:
        return told["outcomes"]
    raise errors.BY_CODE.get(told["code"], Error)(told["message"])
