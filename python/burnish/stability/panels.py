"""Pictures for people: panels side by side, encoded for a display, small pixels enlarged."""

from __future__ import annotations

import numpy as np

from ..charting.measure import MIDDLE_GREY, encode

GAP = 4
"""White pixels between panels."""


def exposure_of(linear):
    """What brings the mean of a picture to middle grey."""
    mean = float(np.mean(linear))
    return MIDDLE_GREY / mean if mean > 0 else 1.0


def enlarged(picture, times):
    """Every pixel as a square; `times` may be a pair for rows and columns."""
    down, across = times if isinstance(times, tuple) else (times, times)
    return np.repeat(np.repeat(picture, down, 0), across, 1)


def beside(*pictures):
    """Panels of shape (height, width, 3), left to right, white between and under them."""
    height = max(picture.shape[0] for picture in pictures)
    parts = []
    for picture in pictures:
        under = np.ones((height - picture.shape[0], picture.shape[1], 3))
        parts += [np.concatenate([picture, under]), np.ones((height, GAP, 3))]
    return np.clip(np.concatenate(parts[:-1], 1), 0, 1)


def compared(result, reference, amplified=8, times=1):
    """Result, reference, and their difference after encoding, `amplified`, about middle grey: linear (height, width, 3) in."""
    exposure = exposure_of(reference)
    shown, truth = encode(exposure * result), encode(exposure * reference)
    difference = 0.5 + amplified * (shown - truth)
    return beside(*(enlarged(panel, times) for panel in (shown, truth, difference)))


def curves(lines, low, high, height=160, width=220):
    """One-dimensional arrays as lines in the colours black, red and blue over `low` to `high`."""
    picture = np.ones((height, width, 3))
    for values, colour in zip(lines, ((0, 0, 0), (0.8, 0.1, 0.1), (0.1, 0.2, 0.8))):
        places = np.linspace(0, len(values) - 1, 4 * width)
        y = np.interp(places, np.arange(len(values)), values)
        rows = np.round((high - np.clip(y, low, high)) / (high - low) * (height - 1)).astype(int)
        picture[rows, (np.arange(4 * width) // 4)] = colour
    return picture
