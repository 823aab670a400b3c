"""The environment of a scene in the representations that settings ask for, and the time each takes to make.

The Gaussian stack is made at the first use and kept, so settings that need it have an Environment of their own: the first
shading with it pays, `note_tables` remembers how much.
"""

from __future__ import annotations

import time

from .. import Environment
from .setting import FACES


class Lights:
    """Environments by use, suns and face size; without a source (all light is near) there are none."""

    def __init__(self, source, settings=None):
        self.source, self.settings = source, settings or {}
        self.made, self.tables = {}, {}
        self.full_size = None

    @property
    def has_environment(self):
        """Whether suns and pyramid can be chosen."""
        return self.source is not None

    def get(self, use, suns, face):
        """The Environment and the seconds it took; None and 0 where there is none."""
        if self.source is None:
            return None, 0.0
        key = use, suns, face
        if key not in self.made:
            self.made[key] = self.make(suns, face)
        return self.made[key]

    def make(self, suns, face):
        """One made afresh, as timed. The pyramid is made when first asked for its size."""
        settings = dict(self.settings)
        if suns != "auto":
            settings["env_suns"] = suns
        if FACES[face] > 1:
            settings["env_face_size"] = max(self.size() // FACES[face], 1)
        begin = time.perf_counter()
        environment = Environment(self.source, **settings)
        environment.level_count
        return environment, time.perf_counter() - begin

    def size(self):
        """Texels along a face of the full pyramid."""
        if self.full_size is None:
            self.full_size = self.get("pyramid", "auto", "full")[0].face_size
        return self.full_size

    def has_suns(self):
        """Whether discs are taken out of the map."""
        return self.has_environment and any("taken out" in note for note in self.get("pyramid", "auto", "full")[0].notes)

    def note_tables(self, key, seconds):
        """Remember what a light's tables took at their first use; returns what was remembered first."""
        return self.tables.setdefault(key, seconds)
