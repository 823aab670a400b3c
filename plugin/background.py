# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that work while Blender goes on: progress in the status bar, Esc stops, one line at the end.

In background mode they work at once.
"""

import bpy

from . import package
from .work import Work

_TICK = 0.1  # seconds

_running = set()


class Background:
    """An operator says what to do in `task(context)`, which returns a function of burnish's progress that knows no bpy, and in
    `finish(context, result)`, which returns one line to report."""

    def invoke(self, context, _event):
        """From a button."""
        if bpy.app.background:
            return self.execute(context)
        task = self._prepared(context)
        if task is None:
            return {"CANCELLED"}
        self._work = Work(task).start()
        _running.add(self._work)
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self._timer = manager.event_timer_add(_TICK, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        """While the thread works."""
        if event.type == "ESC":
            self._work.cancel()
            return {"RUNNING_MODAL"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if self._work.is_running:
            context.window_manager.progress_update(100 * self._work.done)
            context.workspace.status_text_set(f"burnish: {self._work.stage} {100 * self._work.done:.0f} %   Esc: stop")
            return {"RUNNING_MODAL"}
        self._clear(context)
        return self._ended(context, self._work.result, self._work.error)

    def cancel(self, context):
        """The window goes."""
        self._work.cancel()
        self._clear(context)

    def execute(self, context):
        """From a script: returns when it is done."""
        task = self._prepared(context)
        if task is None:
            return {"CANCELLED"}
        try:
            result = task(None)
        except Exception as error:  # told in one line, as every error
            return self._ended(context, None, error)
        return self._ended(context, result, None)

    def _prepared(self, context):
        try:
            return self.task(context)
        except (package.load().Error, RuntimeError, OSError) as error:
            self._ended(context, None, error)
            return None

    def _ended(self, context, result, error):
        if error is None:
            self.report({"INFO"}, self.finish(context, result))
            return {"FINISHED"}
        if isinstance(error, package.load().Cancelled):
            self.report({"WARNING"}, "burnish was stopped")
        else:
            self.report({"ERROR"}, " ".join(str(error).split()))
        return {"CANCELLED"}

    def _clear(self, context):
        _running.discard(self._work)
        context.window_manager.progress_end()
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)


def is_running():
    """Whether some operator works."""
    return any(work.is_running for work in _running)


def stop_all():
    """Cancel whatever works, and wait for it."""
    while _running:
        work = _running.pop()
        work.cancel()
        work.wait()
