# SPDX-License-Identifier: GPL-3.0-or-later
"""Live: a slider that moves composites again, in a thread, and the pictures go into the images. At once in background mode."""

import statistics
import time

import bpy

from . import bridge, images
from .live_worker import LiveWorker

_POLL = 0.01  # seconds

_workers = {}  # name of the scene -> LiveWorker


def begin(scene, session):
    """Let the scene's sliders move this session's pictures."""
    end(scene)
    _workers[scene.name] = LiveWorker(session)
    if not bpy.app.background and not bpy.app.timers.is_registered(_poll):
        bpy.app.timers.register(_poll)


def end(scene):
    """Let go of the scene's frame."""
    if (worker := _workers.pop(scene.name, None)) is not None:
        worker.end()


def session(scene):
    """What the scene's sliders move, or None."""
    worker = _workers.get(scene.name)
    return worker.session if worker else None


def moved(scene):
    """A slider of the scene moved."""
    worker = _workers.get(scene.name)
    if worker is None or bridge.is_syncing():
        return
    worker.want(bridge.look(scene))
    if bpy.app.background:
        settle(scene)


def settle(scene):
    """Wait until the picture of the last move is refined, and show it."""
    worker = _workers.get(scene.name)
    while worker and worker.wait():
        _show(worker)


def latencies(scene):
    """Seconds from a move to its picture, of the last moves."""
    worker = _workers.get(scene.name)
    return list(worker.latencies) if worker else []


def latency(scene):
    """Their median; None before the first."""
    return statistics.median(latencies(scene)) if latencies(scene) else None


def error(scene):
    """Why the last move has no picture, or None."""
    worker = _workers.get(scene.name)
    return worker.error if worker else None


def _show(worker):
    if (ready := worker.take()) is None:
        return
    overlay, composite, asked = ready
    images.show(images.OVERLAY, overlay, worker.session.covered)
    images.show(images.COMPOSITE, composite)
    if asked:
        worker.note(time.perf_counter() - asked)
    images.redraw()


def _poll():
    for worker in _workers.values():
        _show(worker)
    return _POLL if _workers else None


@bpy.app.handlers.persistent
def _forget(*_):
    """Another file is opened: its scenes may have the same names."""
    for name in list(_workers):
        _workers.pop(name).end()


CLASSES = ()


def register():
    """Watch for files that are opened."""
    bpy.app.handlers.load_pre.append(_forget)


def unregister():
    """End the threads."""
    _forget()
    if _forget in bpy.app.handlers.load_pre:
        bpy.app.handlers.load_pre.remove(_forget)
    if bpy.app.timers.is_registered(_poll):
        bpy.app.timers.unregister(_poll)
