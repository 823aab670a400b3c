"""A reference and its own standard error, and how far an estimate is from it.

The reference is itself an estimate: its standard error, which it measures at every pixel, is squared and taken out of
the mean squares below, so that a figure is the estimator's own error. A figure of 0 lies below the reference's noise.
"""

from __future__ import annotations

import dataclasses

import numpy as np

MIDDLE_GREY = 0.18
LUMINANCE = (0.2126, 0.7152, 0.0722)


def encode(linear):
    """sRGB-encode, clamped to [0, 1]."""
    x = np.clip(linear, 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 0.0031308) ** (1 / 2.4) - 0.055)


def encoding_slope(linear):
    """Derivative of `encode`."""
    inside = (linear > 0) & (linear < 1)
    return inside * np.where(linear <= 0.0031308, 12.92, 1.055 / 2.4 * np.maximum(linear, 0.0031308) ** (1 / 2.4 - 1))


@dataclasses.dataclass(frozen=True)
class Truth:
    """A reference: linear radiance of n pixels and its standard error."""

    radiance: np.ndarray  # shape (n, 3)
    noise: np.ndarray  # shape (n, 3)

    def relative_rms(self, overlay, where=slice(None)):
        """RMS error over RMS of the reference, over the pixels of `where`."""
        error = mean_square((overlay - self.radiance)[where]) - mean_square(self.noise[where])
        return np.sqrt(max(error, 0) / mean_square(self.radiance[where]))

    def exposure(self):
        """What brings the reference's mean to middle grey."""
        return MIDDLE_GREY / self.radiance.mean()

    def psnr_db(self, overlay):
        """Display PSNR in dB; infinite below the reference's noise."""
        exposure = self.exposure()
        error = mean_square(encode(overlay * exposure) - encode(self.radiance * exposure)) - self.noise_on_display()
        return -10 * np.log10(error) if error > 0 else np.inf

    def noise_on_display(self):
        """Mean square of the reference's standard error, display-encoded."""
        exposure = self.exposure()
        return mean_square(self.noise * exposure * encoding_slope(self.radiance * exposure))

    def ceiling_db(self):
        """The display PSNR from which on an error is lost in what is not known of the noise: three deviations of its mean square."""
        lost = self.noise_on_display() * 3 * np.sqrt(2 / len(self.radiance))
        return -10 * np.log10(lost) if lost > 0 else np.inf

    def noise_rms(self):
        """The reference's standard error, as `relative_rms`."""
        return np.sqrt(mean_square(self.noise) / mean_square(self.radiance))


def mean_square(values):
    """Mean of the squares."""
    return np.mean(np.square(values))


def truth_of(layers, where):
    """The Truth that the layers of the estimator `reference` hold at the pixels of `where`, a mask or flat indices."""
    pixels = np.flatnonzero(where) if where.dtype == bool else where
    radiance = layers["overlay"].reshape(-1, 3)[pixels].astype(np.float64)
    luminance = np.maximum(radiance @ LUMINANCE, 1e-30)
    relative = layers["error"].ravel()[pixels] / luminance  # a pixel's noise has the pixel's hue
    return Truth(radiance, radiance * relative[:, None])


def jittered(mask, count, seed=1):
    """Flat indices of about `count` pixels of a mask: one drawn in each of equal blocks of the frame, so that no raster is favoured.

    Returns also the blocks' edge in pixels; a small mask gives all of its pixels, with blocks of 1.
    """
    edge = max(1, int(np.sqrt(mask.sum() / count)))
    height, width = mask.shape
    rows, columns = -(-height // edge), -(-width // edge)
    offset = np.random.default_rng(seed).integers(0, edge, (2, rows, columns))
    y = np.arange(rows)[:, None] * edge + offset[0]
    x = np.arange(columns)[None] * edge + offset[1]
    inside = (y < height) & (x < width)
    pixels = (y * width + x)[inside]
    return pixels[mask.ravel()[pixels]], edge
