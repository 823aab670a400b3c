"""Error images of a finished scene at equal time and at equal error, at the pixels that the reference has seen."""

from __future__ import annotations

import json

import numpy as np

from .bench import together
from .front import best_within, cheapest
from .measure import encode
from .scene import WHOLE

SHOWN_ERROR = 0.1  # of white, display-encoded: the brightest colour
EQUAL_TIME = 1.1  # times the default's time count as equal
EQUAL_DB = 40
SMALLEST_EDGE = 160  # of a picture, pixels


def images_of(bench, parts, rows, seen):
    """Of the whole frame if it is among the parts, else of each. Arrays to keep: "pictures", JSON of what each shows,
    and "picture_0" and so on."""
    pictures, arrays = [], {}
    for part in [part for part in parts if part.name == WHOLE] or parts:
        of_part = [row for row in rows if row.material == part.name]
        known = together(list(seen.values())) if part.name == WHOLE else seen[part.name]
        for about, picture in pictures_of(bench, part, of_part, known) if of_part else ():
            arrays[f"picture_{len(pictures)}"] = picture
            pictures.append({"part": part.name, **about})
    return {"pictures": np.array(json.dumps(pictures)), **arrays}


def pictures_of(bench, part, rows, known):
    """Pairs of what a picture shows and the picture: the reference, then errors."""
    exact, painter = known.truth.radiance, Painter(bench, known, part.coverage.shape)
    yield dict(group="reference", text=f"reference, {known.lookups:.0f} lookups a pixel"), painter.shown(exact)
    for about, row in chosen(rows):
        overlay = bench.scene.shade(part, row.setting, bench.effort.threads)["overlay"].reshape(-1, 3)[known.pixels]
        yield about, painter.error(overlay, exact)


def chosen(rows):
    """Pairs of what a picture is of and its row: the default, rivals in its time, the cheapest of each at EQUAL_DB."""
    default = next((row for row in rows if row.is_default), rows[0])
    yield told("default", "the default", default), default
    estimators = dict.fromkeys(row.estimator for row in rows)
    for estimator in estimators:
        row = best_within([row for row in rows if row.estimator == estimator], EQUAL_TIME * default.frame_s)
        if row and row != default:
            yield told("equal time", "", row), row
    for estimator in estimators:
        of_estimator = [row for row in rows if row.estimator == estimator]
        row = cheapest(of_estimator, EQUAL_DB)
        if row:
            yield told("equal error", "", row), row


def told(group, text, row):
    """What a picture shows."""
    words = ": ".join(filter(None, (text, row.setting.label)))
    return {"group": group, "text": f"{words}; {row.psnr_db:.1f} dB, {1e3 * row.frame_s:.2f} ms"}


class Painter:
    """Pixels of the raster as small pictures, a block of the frame to a pixel."""

    def __init__(self, bench, known, shape):
        self.exposure = known.truth.exposure()
        y, x = np.divmod(known.pixels, shape[1])
        self.y, self.x = y // bench.edge, x // bench.edge
        self.y, self.x = self.y - self.y.min(), self.x - self.x.min()
        self.scale = max(1, -(-SMALLEST_EDGE // (self.x.max() + 1)))

    def paint(self, colours):
        """uint8 (height, width, 3), white where there is nothing."""
        picture = np.full((self.y.max() + 1, self.x.max() + 1, 3), 255, np.uint8)
        picture[self.y, self.x] = np.round(255 * colours)
        return picture.repeat(self.scale, 0).repeat(self.scale, 1)

    def shown(self, overlay):
        """As a display shows it."""
        return self.paint(encode(overlay * self.exposure))

    def error(self, overlay, exact):
        """Its largest channel's error on a display, in colours from black to pale yellow."""
        import matplotlib

        error = np.abs(encode(overlay * self.exposure) - encode(exact * self.exposure)).max(-1)
        return self.paint(matplotlib.colormaps["inferno"](np.clip(error / SHOWN_ERROR, 0, 1))[:, :3])
