"""The measured rows as a picture: a row of panels for each class of material, error against lookups and against time.

A line joins the medians over materials and lights, its band holds the middle half of them. Lines carry their names.
"""

from __future__ import annotations

import numpy as np

from .table import by_estimator

WIDTH_PX, ROW_PX, HEAD_PX, FOOT_PX, DPI = 1600, 430, 130, 75, 100
INK, FAINT = "#222222", "#e4e4e4"
COLOURS = {"fitted": "#0b62a4", "regular": "#d1495b", "filtered_importance": "#2e8b57", "split_sum": "#7b5ea7"}
LABEL_GAP = 0.055  # of a panel's height: names do not come closer
AXES = {"lookups": "lookups per pixel", "shading_ns_per_pixel": "shading time per pixel, nanoseconds of one thread"}
X_TICKS = {"lookups": (1, 2, 4, 8, 16, 32, 64), "shading_ns_per_pixel": (50, 100, 200, 500, 1000, 2000, 5000)}
Y_TICKS = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1)


def draw(rows):
    """The picture as a matplotlib Figure, WIDTH_PX wide."""
    from matplotlib.figure import Figure

    kinds = list(dict.fromkeys(row.kind for row in rows))
    height = HEAD_PX + ROW_PX * len(kinds) + FOOT_PX
    figure = Figure(figsize=(WIDTH_PX / DPI, height / DPI), dpi=DPI, facecolor="white")
    panels = figure.subplots(len(kinds), len(AXES), sharex="col", sharey=True, squeeze=False)
    figure.subplots_adjust(left=0.065, right=0.985, top=1 - HEAD_PX / height, bottom=FOOT_PX / height, wspace=0.04, hspace=0.17)
    for line, kind in zip(panels, kinds):
        of_kind = [row for row in rows if row.kind == kind]
        line[0].set_title(heading(kind, of_kind), loc="left", fontsize=14, fontweight="bold", color=INK)
        for panel, quantity in zip(line, AXES):
            draw_panel(panel, of_kind, quantity)
    for panel, quantity in zip(panels[-1], AXES):
        panel.set_xlabel(AXES[quantity], fontsize=13, color=INK, labelpad=8)
    figure.text(0.065, 1 - 38 / height, "Error of the estimators against what they cost", fontsize=20, fontweight="bold", color=INK)
    figure.text(0.065, 1 - 70 / height, subtitle(rows), fontsize=13, color="#555555")
    for panel in panels.flat:  # where the names end up depends on all panels, for they share their axes
        add_names(panel)
    return figure


def heading(kind, rows):
    """ "Beckmann isotropic: 0.02, 0.05" """
    names = ", ".join(dict.fromkeys(row.material.split("-", 1)[1].replace("x", " × ") for row in rows))
    return f"{kind.replace('ggx', 'GGX').replace('beckmann', 'Beckmann')}, slopes {names}"


def subtitle(rows):
    """What the figures are of."""
    lights = list(dict.fromkeys(row.light for row in rows))
    return f"RMS error over RMS of the reference on a sphere; median and middle half over materials and {len(lights)} " \
           f"light{'s' * (len(lights) > 1)}: {', '.join(lights)}"


def quartiles(rows, name):
    """Lower quartile, median and upper quartile for each count of lookups asked for, shape (3, counts)."""
    counts = sorted({row.samples for row in rows})
    return np.transpose([np.quantile([getattr(row, name) for row in rows if row.samples == n], (0.25, 0.5, 0.75)) for n in counts])


def draw_panel(panel, rows, quantity):
    """Lines and bands of all estimators."""
    panel.set(xscale="log", yscale="log")
    for estimator, group in by_estimator(rows).items():
        x = quartiles(group, quantity)[1]
        low, middle, high = quartiles(group, "relative_rms")
        colour = COLOURS[estimator]
        panel.fill_between(x, low, high, color=colour, alpha=0.11, linewidth=0)
        panel.plot(x, middle, "-o", color=colour, linewidth=2.4, markersize=6, markeredgecolor="white", label=estimator)
    panel.set_xticks(X_TICKS[quantity], map(str, X_TICKS[quantity]))
    panel.set_yticks(Y_TICKS, [f"{100 * tick:g} %" for tick in Y_TICKS])
    panel.minorticks_off()
    panel.tick_params(length=0, labelsize=12, colors="#555555", labelbottom=True)
    panel.grid(color=FAINT, linewidth=1)
    panel.set_axisbelow(True)
    panel.spines[:].set_visible(False)
    panel.margins(x=0.09, y=0.06)


def add_names(panel):
    """Each line's name at its end, moved up or down where two would touch."""
    from matplotlib.patheffects import withStroke

    to_panel = panel.transScale + panel.transLimits  # data to [0, 1]
    ends = [(to_panel.transform((line.get_xdata()[-1], line.get_ydata()[-1])), line) for line in panel.get_lines()]
    height = -np.inf
    for (x, y), line in sorted(ends, key=lambda end: end[0][1]):
        height = max(y, height + LABEL_GAP)
        panel.annotate(line.get_label().replace("_", " "), (x, height), (9, 0), xycoords="axes fraction", textcoords="offset points",
                       va="center", fontsize=13, fontweight="bold", color=line.get_color(),
                       path_effects=[withStroke(linewidth=4, foreground="white")])
