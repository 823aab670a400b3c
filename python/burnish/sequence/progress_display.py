"""How progress is shown on standard error, in the forms of burnish's other commands: a bar for people, lines for farms."""

from __future__ import annotations

import json
import sys

FORMATS = ("auto", "none", "text", "alf", "json", "openjd")
WIDTH = 32


class ProgressDisplay:
    """A progress callback that shows whole percents as they come."""

    def __init__(self, form: str) -> None:
        self.form = form if form != "auto" else "bar" if sys.stderr.isatty() else "none"
        self.percent = -1

    def __call__(self, stage: str, done: float) -> None:
        """Show it, unless it is shown already."""
        percent = int(done * 100)
        if self.form == "none" or percent <= self.percent:
            return
        self.percent = percent
        end = "" if self.form == "bar" else "\n"
        print(self.line(stage, percent), end=end, file=sys.stderr, flush=True)

    def line(self, stage: str, percent: int) -> str:
        """One percent in the form asked for."""
        if self.form == "bar":
            return f"\r\033[K[{'#' * (percent * WIDTH // 100):{WIDTH}}] {percent:3} %  {stage}"
        if self.form == "alf":
            return f"ALF_PROGRESS {percent}%"
        if self.form == "openjd":
            return f"openjd_progress: {percent}"
        if self.form == "json":
            return json.dumps({"percent": percent, "stage": stage}, separators=(",", ":"))
        return f"{percent:3} % {stage}"

    def close(self) -> None:
        """End the bar's line."""
        if self.form == "bar" and self.percent >= 0:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
