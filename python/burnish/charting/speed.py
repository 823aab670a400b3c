"""`burnish chart`: speed against accuracy of every way to shade, on shots or on the fixed benchmark set, as a page and as data."""

from __future__ import annotations

import dataclasses

from .. import __version__
from . import report
from .bench import Effort
from .files import both_or_none
from .grid import Grid
from .images import images_of
from .store import write_json
from .sweep import Sweep
from .table import write_csv

GRID = Grid({"fitted": (1, 2, 3, 4, 6, 8, 12), "regular": (4, 7, 12, 19, 30, 61), "filtered_importance": (4, 16, 64),
             "preconvolved": (4, 16, 64), "split_sum": (1,), "factored": (1,)})
QUICK_GRID = Grid({"fitted": (2, 4, 8), "regular": (7, 19), "filtered_importance": (16,), "preconvolved": (16,), "split_sum": (1,),
                   "factored": (1,)},
                  (1.0, 2.0), ("keep",), ("half",))
EFFORT = Effort()
QUICK_EFFORT = Effort(tolerance=0.03, most_lookups=4096, pixels=300, seconds=0.1)


def sweep_of(store, progress, quick, threads, only=()):
    """The Sweep of a chart; `only`: names of parts, empty for all."""
    effort = dataclasses.replace(QUICK_EFFORT if quick else EFFORT, threads=threads, workers=threads)
    return Sweep(store, QUICK_GRID if quick else GRID, effort, progress, images_of, only)


def write(folder, sweep, sources):
    """rows.csv, rows.json and report.html of what is measured."""
    rows = sweep.rows(sources)
    kept = {source.name: sweep.store.load(source.name, sweep.digest(source)) for source in sources}
    page = report.page_of(rows, sweep.effort, kept)
    with both_or_none(folder, "rows.csv", "rows.json", "report.html") as (table, data, html):
        with open(table, "w", encoding="utf-8", newline="") as file:
            write_csv(rows, file)
        write_json(rows, data, burnish=__version__, threads=sweep.effort.cores, effort=dataclasses.asdict(sweep.effort))
        html.write_text(page.text_of(), encoding="utf-8")


def summary(sweep, sources):
    """Lines to print."""
    rows = sweep.rows(sources)
    return [f"{len(rows)} settings, {sweep.store.new} of them measured now, on {len(report.cases(rows))} pairs of a scene and a material"]
