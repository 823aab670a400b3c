# SPDX-License-Identifier: GPL-3.0-or-later
"""The thread that shades a session's looks: the newest one wins. No bpy here.

A look that comes while another is shaded waits; one that comes after it takes its place.
"""

import threading
import time

_KEPT = 50  # latencies that a median is of


class LiveWorker:
    """Takes looks, leaves pictures."""

    def __init__(self, session):
        self.session = session
        self.latencies = []  # seconds from a slider's move to its picture
        self.error = None
        self._wanted, self._ready = None, None
        self._change = threading.Condition()
        self._is_busy, self._is_ended = True, False
        self._thread = threading.Thread(target=self._run, name="burnish live", daemon=True)
        self._thread.start()

    def want(self, look):
        """Ask for a look, now."""
        with self._change:
            self._wanted = (look, time.perf_counter())
            self._change.notify_all()

    def take(self):
        """(overlay, composite, the moment they were asked for) that nobody took yet, or None."""
        with self._change:
            ready, self._ready = self._ready, None
        return ready

    def wait(self):
        """Until nothing is left to shade."""
        with self._change:
            self._change.wait_for(lambda: not self._wanted and not self._is_busy)

    def end(self):
        """Stop, and wait for the thread."""
        with self._change:
            self._is_ended = True
            self._change.notify_all()
        self._thread.join()

    def note(self, seconds):
        """Keep how long a picture took."""
        self.latencies = [*self.latencies, seconds][-_KEPT:]

    def _run(self):
        self._attempt(self.session.warm)
        while self._next():
            (look, asked), self._wanted = self._wanted, None
            if self._attempt(lambda look=look: self.session.shade(look)):
                pictures = self.session.pictures()
                with self._change:
                    self._ready = (*pictures, asked)

    def _next(self):
        """Wait for a look; False at the end."""
        with self._change:
            self._is_busy = False
            self._change.notify_all()
            self._change.wait_for(lambda: self._wanted or self._is_ended)
            self._is_busy = not self._is_ended
            return self._is_busy

    def _attempt(self, work):
        try:
            work()
        except Exception as error:  # shown in the panel: a slider has nobody to report to
            self.error = error
            return False
        self.error = None
        return True
