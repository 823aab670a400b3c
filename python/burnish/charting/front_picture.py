"""Pareto fronts of a scene as a picture: a panel for each material, time against dB, the default marked."""

from __future__ import annotations

import numpy as np

from .front import front_of
from .picture import COLOURS, FAINT, INK, SOFT

COLUMNS, PANEL_IN, DPI = 3, (3.6, 2.7), 100
COSTS = {"frame_s": "each further frame", "alone_s": "a frame alone, light and tables included"}
OTHER = "#888888"


def draw(parts):
    """A matplotlib Figure; `parts`: title -> (rows, cost)."""
    from matplotlib.figure import Figure

    columns = min(COLUMNS, len(parts))
    lines = -(-len(parts) // columns)
    figure = Figure(figsize=(PANEL_IN[0] * columns, PANEL_IN[1] * lines + 0.45), dpi=DPI, facecolor="white")
    panels = figure.subplots(lines, columns, squeeze=False)
    for panel, (title, (rows, cost)) in zip(panels.flat, parts.items()):
        draw_panel(panel, title, rows, cost)
    for panel in panels.flat[len(parts):]:
        panel.axis("off")
    add_legend(figure, {row.estimator: None for rows, _ in parts.values() for row in rows})
    figure.tight_layout(rect=(0, 0.35 / figure.get_figheight(), 1, 1))
    return figure


def draw_panel(panel, title, rows, cost):
    """All rows as dots, dense ones full; the front as a line; the default as a star."""
    def at(some):
        return [1e3 * getattr(row, cost) for row in some], [row.psnr_db for row in some]

    front = front_of(rows, cost)
    panel.step(*at(front), where="post", color=INK, linewidth=1, alpha=0.6, zorder=1)
    for estimator in dict.fromkeys(row.estimator for row in rows):
        colour = COLOURS.get(estimator, OTHER)
        for density, fill in (("dense", colour), ("sparse", "white")):
            some = [row for row in rows if (row.estimator, row.density) == (estimator, density)]
            panel.scatter(*at(some), s=13, c=fill, edgecolors=colour, linewidths=0.9, zorder=2)
    panel.scatter(*at([row for row in rows if row.is_default]), s=140, marker="*", c="#ffd23f", edgecolors=INK, zorder=3)
    panel.set_xscale("log")
    ticks(panel, at(rows)[0])
    panel.set_title(title, loc="left", fontsize=9, fontweight="bold", color=INK)
    panel.set_xlabel("ms" if cost == "frame_s" else f"ms, {COSTS[cost]}", fontsize=8, color=SOFT)
    panel.set_ylabel("dB", fontsize=8, color=SOFT)
    panel.tick_params(length=0, labelsize=8, colors=SOFT)
    panel.grid(color=FAINT, linewidth=0.8)
    panel.set_axisbelow(True)
    panel.spines[:].set_visible(False)


def ticks(panel, times):
    """Times of one significant digit, few enough to be read."""
    low, high = np.log10(min(times)), np.log10(max(times))
    steps = (1, 2, 5) if high - low < 1.6 else (1, 3) if high - low < 2.6 else (1,)
    places = [step * 10.0**power for power in range(int(np.floor(low)), int(np.ceil(high)) + 1) for step in steps]
    panel.set_xticks(places, [f"{place:g}" for place in places])
    panel.minorticks_off()
    panel.set_xlim(10 ** (low - 0.1), 10 ** (high + 0.1))


def add_legend(figure, estimators):
    """What colours and marks mean, below."""
    from matplotlib.lines import Line2D

    def mark(label, **style):
        return Line2D([], [], linestyle="none", markersize=5, label=label, **style)

    handles = [mark(name.replace("_", " "), marker="o", color=COLOURS.get(name, OTHER)) for name in estimators]
    handles += [mark("sparse", marker="o", markerfacecolor="white", markeredgecolor=INK),
                Line2D([], [], marker="*", linestyle="none", markersize=10, color="#ffd23f", markeredgecolor=INK, label="default"),
                Line2D([], [], color=INK, linewidth=1, alpha=0.6, label="front")]
    figure.legend(handles=handles, loc="lower left", ncol=len(handles), fontsize=7.5, frameon=False, handletextpad=0.3,
                  columnspacing=1.1)
