"""The Pareto front of time against error, what the default loses to it, and what a picture of some quality costs.

`cost`: the name of the seconds that count: "frame_s", each further frame, or "alone_s", a frame alone with its light and tables.
"""

from __future__ import annotations

import dataclasses

TARGETS_DB = (35, 40, 45, 50)


def front_of(rows, cost="frame_s"):
    """The rows that no other beats in both time and dB, the fastest first."""
    members = []
    for row in sorted(rows, key=lambda row: (getattr(row, cost), -row.psnr_db)):
        if not members or row.psnr_db > members[-1].psnr_db:
            members.append(row)
    return members


def cheapest(rows, target_db, cost="frame_s"):
    """The fastest row that reaches the target; None where none does."""
    return min((row for row in rows if row.psnr_db >= target_db), key=lambda row: getattr(row, cost), default=None)


def best_within(rows, seconds, cost="frame_s"):
    """The row with the least error that takes no longer; None where all do."""
    return max((row for row in rows if getattr(row, cost) <= seconds), key=lambda row: row.psnr_db, default=None)


@dataclasses.dataclass(frozen=True)
class Regret:
    """What the default loses: times as slow as the fastest with no more error, and dB below the best in no more time."""

    default: object  # Row
    slower: float  # 1: none is as good and faster
    faster_row: object
    lost_db: float
    better_row: object


def regret_of(rows, cost="frame_s"):
    """The Regret of the default among all rows of a part; None where it was not measured."""
    default = next((row for row in rows if row.is_default), None)
    if default is None:
        return None
    spent = getattr(default, cost)
    faster, better = cheapest(rows, default.psnr_db, cost), best_within(rows, spent, cost)
    return Regret(default, spent / max(getattr(faster, cost), 1e-9), faster, better.psnr_db - default.psnr_db, better)
