"""Error and cost of one estimator setting on one material under one light.

The reference is itself an estimate: its standard error, which it measures at every pixel, is squared and taken out of
the mean squares below, so that a figure is the estimator's own error. A figure of 0 lies below the reference's noise.
"""

from __future__ import annotations

import dataclasses
import time

import numpy as np

from .. import composite
from . import benchmark

MIDDLE_GREY = 0.18
GRAZING = np.cos(np.radians(75))
MOST_LOOKUPS = 32768  # of the reference, per pixel


@dataclasses.dataclass(frozen=True)
class Effort:
    """How carefully to measure."""

    size: int = 64  # pixels along the sphere's diameter that have a reference
    step: int = 4  # the estimators shade, and are timed on, so many times as many along each edge
    tolerance: float = 0.01  # of the reference: standard error at each pixel, relative to its value
    seconds: float = 0.15  # runs of each setting are repeated for so long; the fastest counts
    threads: int = 0  # of the reference, 0: all cores; estimators run on one thread


@dataclasses.dataclass(frozen=True)
class Row:
    """One line of the CSV; the fields are its columns."""

    light: str
    material: str
    kind: str
    estimator: str
    samples: int  # lookups asked for
    lookups: float  # lookups made, per pixel
    relative_rms: float
    relative_rms_beyond_75_deg: float
    psnr_db: float  # both pictures scaled to a mean of 0.18, clamped, sRGB-encoded
    reference_relative_rms: float  # the reference's standard error, already taken out of the figures
    reference_lookups: float  # per pixel
    shading_ns_per_pixel: float  # of one thread
    tables_s: float  # once for each light and material, one thread


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

    def psnr_db(self, overlay):
        """Display PSNR in dB; infinite below the reference's noise."""
        exposure = MIDDLE_GREY / self.radiance.mean()
        shown = self.radiance * exposure
        noise = self.noise * exposure * encoding_slope(shown)
        error = mean_square(encode(overlay * exposure) - encode(shown)) - mean_square(noise)
        return -10 * np.log10(error) if error > 0 else np.inf

    def noise_rms(self):
        """The reference's standard error, as `relative_rms`."""
        return np.sqrt(mean_square(self.noise) / mean_square(self.radiance))


def mean_square(values):
    """Mean of the squares."""
    return np.mean(np.square(values))


def shade(frame, light, material, threads, **settings):
    """The layers of one estimate."""
    return composite(frame, light, material.lobe(), camera=benchmark.CAMERA, threads=threads, density="dense", **settings)


def truth_of(layers, covered):
    """The Truth that the layers of the estimator `reference` hold where `covered`."""
    radiance = layers["overlay"][covered].astype(np.float64)
    luminance = np.maximum(radiance @ (0.2126, 0.7152, 0.0722), 1e-30)
    relative = layers["error"][covered] / luminance  # a pixel's noise has the pixel's hue
    return Truth(radiance, radiance * relative[:, None])


class Bench:
    """Measures materials under lights on one sphere; the reference sees every few pixels of it."""

    def __init__(self, effort):
        self.effort = effort
        self.sphere = benchmark.sphere(effort.size * effort.step)
        self.every = (slice(effort.step // 2, None, effort.step),) * 2
        self.sparse_sphere = {role: array[self.every] for role, array in self.sphere.items()}
        cosines = benchmark.view_cosines(self.sparse_sphere)
        self.covered = cosines > 0
        self.grazing = cosines[self.covered] < GRAZING

    def rows(self, light_name, light, material):
        """The rows of all estimators, one after the other."""
        reference = shade(self.sparse_sphere, light, material, self.effort.threads, estimator="reference",
                          tolerance=self.effort.tolerance, max_samples=MOST_LOOKUPS)
        truth, spent = truth_of(reference, self.covered), float(reference["samples"][self.covered].mean())
        for estimator in benchmark.LOOKUPS:  # makes the light's filtered levels, which are no lobe's tables
            shade(self.sparse_sphere, light, material, self.effort.threads, estimator=estimator, samples=1)
        for estimator, counts in benchmark.LOOKUPS.items():
            for samples in counts:
                overlay, lookups, shading, tables = self.run(light, material, estimator, samples)
                overlay = overlay[self.every][self.covered]
                errors = truth.relative_rms(overlay), truth.relative_rms(overlay, self.grazing), truth.psnr_db(overlay)
                yield Row(light_name, material.name, material.kind, estimator, samples, lookups, *errors,
                          truth.noise_rms(), spent, 1e9 * shading, tables)

    def run(self, light, material, estimator, samples):
        """Overlay, lookups per pixel, seconds of shading per covered pixel and of tables, each of the fastest run."""
        shading, tables, end = [], [], time.perf_counter() + self.effort.seconds
        while not shading or time.perf_counter() < end:
            layers = shade(self.sphere, light, material, 1, estimator=estimator, samples=samples)
            seconds, pixels = layers["report"]["seconds"], layers["report"]["pixels"]["valid"]
            shading.append(seconds["shading"] / pixels)
            tables.append(seconds["tables"])
        return layers["overlay"], float(layers["samples"].max()), min(shading), min(tables)
