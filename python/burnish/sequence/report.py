"""What became of the frames of a sequence."""

from __future__ import annotations

import collections
import dataclasses
import json
from typing import Any, Literal

from ..errors import FramesFailed
from .frame_ranges import format_frames

Status = Literal["done", "skipped", "held", "missing", "failed", "left"]
STATUSES: tuple[Status, ...] = ("done", "skipped", "held", "missing", "failed", "left")
WORDS = {"skipped": "up to date", "left": "not begun"}


@dataclasses.dataclass
class FrameOutcome:
    """What became of one frame.

    Attributes
    ----------
    frame : int
        Its number.
    status : str
        "done"; "skipped": its output was up to date; "held": it failed or has no input, and its output is that of frame `held_from`;
        "missing": it has no input; "failed"; "left": not begun when the run stopped.
    code, message : str
        Why it failed: a stable name such as "E_READ_FAILED", and the text. "" where it did not.
    seconds : float
        Wall time of its stages on the worker; 0 where nothing was done.
    tries : int
        How often it was begun; more than 1 is a retry.
    output : str
        Its file.
    warnings : list of str
        Of the frame.
    held_from : int or None
        The frame whose output stands in for it.
    """

    frame: int
    status: Status = "left"
    code: str = ""
    message: str = ""
    seconds: float = 0.0
    tries: int = 0
    output: str = ""
    warnings: list[str] = dataclasses.field(default_factory=list)
    held_from: int | None = None


class SequenceReport:
    """What became of every frame of a sequence, and how long it took.

    Attributes
    ----------
    frames : list of FrameOutcome
        In the order they were asked for.
    seconds : float
        Wall time of the run.
    workers : int
        Frames or chunks that could run at the same time.
    chunk : int
        Frames that a worker was handed at once.
    """

    def __init__(self, frames: list[FrameOutcome], seconds: float, workers: int, chunk: int) -> None:
        self.frames, self.seconds, self.workers, self.chunk = frames, seconds, workers, chunk

    def of(self, *statuses: Status) -> list[int]:
        """Frames with one of these statuses.

        Parameters
        ----------
        *statuses : str
            "done", "skipped", "held", "missing", "failed", "left".

        Returns
        -------
        list of int
            Frame numbers, in order.

        Raises
        ------
        MemoryError
            Only when there is no memory for the answer.
        """
        return [outcome.frame for outcome in self.frames if outcome.status in statuses]

    @property
    def is_complete(self) -> bool:
        """Whether every frame has an output of its own."""
        return len(self.of("done", "skipped")) == len(self.frames)

    def summary(self) -> str:
        """Say on one line how it went.

        Returns
        -------
        str
            Such as "197 of 200 frames done, 2 up to date, 1 failed (12: E_READ_FAILED), 1 retried, 81.2 s"; no list or dict.

        Raises
        ------
        MemoryError
            Only when there is no memory for the answer.
        """
        parts = [f"{len(self.of('done'))} of {len(self.frames)} frames done"]
        for status in STATUSES[1:]:
            numbers = self.of(status)
            codes = collections.Counter(each.code for each in self.frames if each.status == status and each.code)
            why = f" ({format_frames(numbers)}{': ' + ', '.join(codes) if codes else ''})" if status in STATUSES[2:] else ""
            parts += [f"{len(numbers)} {WORDS.get(status, status)}{why}"] if numbers else []
        retried = sum(outcome.tries > 1 for outcome in self.frames)
        return ", ".join([*parts, *([f"{retried} retried"] if retried else []), f"{self.seconds:.1f} s"])

    def to_dict(self) -> dict[str, Any]:
        """Everything as plain values.

        Returns
        -------
        dict
            Counts by status, "frames" (a dict each, see `FrameOutcome`), "seconds", "workers", "chunk", "summary".

        Raises
        ------
        MemoryError
            Only when there is no memory for the answer.
        """
        counts = {status: len(self.of(status)) for status in STATUSES}
        frames = [dataclasses.asdict(outcome) for outcome in self.frames]
        return {**counts, "frames": frames, "seconds": self.seconds, "workers": self.workers, "chunk": self.chunk,
                "summary": self.summary()}

    def to_json(self) -> str:
        """Everything as JSON.

        Returns
        -------
        str
            The dict of `to_dict`, indented.

        Raises
        ------
        MemoryError
            Only when there is no memory for the answer.
        """
        return json.dumps(self.to_dict(), indent=2)

    def raise_if_failed(self) -> None:
        """Raise where a frame failed, has no input or was not begun.

        Returns
        -------
        None
            Every frame on the list is done, up to date or held.

        Raises
        ------
        FramesFailed
            The first of them is named; `report` of the exception is this one.
        """
        first = next((each for each in self.frames if each.status in ("failed", "missing", "left")), None)
        if first is not None:
            raise FramesFailed(f"frame={first.frame} {first.code} {first.message} ({self.summary()})", self)

    def __repr__(self) -> str:
        return f"SequenceReport({self.summary()})"
