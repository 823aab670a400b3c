"""The measured rows as a picture: a row of panels for each class of material, error against lookups and against time.

A line joins the medians over materials and lights, its band holds the middle half of them. Lines carry their names.
"""

from __future__ import annotations

import textwrap

import numpy as np

from .table import by_estimator

WIDTH_PX, ROW_PX, HEAD_PX, FOOT_PX, DPI = 1600, 420, 160, 75, 100
LEFT = 0.065  # of the width: the margin
INK, SOFT, FAINT = "#222222", "#555555", "#e4e4e4"
COLOURS = {
    "fitted": "#0b62a4", "regular": "#d1495b", "filtered_importance": "#2e8b57", "preconvolved": "#c77d0a", "split_sum": "#7b5ea7",
    "factored": "#13a3a5",
}
NAME_HEIGHT, LETTER_WIDTH = 0.06, 0.0145  # of a panel
NAME_SHARE = 0.36  # of a panel's width, added on the right for names
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
    figure.subplots_adjust(left=LEFT, right=0.985, top=1 - HEAD_PX / height, bottom=FOOT_PX / height, wspace=0.04,
                           hspace=0.17)
    for line, kind in zip(panels, kinds):
        of_kind = [row for row in rows if row.kind == kind]
        line[0].set_title(heading(kind, of_kind), loc="left", fontsize=14, fontweight="bold", color=INK)
        for panel, quantity in zip(line, AXES):
            draw_panel(panel, of_kind, quantity)
    for panel, quantity in zip(panels[-1], AXES):
        panel.set_xlabel(AXES[quantity], fontsize=13, color=INK, labelpad=8)
    figure.text(LEFT, 1 - 38 / height, "Error of the estimators against what they cost", fontsize=20, fontweight="bold",
                color=INK)
    figure.text(LEFT, 1 - 62 / height, subtitle(rows), fontsize=13, color=SOFT, va="top", linespacing=1.5)
    for panel in panels[0]:
        begin, end = panel.get_xlim()
        panel.set_xlim(begin, end * (end / begin) ** NAME_SHARE)
    for panel in panels.flat:  # last, when all panels, which share their axes, hold their lines
        add_names(panel)
    return figure


def save(figure, path, dithered=False):
    """Write a PNG of 256 colours, a third of the size of one with all of them; `dithered` where shades are smooth."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    picture = Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB")
    dither = Image.Dither.FLOYDSTEINBERG if dithered else Image.Dither.NONE
    picture.quantize(256, dither=dither).save(path, format="PNG", optimize=True)


def heading(kind, rows):
    """Title of a row: the class of materials and their widths."""
    names = ", ".join(dict.fromkeys(row.material.split("-", 1)[1].replace("x", " × ") for row in rows))
    return f"{kind.replace('ggx', 'GGX').replace('beckmann', 'Beckmann')}, m = {names}"


def subtitle(rows):
    """What the figures are of."""
    lights = list(dict.fromkeys(row.light for row in rows))
    names = textwrap.shorten(f"Lights: {', '.join(lights)}", 150, placeholder=" ...")
    return ("RMS error over RMS of the reference on a sphere: medians over materials and lights, with their middle half. "
            f"Times are of the fastest light.\n{names}")


def quartiles(rows, name):
    """Lower quartile, median and upper quartile for each count of lookups asked for, shape (3, counts)."""
    counts = sorted({row.samples for row in rows})
    values = [[getattr(row, name) for row in rows if row.samples == n] for n in counts]
    return np.transpose([np.quantile(of_count, (0.25, 0.5, 0.75)) for of_count in values])


def fastest(rows):
    """Of each material and count of lookups the row of the fastest light: others have suns, or met busy cores."""
    best = {}
    for row in rows:
        key = (row.material, row.samples)
        best[key] = min(row, best.get(key, row), key=lambda row: row.shading_ns_per_pixel)
    return list(best.values())


def draw_panel(panel, rows, quantity):
    """Lines and bands of all estimators."""
    panel.set(xscale="log", yscale="log")
    for estimator, group in by_estimator(rows).items():
        x = quartiles(fastest(group), quantity)[1]
        low, middle, high = quartiles(group, "relative_rms")
        colour = COLOURS[estimator]
        panel.fill_between(x, low, high, color=colour, alpha=0.1, linewidth=0)
        panel.plot(x, middle, "-o", color=colour, linewidth=2.4, markersize=6, markeredgecolor="white", label=estimator)
    panel.set_xticks(X_TICKS[quantity], map(str, X_TICKS[quantity]))
    panel.set_yticks(Y_TICKS, [f"{100 * tick:g} %" for tick in Y_TICKS])
    panel.minorticks_off()
    panel.tick_params(length=0, labelsize=12, colors=SOFT, labelbottom=True)
    panel.grid(color=FAINT, linewidth=1)
    panel.set_axisbelow(True)
    panel.spines[:].set_visible(False)
    panel.margins(x=0.05, y=0.06)


def add_names(panel):
    """Each line's name at its end: where it covers the least of lines and of other names."""
    from matplotlib.patheffects import withStroke

    panel.autoscale_view()
    to_panel = panel.transScale + panel.transLimits  # data to [0, 1]
    paths = {line: to_panel.transform(line.get_xydata()) for line in panel.get_lines()}
    taken = np.concatenate([along(path) for path in paths.values()])
    for line, path in paths.items():
        name = line.get_label().replace("_", " ")
        half = np.array((LETTER_WIDTH * len(name), NAME_HEIGHT)) / 2
        places = path[-1] + [(half[0] + 0.02, 0), (0, -0.06), (0, 0.06), (half[0], -0.06), (half[0], 0.06), (0, -0.1)]
        place = min(np.clip(places, half, 1 - half), key=lambda centre: np.sum((abs(taken - centre) < half).all(-1)))
        diagonals = [along(place + half * [(-1, -1), (1, 1)]), along(place + half * [(-1, 1), (1, -1)])]
        taken = np.concatenate([taken, *diagonals])
        panel.annotate(name, place, xycoords="axes fraction", ha="center", va="center", fontsize=13, fontweight="bold",
                       color=line.get_color(), path_effects=[withStroke(linewidth=4, foreground="white")])


def along(path):
    """Many points along a path of few."""
    steps = np.linspace(0, len(path) - 1, 60 * len(path))
    return np.transpose([np.interp(steps, np.arange(len(path)), coordinate) for coordinate in np.transpose(path)])
