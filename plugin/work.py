# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in a thread while Blender goes on: progress as it comes, Esc, one result or one error at the end. No bpy here."""

import threading


class Cancelled(Exception):
    """Someone asked for the end."""


class Work:
    """`task(progress)` in a thread; it hands `progress` to burnish as it is."""

    def __init__(self, task):
        self.stage, self.done = "", 0.0
        self.result, self.error = None, None
        self._is_cancelled = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(task,), name="burnish", daemon=True)

    def start(self):
        """Begin; returns itself."""
        self._thread.start()
        return self

    def cancel(self):
        """Ask for the end, which comes with burnish's next word of progress."""
        self._is_cancelled.set()

    def wait(self):
        """Until it has ended."""
        self._thread.join()

    @property
    def is_running(self):
        """Whether it has not ended."""
        return self._thread.is_alive()

    @property
    def was_cancelled(self):
        """Whether the end was asked for."""
        return self._is_cancelled.is_set()

    def progress(self, stage, done):
        """As burnish calls it; False cancels."""
        self.stage, self.done = stage, done
        return not self._is_cancelled.is_set()

    def _run(self, task):
        try:
            self.result = task(self.progress)
        except Exception as error:  # shown in one line by whoever started this
            self.error = error
