"""The scenes that Cycles rendered, as jobs of burnish, and measures over their objects."""

import numpy as np
from burnish.charting.cycles import spheres


def job_of(folder, name):
    """Arguments of burnish.composite for the frame `name` of a scene's folder."""
    settings = spheres(folder, name)
    return {**settings, "light": settings.pop("env")}


def interior(index, value, margin=2):
    """Pixels whose whole (2 margin + 1)^2 neighbourhood wears the material."""
    inside = np.pad(index == value, margin)
    windows = np.lib.stride_tricks.sliding_window_view(inside, (2 * margin + 1, 2 * margin + 1))
    return windows.all((2, 3))


def displayed(image, scale):
    """Clamped and sRGB-encoded."""
    x = np.clip(np.asarray(image, np.float64) * scale, 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)
