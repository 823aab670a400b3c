"""The run: every setting of every part of every scene, from the store where it is there, measured where not.

What the report shows of a scene's picture is kept beside its rows as soon as the scene is done.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from .. import BadArgument, __version__
from . import measure
from .bench import Bench, Seen, together
from .scene import WHOLE

REFUSING = ("factored",)
"""Estimators that say no to some materials and lights: anisotropic ones, and those that are near."""


@dataclasses.dataclass
class Sweep:
    """Scenes, the settings to try on them and the care to take.

    `errors`: makes error images of a scene's parts, or None; `only`: names of the parts to measure, empty for all.
    """

    store: object
    grid: object
    effort: object
    progress: object
    errors: object = None
    only: tuple = ()
    names: set = dataclasses.field(default_factory=set)  # of the parts that were met

    def digest(self, source):
        """What the rows of a scene are known by."""
        return source.digest(__version__, dataclasses.asdict(self.grid), dataclasses.asdict(self.effort), self.effort.cores)

    def run(self, sources):
        """Measure what is not measured yet. Throws BadArgument where `only` names nothing that is there."""
        self.progress.begin([(source.name, source.count * self.grid.about()) for source in sources])
        for source in sources:
            if self.digest(source) not in self.store.done:
                self.measure(source)
            self.progress.scene_done()
        if self.only and not any(row.material in self.only for row in self.rows(sources)):
            raise BadArgument(f"--materials: there is no {' '.join(self.only)}; there are {', '.join(sorted(self.names))}")

    def rows(self, sources):
        """All that is measured of the scenes."""
        return self.store.of([self.digest(source) for source in sources])

    def measure(self, source):
        """One scene, part by part; the whole frame comes last."""
        digest, scene = self.digest(source), source.load()
        bench, seen = Bench(scene, self.effort), Kept(self.store, source.name, digest)
        self.names |= {part.name for part in scene.parts}
        parts = self.chosen(scene)
        for part in parts:
            of_part = together(list(seen.parts.values())) if part.name == WHOLE else seen.see(bench, part)
            if of_part.pixels.size and of_part.truth.radiance.mean() > 0:
                self.explore(digest, bench, part, of_part)
        images = self.errors(bench, parts, self.store.of([digest]), seen.parts) if self.errors else {}
        seen.save(**images)
        if len(parts) == len(scene.parts):
            self.store.finish(digest)

    def chosen(self, scene):
        """The parts to measure, all those of the whole frame before it."""
        return [part for part in scene.parts if not self.only or part.name in self.only or WHOLE in self.only]

    def explore(self, digest, bench, part, seen):
        """All settings of a part."""
        asked = self.grid.explore(bench.scene.own, bench.scene.lights)
        row = None
        try:
            while True:
                row = self.row_of(digest, bench, part, seen, asked.send(row))
        except StopIteration:
            return

    def row_of(self, digest, bench, part, seen, setting):
        """From the store, or measured; None where the estimator cannot shade the part."""
        row = self.store.find(digest, part.name, setting)
        if row is None:
            try:
                row = bench.row(part, seen, setting)
            except BadArgument:
                if setting.estimator not in REFUSING:
                    raise
            else:
                self.store.add(digest, row)
                self.progress.step(row)
                return row
        self.progress.skip()
        return row


class Kept:
    """What the reference saw of the parts of a scene, kept in the store."""

    def __init__(self, store, name, digest):
        self.store, self.name, self.digest = store, name, digest
        self.parts = {}
        kept = store.load(name, digest)
        for index, part in enumerate(kept.get("parts", ())):
            exact = measure.Truth(kept[f"radiance_{index}"], kept[f"noise_{index}"])
            self.parts[str(part)] = Seen(kept[f"pixels_{index}"], exact, float(kept[f"lookups_{index}"]))

    def see(self, bench, part):
        """Of one part."""
        if part.name not in self.parts:
            self.parts[part.name] = bench.see(part)
            self.save()
        return self.parts[part.name]

    def save(self, **more):
        """Write all of it."""
        arrays = {"parts": np.array(list(self.parts))}
        for index, seen in enumerate(self.parts.values()):
            arrays |= {f"pixels_{index}": seen.pixels, f"radiance_{index}": seen.truth.radiance, f"noise_{index}": seen.truth.noise,
                       f"lookups_{index}": seen.lookups}
        self.store.save(self.name, self.digest, **arrays, **more)
