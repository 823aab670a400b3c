"""`burnish chart --estimators`: error against lookups and against time of one thread, as CSV and as picture.

A special case of the chart: spheres, dense settings alone, one thread.
"""

from __future__ import annotations

import dataclasses

from . import benchmark, collection, picture, table
from .bench import Effort
from .files import both_or_none
from .grid import Grid
from .sweep import Sweep

GRID = Grid(benchmark.LOOKUPS, (), (), ())
SIZE, QUICK_SIZE = 64, 24  # of the sphere's pixels, across, that the reference sees one in so many of:
STEP = 4


def effort_of(size, quick, workers):
    """How carefully to measure; `size`: pixels along the sphere's diameter that have a reference."""
    careful = Effort(tolerance=0.01, most_lookups=32768, pixels=int(size * size * 0.785), runs=9, seconds=0.15, threads=1, workers=workers)
    return dataclasses.replace(careful, tolerance=0.03, seconds=0.0) if quick else careful


def sources_of(lights, materials, size):
    """A Source for each light; `lights`: name -> seed or file; `materials`: name -> benchmark.Material."""
    worn = {name: material.lobe() for name, material in materials.items()}

    def source(name, light):
        def load():
            return dataclasses.replace(collection.sphere_scene(name, name, light, worn, size * STEP), own=None)

        return collection.Source(name, len(worn), [size, light, worn, collection.file_stamps(light)], load)

    return [source(name, light) for name, light in lights.items()]


def run(folder, store, progress, sources, effort):
    """Measure and write; returns the lines to print."""
    sweep = Sweep(store, GRID, effort, progress)
    sweep.run(sources)
    kinds = {material.name: material.kind for material in benchmark.MATERIALS}
    rows = [table.estimator_row(row, kinds[row.material]) for row in sweep.rows(sources)]
    with both_or_none(folder, "estimators.csv", "estimators.png") as (lines, image):
        with open(lines, "w", encoding="utf-8", newline="") as file:
            table.write_csv(rows, file)
        picture.save(picture.draw(rows), image)
    return table.summary(rows)
