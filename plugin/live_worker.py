# SPDX-License-Identifier: GPL-3.0-or-later
"""The thread that shades a session's looks: the newest one wins. No bpy here.

A look that comes while another is shaded waits; one that comes after it takes its place. When none comes, the last one is
refined.
"""

import threading
import time

_KEPT = 50   # latencies that a median is of
_REST = 0.3  # seconds without a move, until the picture is refined


class LiveWorker:
    """Takes looks, leaves pictures."""

    def __init__(self, session):
        self.session = session
        self.latencies = []  # seconds from a slider's move to its picture
        self.error = None
        self._wanted, self._ready = None, None
        self._change = threading.Condition()
        self._is_busy, self._is_rough, self._is_ended = False, False, False
        self._thread = threading.Thread(target=self._run, name="burnish live", daemon=True)
        self._thread.start()

    def want(self, look):
        """Ask for a look, now."""
        with self._change:
            self._wanted = (look, time.perf_counter())
            self._change.notify_all()

    def take(self):
        """(overlay, composite, the moment they were asked for) that nobody took yet, or None; refined ones were not asked for."""
        with self._change:
            ready, self._ready = self._ready, None
        return ready

    def wait(self):
        """Until there are pictures to take, or nothing is left to shade; returns which."""
        with self._change:
            self._change.wait_for(lambda: self._ready or not (self._wanted or self._is_busy or self._is_rough))
            return self._ready is not None

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
        while True:
            with self._change:
                self._is_busy = False
                self._change.notify_all()
                self._change.wait_for(lambda: self._wanted or self._is_ended, _REST if self._is_rough else None)
                if self._is_ended:
                    return
                wanted, self._wanted, self._is_busy = self._wanted, None, True
                self._is_rough = wanted is not None
            self._attempt(*(wanted or (None, None)))

    def _attempt(self, look, asked):
        """Shade a look, or refine the last one."""
        try:
            if look:
                self.session.shade(look)
            else:
                self.session.refine()
            pictures = self.session.pictures()
        except Exception as error:  # shown in the panel: a slider has nobody to report to
            self.error, self._is_rough = error, False
            return
        with self._change:
            self.error, self._ready = None, (*pictures, asked)
            self._change.notify_all()
