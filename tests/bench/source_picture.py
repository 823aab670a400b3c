"""The sources' figures drawn again: error against lookups, and balls with their errors, as Regular 8 to 10 and Walkthrough 4.39."""

import numpy as np
from burnish.charting.measure import MIDDLE_GREY, encode
from burnish.charting.picture import COLOURS, FAINT, INK, SOFT, save as save_picture

from source_balls import circles, look_errors
from source_setups import CURVE, LOOKS, MICROFACETS

FITTED = (1, 2, 3, 4, 6, 8, 12)
LABELS = {"importance": "importance sampling, filtered", "published": "regular, as published", "regular": "regular, burnish's",
          "fitted": "fitted"}
LINES = {"importance": COLOURS["filtered_importance"], "published": "#e08e9b", "regular": COLOURS["regular"], "fitted": COLOURS["fitted"]}
GAIN = 15  # of Walkthrough's difference images
DIFFERENCE = "the difference x 15"


def curves(ball, light, truth, material):
    """Method -> relative RMS at each count."""
    return {
        "importance": [ball.best(light, material, truth, estimator="filtered_importance", samples=n).relative_rms for n in CURVE],
        "published": [ball.best(light, material, truth, **circles(n)).relative_rms for n in CURVE],
        "regular": [ball.plain(light, material, truth, estimator="regular", samples=n, density="dense").relative_rms for n in CURVE],
        "fitted": [ball.plain(light, material, truth, samples=n, density="dense").relative_rms for n in FITTED],
    }


def draw_curves(panel, found, title):
    """One panel: error against lookups."""
    for method, errors in found.items():
        counts = FITTED if method == "fitted" else CURVE
        panel.loglog(counts, errors, "-o", color=LINES[method], markersize=5, markeredgecolor="white", linewidth=2, label=LABELS[method])
    panel.set_xticks((1, 3, 7, 14, 30, 61, 127, 270), ("1", "3", "7", "14", "30", "61", "127", "270"))
    panel.set_yticks((0.01, 0.02, 0.05, 0.1, 0.2, 0.5), ("1 %", "2 %", "5 %", "10 %", "20 %", "50 %"))
    panel.minorticks_off()
    panel.grid(color=FAINT)
    panel.tick_params(length=0, labelsize=11, colors=SOFT)
    panel.spines[:].set_visible(False)
    panel.set_title(title, loc="left", fontsize=13, fontweight="bold", color=INK)


def lit(picture, truth):
    """As a display shows it: the reference's mean at middle grey."""
    return encode(picture * MIDDLE_GREY / truth.radiance.mean())


def reference_picture(ball, truth):
    """The reference as a picture."""
    return ball.shown(truth.radiance, truth).picture


def false_colours(ball, truth, shown):
    """How far luminance is off, over the reference's mean: black none, white as much as the mean."""
    from matplotlib import colormaps

    off = abs(shown.picture - reference_picture(ball, truth)).mean(-1) / truth.radiance.mean()
    return colormaps["inferno"](np.clip(off, 0, 1))[..., :3] * ball.covered[..., None]


def impressions(ball, light, truths):
    """Rows of (picture, caption) as figures 8 and 10: few lookups by each method, and the reference."""
    for lobe in (MICROFACETS[0], MICROFACETS[2]):
        truth, material = truths[lobe], lobe.material()
        for samples in (lobe.samples[0], lobe.samples[-1]):
            by = {"regular": ball.best(light, material, truth, **circles(samples)),
                  "importance": ball.best(light, material, truth, estimator="filtered_importance", samples=samples)}
            for name, shown in by.items():
                yield lit(shown.picture, truth), f"{lobe.name}, {name} {samples}\n{shown.psnr_db:.1f} dB"
        default = ball.plain(light, material, truth)
        yield lit(default.picture, truth), f"{lobe.name}, default (6)\n{default.psnr_db:.1f} dB"
        yield lit(reference_picture(ball, truth), truth), f"{lobe.name}\nreference"


def error_images(ball, light, truth):
    """As figure 9: errors in false colours at 14, 30 and 270 lookups."""
    lobe = MICROFACETS[1]
    for name, settings in (("regular", circles), ("importance", lambda n: dict(estimator="filtered_importance", samples=n))):
        for samples in lobe.samples:
            shown = ball.best(light, lobe.material(), truth, **settings(samples))
            yield false_colours(ball, truth, shown), f"{lobe.name}, {name} {samples}\nerror, RMS {100 * shown.relative_rms:.1f} %"


def thesis_row(ball, light, whole_light):
    """As figure 4.39: scattergloss at 7 and 15 samples beside burnish's default, each with its difference."""
    look = LOOKS[0]
    found, truth = look_errors(ball, light, whole_light, look)
    few, many = look.samples
    exact = lit(reference_picture(ball, truth), truth)
    for shown, name in ((found[few]["published"], f"n={few}"), (found[many]["published"], f"n={many}"), (found[few]["default"], "default")):
        image = lit(shown.picture, truth)
        yield image, f"scattergloss, {name}\n{shown.psnr_db:.1f} dB"
        yield np.clip(GAIN * abs(image - exact), 0, 1), DIFFERENCE


def draw(ball, stress, hall, whole_hall):
    """The whole picture as a matplotlib Figure."""
    from matplotlib.figure import Figure

    truths = {lobe: ball.truth(stress, lobe.material()) for lobe in MICROFACETS}
    balls = [*impressions(ball, stress, truths), *error_images(ball, stress, truths[MICROFACETS[1]]),
             *thesis_row(ball, hall, whole_hall)]
    rows = len(balls) // 6
    figure = Figure(figsize=(15, 4.6 + 2.75 * rows), dpi=80, facecolor="white", layout="constrained")
    top, below = figure.subfigures(2, 1, height_ratios=(4.6, 2.75 * rows))
    panels = top.subplots(1, 3, sharey=True)
    for panel, lobe in zip(panels, MICROFACETS):
        draw_curves(panel, curves(ball, stress, truths[lobe], lobe.material()), f"RMS error against lookups, {lobe.name}")
    panels[0].legend(frameon=False, fontsize=11)
    for panel, (image, caption) in zip(below.subplots(rows, 6).flat, balls):
        panel.imshow(np.clip(image, 0, 1))
        panel.axis("off")
        panel.set_title(caption, fontsize=11, color=INK)
    return figure


def save(figure, path):
    """Write the PNG; balls are smooth."""
    save_picture(figure, path, dithered=True)
