"""Error and cost of one setting on one part of a scene: the one way in which every chart measures.

Time is the median of several runs, stage by stage; error is taken at pixels that the reference has seen (measure.py).
"""

from __future__ import annotations

import dataclasses
import os
import statistics
import time

import numpy as np

from . import measure
from .scene import WHOLE
from .setting import Setting, setting_of

STAGES = ("light", "tables", "surface", "shading", "composite")


@dataclasses.dataclass(frozen=True)
class Effort:
    """How carefully to measure."""

    tolerance: float = 0.02  # of the reference: standard error at each pixel, relative to its value
    most_lookups: int = 8192  # of the reference, per pixel
    pixels: int = 1000  # of each part that the reference sees, about; of a frame at most 6 times as many
    runs: int = 3  # of each setting at the most, as long as they take less than
    seconds: float = 0.3
    threads: int = 0  # that are timed, 0: all cores
    workers: int = 0  # threads of the reference, 0: all cores

    @property
    def cores(self):
        """Threads that the figures are of."""
        return self.threads or os.cpu_count()


@dataclasses.dataclass(frozen=True)
class Row:
    """One line of the CSV; the fields are its columns."""

    scene: str
    light: str
    material: str
    parameters: str  # of the material
    estimator: str
    samples: int  # lookups asked for, 0: as the estimator needs
    lookups: float  # made, per shaded pixel
    density: str
    safety: float  # 0 where dense
    suns: str
    face: str
    face_size: int  # texels, 0 without an environment
    is_default: bool  # the setting of the shot, or of burnish where it has none
    psnr_db: float  # both pictures scaled to a mean of 0.18, clamped, sRGB-encoded; at most the reference's ceiling
    relative_rms: float
    relative_rms_beyond_75_deg: float | None  # where the angle of view is known
    largest_error: float  # linear, of a channel
    largest_x: int
    largest_y: int
    light_s: float  # reading and filtering the light
    light_tables_s: float  # its Gaussian stack, where that is needed
    tables_s: float  # once for each material and light
    surface_s: float
    shading_s: float
    composite_s: float
    frame_s: float  # each further frame: surface, shading, composite
    alone_s: float  # a frame alone: all stages
    runs: int
    threads: int
    width: int
    height: int
    pixels: int  # of the part
    shaded: int  # of these, with lookups of their own
    reference_pixels: int
    reference_lookups: float
    reference_relative_rms: float  # its standard error, which is taken out of the figures
    reference_ceiling_db: float  # figures beyond cannot be told from its noise

    @property
    def setting(self):
        """The Setting it is of."""
        return setting_of(self)


@dataclasses.dataclass(frozen=True)
class Seen:
    """What the reference saw of a part."""

    pixels: np.ndarray  # flat indices
    truth: measure.Truth
    lookups: float  # per pixel


class Bench:
    """Measures the parts of one scene."""

    def __init__(self, scene, effort):
        self.scene, self.effort = scene, effort
        masks = [part.coverage > 0 for part in scene.parts if part.name != WHOLE]
        covered = np.any(masks, axis=0)
        beside = len(masks) * covered.sum() / sum(mask.sum() for mask in masks)  # parts; 1 where they lie over each other
        self.pixels, self.edge = measure.jittered(covered, int(effort.pixels * min(beside, 6)))

    def see(self, part):
        """The reference of a part, at the pixels of the frame's raster that it has."""
        inside = part.coverage.ravel()[self.pixels] > 0
        only = np.zeros(part.coverage.size, np.float32)
        only[self.pixels[inside]] = 1
        layers = self.scene.shade(part, Setting("reference", density="dense"), self.effort.workers, only.reshape(part.coverage.shape),
                                  tolerance=self.effort.tolerance, max_samples=self.effort.most_lookups)
        pixels = np.flatnonzero(only * (layers["validity"].ravel() == 0))
        return Seen(pixels, measure.truth_of(layers, pixels), float(layers["samples"].ravel()[pixels].mean()) if pixels.size else 0.0)

    def row(self, part, seen, setting):
        """Shade and compare."""
        layers, seconds, runs = self.timed(part, setting)
        overlay = layers["overlay"].reshape(-1, 3)[seen.pixels]
        environment, light_s = self.scene.lights.get(*setting.light())
        if environment:
            seconds["light"] += light_s
        samples, valid = layers["samples"], layers["report"]["pixels"]["valid"]
        stages = {f"{stage}_s": seconds.get(stage, 0.0) for stage in (*STAGES, "light_tables")}
        frame_s = stages["surface_s"] + stages["shading_s"] + stages["composite_s"]
        height, width = part.coverage.shape
        return Row(
            self.scene.name, self.scene.light, part.name, part.parameters, **dataclasses.asdict(setting),
            lookups=float(samples.sum() / max((samples > 0).sum(), 1)), face_size=environment.face_size if environment else 0,
            is_default=setting == self.scene.own, **self.errors(seen, overlay, width), **stages, frame_s=frame_s,
            alone_s=sum(stages.values()), runs=runs, threads=self.effort.cores, width=width, height=height, pixels=valid,
            shaded=int((samples > 0).sum()), reference_pixels=len(seen.pixels), reference_lookups=seen.lookups,
            reference_relative_rms=float(seen.truth.noise_rms()), reference_ceiling_db=float(min(seen.truth.ceiling_db(), 99.0)))

    def errors(self, seen, overlay, width):
        """The figures of error, by their names in a Row."""
        exact, beyond = seen.truth, None
        if self.scene.grazing is not None:
            beyond = float(exact.relative_rms(overlay, self.scene.grazing.ravel()[seen.pixels]))
        difference = np.abs(overlay - exact.radiance).max(-1)
        y, x = divmod(int(seen.pixels[difference.argmax()]), width)
        return dict(psnr_db=float(min(exact.psnr_db(overlay), exact.ceiling_db(), 99.0)),
                    relative_rms=float(exact.relative_rms(overlay)), relative_rms_beyond_75_deg=beyond,
                    largest_error=float(difference.max()), largest_x=x, largest_y=y)

    def timed(self, part, setting):
        """The layers, the median seconds of each stage, and of how many runs. The first with a light is not counted: it makes tables."""
        lights, first = self.scene.lights, None
        if lights.has_environment and setting.light() not in lights.tables:
            first = self.scene.shade(part, setting, self.effort.threads)["report"]["seconds"]["tables"]
        runs, end = [], time.perf_counter() + self.effort.seconds
        while not runs or (len(runs) < self.effort.runs and time.perf_counter() < end):
            layers = self.scene.shade(part, setting, self.effort.threads)
            runs.append(layers["report"]["seconds"])
        seconds = {stage: statistics.median(run.get(stage, 0.0) for run in runs) for stage in STAGES}
        if lights.has_environment:
            seconds["light_tables"] = lights.note_tables(setting.light(), max((first or 0.0) - seconds["tables"], 0.0))
        return layers, seconds, len(runs)


def together(seen):
    """What the reference saw of the whole frame: all of its parts."""
    pixels = np.concatenate([one.pixels for one in seen])
    radiance, noise = (np.concatenate([getattr(one.truth, name) for one in seen]) for name in ("radiance", "noise"))
    lookups = sum(one.lookups * len(one.pixels) for one in seen) / max(len(pixels), 1)
    return Seen(pixels, measure.Truth(radiance, noise), lookups)
