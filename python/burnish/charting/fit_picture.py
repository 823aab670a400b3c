"""Data and fit side by side: slices, polar lobes, and balls with their difference."""

from __future__ import annotations

import pathlib

import numpy as np

from . import picture
from .picture import DPI, FAINT, INK, SOFT

CHANNELS = (("red", "#c0392b"), ("green", "#2e8b57"), ("blue", "#2c5fb8"))
SLICES = {"half": r"along itself ($\theta_d$ = 0)", "difference": r"mirror reflection ($\theta_h$ = 0)"}
ANGLE = {"half": r"$\theta_h$, degrees", "difference": r"$\theta_d$, degrees"}
DECADES = 6  # below a slice's peak
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
BALL_PX, AMPLIFIED = 320, 4


def figures(report):
    """Pairs of name and matplotlib Figure."""
    yield "slices", slices(report)
    yield "lobes", lobes(report)
    if pathlib.Path(report["table"]).exists():
        yield "balls", balls(report)


def save(name, figure, path):
    """Write a PNG; balls keep all their colours."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    if name == "balls":
        FigureCanvasAgg(figure).print_png(path)
    else:
        picture.save(figure, path)


def new_figure(columns, rows, title, polar=False):
    """A figure with panels, and what it shows above them."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.2 * columns, 4.4 * rows + 0.8), dpi=DPI, facecolor="white")
    panels = figure.subplots(rows, columns, squeeze=False, subplot_kw={"projection": "polar"} if polar else None)
    figure.suptitle(title, x=0.06, ha="left", fontsize=15, fontweight="bold", color=INK)
    return figure, panels


def title_of(report):
    """Which table, which model, how far off."""
    errors = report["errors"]
    lobes_text = f"{errors['lobes']} lobe" + ("s" if errors["lobes"] != 1 else "")
    norms = {"normalised L2": errors["normalised_l2"], "L1": errors["l1"]}
    told = [f"{name} {value:.2g}" for name, value in norms.items() if value is not None]
    return f"{pathlib.Path(report['table']).name}: {errors['model']}, {', '.join([lobes_text, *told])}"


def slices(report):
    """Both slices of a dense table, or the pairs of a sparse one by the light's angle; channel by channel."""
    curves = [curve for curve in report["curves"] if curve["kind"] in SLICES or curve["kind"] == "pairs"]
    figure, panels = new_figure(min(len(curves), 2), (len(curves) + 1) // 2, title_of(report))
    for panel, curve in zip(panels.flat, curves):
        draw_slice(panel, curve)
    for panel in panels.flat[len(curves):]:
        panel.axis("off")
    panels[0][0].legend(fontsize=8, frameon=False)
    figure.tight_layout(rect=(0, 0, 1, 0.94))
    return figure


def draw_slice(panel, curve):
    """Dots are data; lines the fit, crosses where it has values at the pairs only."""
    data, fit = np.array(curve["data"]), np.array(curve["fit"])
    is_slice = curve["kind"] in SLICES
    for channel, (name, colour) in enumerate(CHANNELS):
        panel.plot(curve["data_deg"], data[:, channel], ".", ms=3, color=colour, alpha=0.6, label=f"{name}, data")
        panel.plot(curve["fit_deg"], fit[:, channel], "-" if is_slice else "x", lw=1.2, ms=3, color=colour, label="fit")
    panel.set_title(SLICES.get(curve["kind"], f"light from {curve['theta_i_deg']:.0f} degrees"), loc="left", fontsize=12, color=INK)
    panel.set_xlabel(ANGLE["difference" if curve["kind"] == "difference" else "half"], color=SOFT)
    panel.set_ylabel("f, 1/sr", color=SOFT)
    panel.set_yscale("log")
    peak = max(data.max(), fit.max(), 1e-12)
    panel.set_ylim(max(peak * 10.0**-DECADES, positive_minimum(data, fit) / 2), peak * 2)
    if curve["kind"] != "difference":
        panel.set_xscale("symlog", linthresh=1)
        panel.set_xlim(0, 90)
    panel.grid(color=FAINT)


def positive_minimum(*arrays):
    """The least value above 0."""
    positive = np.concatenate([array[array > 0] for array in arrays])
    return positive.min() if positive.size else 1e-6


def lobes(report):
    """Polar lobes for a few incident angles: cube roots of f cos, as data dots and fit lines; what comes through points down."""
    curves = [curve for curve in report["curves"] if curve["kind"] in ("lobe", "through")]
    angles = sorted({curve["theta_i_deg"] for curve in curves})
    figure, panels = new_figure(len(angles), 1, title_of(report), polar=True)
    for panel, angle in zip(panels[0], angles):
        for curve in (curve for curve in curves if curve["theta_i_deg"] == angle):
            draw_lobe(panel, curve)
        panel.annotate("", xy=(0, 0), xytext=(np.radians(-angle), panel.get_rmax()),
                       arrowprops={"arrowstyle": "->", "color": SOFT})
        panel.set_theta_zero_location("N")
        panel.set_theta_direction(-1)
        through = any(curve["kind"] == "through" for curve in curves)
        panel.set_thetalim(-np.pi if through else -np.pi / 2, np.pi if through else np.pi / 2)
        panel.set_yticklabels([])
        panel.set_title(f"light from {angle:.0f} degrees", fontsize=12, color=INK)
    figure.tight_layout(rect=(0, 0, 1, 0.92))
    return figure


def draw_lobe(panel, curve):
    """One lobe: cube root of the luminance of f cos theta_o."""
    for key, style in (("data", {"ls": "", "marker": ".", "ms": 3, "color": "#2e8b57"}), ("fit", {"lw": 1.2, "color": "#c0392b"})):
        theta = np.radians(curve[f"{key}_deg"])
        values = np.cbrt(np.reshape(curve[key], (-1, 3)) @ LUMINANCE * np.cos(theta))
        panel.plot(theta if curve["kind"] == "lobe" else np.pi - theta, values, **style)


def balls(report):
    """A ball of the data, one of the fit, and their difference, amplified."""
    from .. import preview

    data, fit = preview(report["table"], size=BALL_PX), preview(report["material"], size=BALL_PX)
    scale = 0.18 / max(data[..., :3].mean(), 1e-9)
    pictures = (("the table", data, scale), ("the fit", fit, scale),
                (f"difference, {AMPLIFIED} times", np.abs(data - fit), AMPLIFIED * scale))
    figure, panels = new_figure(3, 1, title_of(report))
    for panel, (name, ball, gain) in zip(panels[0], pictures):
        panel.imshow(display(ball[..., :3] * gain))
        panel.set_title(name, fontsize=12, color=INK)
        panel.axis("off")
    figure.tight_layout(rect=(0, 0, 1, 0.94))
    return figure


def display(linear):
    """sRGB's curve."""
    clipped = np.clip(linear, 0, 1)
    return np.where(clipped <= 0.0031308, 12.92 * clipped, 1.055 * clipped ** (1 / 2.4) - 0.055)
