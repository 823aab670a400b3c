"""Which settings are worth measuring: not all products, but each choice where the one before paid.

Every estimator x sample count densely; sparse shading of what lies on the front of these; other lights on the front of all.
"""

from __future__ import annotations

import dataclasses

from .front import front_of
from .setting import FACES, Setting

MOST_MEMBERS = 4  # of a front that the next choice is tried on


@dataclasses.dataclass(frozen=True)
class Grid:
    """The values that each choice has. `lookups`: estimator -> counts asked for."""

    lookups: dict
    safeties: tuple = (0.5, 1.0, 2.0, 4.0)
    suns: tuple = ("keep",)
    faces: tuple = tuple(face for face in FACES if face != "full")

    def dense(self):
        """Every estimator x sample count."""
        return [Setting(estimator, n, "dense") for estimator, counts in self.lookups.items() for n in counts]

    def about(self):
        """How many settings a part comes to, about."""
        return len(self.dense()) + MOST_MEMBERS * (len(self.safeties) + len(self.suns) + len(self.faces)) - 3

    def explore(self, own, lights):
        """A generator of settings that is sent the Row of each, None of what cannot shade the part."""
        rows, tried = [], []
        for choices in (self.of_own, self.of_density, self.of_light):
            for setting in choices(own, lights, rows):
                if setting not in tried:
                    tried.append(setting)
                    row = yield setting
                    rows += [row] if row else []

    def of_own(self, own, lights, rows):
        """The scene's own setting and all dense ones."""
        return ([own] if own else []) + self.dense()

    def of_density(self, own, lights, rows):
        """Sparse shading of the dense front."""
        members = spread(front_of([row for row in rows if row.density == "dense"]))
        return [row.setting.replace(density="sparse", safety=safety) for row in members for safety in self.safeties]

    def of_light(self, own, lights, rows):
        """Lights made otherwise, for the best of what was measured."""
        if not lights.has_environment:
            return []
        changes = [{"suns": suns} for suns in self.suns if lights.has_suns()] + [{"face": face} for face in self.faces]
        return [row.setting.replace(**change) for row in spread(front_of(rows)) for change in changes]


def spread(members):
    """At most MOST_MEMBERS of a front, its ends and what lies evenly between them."""
    if len(members) <= MOST_MEMBERS:
        return members
    step = (len(members) - 1) / (MOST_MEMBERS - 1)
    return [members[round(index * step)] for index in range(MOST_MEMBERS)]
