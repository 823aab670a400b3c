"""Frames over a pool of workers, until each has an end: done, or failed as often as it may be tried."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

from ..errors import Cancelled, Error
from .pools import Dropped, Lost
from .report import FrameOutcome
from .tasks import OF_THE_JOB, TRANSIENT, failure

if TYPE_CHECKING:
    from collections.abc import Callable

    from .._core import Progress
    from .dask_pool import DaskPool
    from .pools import Processes, ThisProcess
    from .tasks import Outcome, Task

    Pool = ThisProcess | Processes | DaskPool


class Farm:
    """Hands tasks to a pool, and again those that should be tried again, until every frame has an end."""

    def __init__(self, pool: Pool, make: Callable[[list[int]], Task], numbers: list[int], retries: int, stops_at_bad: bool,
                 progress: Progress | None) -> None:
        self.pool, self.make, self.progress = pool, make, progress
        self.most_tries, self.stops_at_bad = 1 + retries, stops_at_bad
        self.outcomes = {number: FrameOutcome(number) for number in numbers}
        self.open = 0  # tasks under way

    def run(self, chunk: int) -> None:
        """All frames, `chunk` a task. Raises what is wrong with the job itself, Cancelled and LostConnection."""
        numbers = list(self.outcomes)
        for first in range(0, len(numbers), chunk):
            self._start(numbers[first:first + chunk])
        while self.open:
            for task, ended in self.pool.wait(self._tell):
                self.open -= 1
                self._end(task, ended)
            self._tell("frames")
            if self.stops_at_bad and any(each.status in ("missing", "failed") for each in self.outcomes.values()):
                return
        self._tell("done", is_over=True)

    def _start(self, frames: list[int]) -> None:
        self.open += 1
        for frame in frames:
            self.outcomes[frame].tries += 1
        self.pool.start(self.make(frames))

    def _end(self, task: Task, ended: list[Outcome] | Exception) -> None:
        """Take in what became of a task; some of its frames may start again."""
        frames = task["frames"]
        if isinstance(ended, Dropped):
            for frame in frames:
                self.outcomes[frame].tries -= 1  # it was no try
            self._start(frames)
        elif isinstance(ended, Lost) and len(frames) > 1:  # one frame may be what kills workers: find it
            middle = len(frames) // 2
            self._start(frames[:middle])
            self._start(frames[middle:])
        elif isinstance(ended, Lost):
            self._take([failure(frames[0], "E_LOST_WORKER", str(ended))], len(frames))
        elif isinstance(ended, OF_THE_JOB) or (isinstance(ended, Exception) and not isinstance(ended, Error)):
            raise ended
        elif isinstance(ended, Error):
            self._take([failure(frame, ended.code, str(ended)) for frame in frames], len(frames))
        else:
            self._take(ended, len(frames))

    def _take(self, told: list[Outcome], chunk: int) -> None:
        """Keep what became of frames, or try again those whose error may pass: together, as they share light and tables."""
        again = []
        for outcome in told:
            known = self.outcomes[outcome["frame"]]
            if outcome["status"] == "failed" and outcome["code"] in TRANSIENT and known.tries < self.most_tries:
                again.append(known.frame)
            else:
                self.outcomes[known.frame] = dataclasses.replace(known, **outcome)
        if again:
            self._start(again)

    def _tell(self, stage: str, _: float = 0, is_over: bool = False) -> bool:
        """Tell the share of all frames that is done. Raises Cancelled where the answer is to stop."""
        ended = sum(outcome.status != "left" for outcome in self.outcomes.values())
        done = 1.0 if is_over else min((ended + sum(self.pool.shares.values())) / len(self.outcomes), 1.0)
        if self.progress is not None and self.progress(stage, done) is False:
            raise Cancelled(f"cancelled after {ended} of {len(self.outcomes)} frames")
        return True
