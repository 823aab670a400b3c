"""Progress on standard error with an estimate of what is left: tqdm's bar where there is tqdm, else a line every few seconds."""

from __future__ import annotations

import importlib.util
import sys
import time

BETWEEN_LINES_S = 2.0


class Progress:
    """Counts settings: those of each scene are guessed beforehand and corrected as it is done."""

    def __init__(self, quiet=False, unit="settings"):
        self.quiet, self.unit = quiet, unit
        self.bar = None

    def begin(self, scenes):
        """Pairs of name and guessed count."""
        self.left = [count for _, count in scenes]
        self.done, self.measured, self.in_scene = 0, 0, 0
        self.start = self.told = time.monotonic()
        if not self.quiet and importlib.util.find_spec("tqdm"):
            from tqdm import tqdm

            self.bar = tqdm(total=sum(self.left), unit=self.unit)

    def step(self, row):
        """A setting was measured."""
        self.measured += 1
        self.count(1)
        self.tell(f"{row.scene}, {row.material}: {row.setting.label}, {row.psnr_db:.1f} dB, {1e3 * row.frame_s:.1f} ms")

    def skip(self):
        """A setting was there already."""
        self.count(1)

    def count(self, n):
        """Add to what is done."""
        self.done += n
        self.in_scene += n
        if self.bar is not None:
            self.bar.update(n)

    def scene_done(self):
        """Take the scene's guess back."""
        self.left.pop(0)
        self.in_scene = 0
        if self.bar is not None:
            self.bar.total = self.done + sum(self.left)
            self.bar.refresh()

    def remaining(self):
        """Settings that are to come, about."""
        return max(self.left[0] - self.in_scene, 0) + sum(self.left[1:]) if self.left else 0

    def tell(self, text):
        """A line, if the last one is long enough ago."""
        now = time.monotonic()
        if self.bar is not None:
            self.bar.set_postfix_str(text, refresh=False)
        elif not self.quiet and (self.measured == 1 or now - self.told > BETWEEN_LINES_S):
            self.told = now
            left = (now - self.start) / self.measured * self.remaining()
            share = self.done / max(self.done + self.remaining(), 1)
            print(f"{100 * share:3.0f} %  {text}; {spelled(left)} left", file=sys.stderr, flush=True)

    def close(self):
        """End the bar."""
        if self.bar is not None:
            self.bar.close()


def spelled(seconds):
    """"40 s", "3 min"."""
    return f"about {seconds:.0f} s" if seconds < 90 else f"about {seconds / 60:.0f} min"
