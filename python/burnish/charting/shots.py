"""Shots as scenes: a shot file, or an EXR with settings, taken apart by the rules that say who wears what.

Which rule a pixel has, and how much of it that covers, is read off a frame in false colours: under white light every rule
wears the same lobe in a hue of its own.
"""

from __future__ import annotations

import glob
import pathlib

import numpy as np

from .. import BadArgument, Frame, _core, composite
from .lights import Lights
from .scene import WHOLE, Part, Scene, Source, file_stamps, parameters_of
from .setting import OF_SETTING, own_setting

LEFT_OUT = ("output", "preview", "report", "pixel_type", "diagnostics", "keep_layers", "skip_existing", "frames", "bad_frames", "threads",
            "mode", "old_material", "fine_aovs", "filter", "filter_width", "edge_coverage", "tolerance", "max_samples")
"""Settings that say nothing about one frame's overlay, sample by sample."""
OF_FRAME = ("aovs", "camera", "channel", "view", "per_pixel")
WHITE_LOBE = {"model": "beckmann", "m": 0.3}


def shot_source(file, name=None):
    """The Source of a shot file."""
    return source_of(name or pathlib.Path(file).stem, _core.shot_settings(str(pathlib.Path(file).absolute())))


def source_of(name, settings):
    """The Source of a job's settings by name."""
    settings = _core.shot_settings(settings)
    job = {key: value for key, value in settings.items() if key not in LEFT_OUT}
    if "#" in job["aovs"]:
        job["aovs"] = first_frame(job["aovs"])
    count = len(job.get("assign", ())) + ("material" in job)
    return Source(name, count + (count > 1), [job, file_stamps(job)], lambda: load(name, job))


def first_frame(pattern):
    """The first file of a sequence."""
    files = sorted(glob.glob(pattern.replace("#", "[0-9]")))
    if not files:
        raise BadArgument(f"aovs: no file is called {pattern}; name one that is there")
    return files[0]


def load(name, job):
    """Read the frame and find its parts."""
    frame = Frame(**{key: value for key, value in job.items() if key in (*OF_FRAME, "material", "materials", "assign")})
    source, lights, shared = split(job)
    rules = [{"material": job[key]} for key in ("material",) if key in job] + job.get("assign", [])
    own = own_setting(job, frame.width * frame.height, any(near_lights(job, rule) for rule in rules))
    parts = [part for part in parts_of(frame, job, shared, rules) if part.coverage.any()]
    if len(parts) > 1:
        whole = {key: job[key] for key in ("material", "assign") if key in job}
        union = sum(part.coverage for part in parts)
        parts.append(Part(WHOLE, f"{len(parts)} materials", {**whole, "lights": lights, **chain_of(job)}, union))
    return Scene(name, pathlib.Path(source).stem if source else "near", frame, shared, Lights(source, light_settings(job, frame)),
                 tuple(parts), own)


def split(job):
    """The environment's file, the near lights, and what all parts share."""
    apart = (*OF_SETTING, *OF_FRAME, "env", "env_face_size", "lights", "default_light", "material", "assign")
    return job.get("env"), job.get("lights", {}), {key: value for key, value in job.items() if key not in apart}


def light_settings(job, frame):
    """What an Environment of the job is made with."""
    names = [key for key in job if key.startswith("env_") or key in ("ocio_config", "beauty_space")]
    up = job.get("up", "auto")
    return {key: job[key] for key in names if key != "env_suns"} | {"up": frame.up if up == "auto" else up}


def chain_of(job):
    """The lights of rules that name none, if the job says so."""
    return {"default_light": job["default_light"]} if "default_light" in job else {}


def near_lights(job, rule):
    """The lights near the objects that a rule can use, by name: all of them where it leaves them to the pixel's place."""
    chain, lights = rule.get("light") or job.get("default_light", "").split(","), job.get("lights", {})
    return lights if chain in ([""], ["auto"]) else {name: light for name, light in lights.items() if name in chain}


def parts_of(frame, job, shared, rules):
    """A Part for every rule: its pixels by mask, with the lights it names and no other."""
    covers = coverages(frame, shared, rules)
    names = names_of(rules)
    for rule, name, coverage in zip(rules, names, covers):
        material = rule["material"]
        chain = {"default_light": rule["light"]} if rule.get("light") else chain_of(job)
        worn = {"assign": {material: coverage}, "lights": near_lights(job, rule), **chain}
        yield Part(name, parameters_of(job.get("materials", {}).get(material, material)), worn, coverage)


def names_of(rules):
    """The materials' names, with what rules select where two wear the same."""
    worn = [rule["material"] for rule in rules]
    for rule in rules:
        selected = ", ".join(str(value) for key, value in rule.items() if key not in ("material", "light"))
        name = rule["material"]
        yield f"{name} ({selected})" if worn.count(name) > 1 and selected else name


def coverages(frame, shared, rules):
    """The share of each pixel that each rule covers, shape (height, width), one after the other; 0 where nothing is shaded."""
    hues = {f"hue {index}": WHITE_LOBE | {"tint": [1, (index + 1) / len(rules), 0]} for index in range(len(rules))}
    selectors = [{key: value for key, value in rule.items() if key not in ("material", "light")} for rule in rules]
    job = dict(estimator="split_sum", density="dense", camera=None)
    surface = {key: value for key, value in shared.items() if key in ("tangent", "tangent_axis", "min_normal_length")}
    white = np.ones((8, 16, 3), np.float32)

    def shown(rules):
        return composite(frame, white, materials=hues, assign=rules, **job, **surface)["overlay"]

    coloured = shown([{"material": name, **selector} for name, selector in zip(hues, selectors)])
    plain = shown([{"material": next(iter(hues))}])
    lit = coloured[..., 0] > 0
    index = np.zeros(lit.shape, int)
    index[lit] = np.round(coloured[lit][:, 1] / coloured[lit][:, 0] * len(rules)).astype(int)
    share = np.where(lit, coloured[..., 0] / np.maximum(plain[..., 0], 1e-30), 0).round(5).astype(np.float32)
    return [np.where(index == rule + 1, share, np.float32(0)) for rule in range(len(rules))]
