"""Sequences of frames: ranges as text, and shots composited over processes or a farm.

    import burnish
    report = burnish.sequence.run("shot.json", "1-200", processes=4)
    report.raise_if_failed()
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .frame_ranges import format_frames, parse_frames
from .report import FrameOutcome, SequenceReport
from .run_sequence import run

if TYPE_CHECKING:
    from collections.abc import Sequence

__all__ = ["FrameOutcome", "SequenceReport", "format_frames", "parse_frames", "run"]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run `burnish sequence`; returns its exit code."""
    from .command import main as command

    return command(arguments)
