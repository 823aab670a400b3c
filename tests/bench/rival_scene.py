"""The scene that rivals render: the twelve objects that Cycles rendered, under its own light or another, and what is true of it.

Two truths: burnish's `reference`, whose noise is measured and taken out of every figure, and, where the data holds it, Cycles' own
pass of 1024 samples, whose noise is left in.
"""

import dataclasses
import json

import burnish
import numpy as np
import OpenImageIO as oiio
from burnish.charting.measure import Truth, truth_of

import cycles
import scenes

LIGHTS = {"courtyard": None, "hall": "st_fagans_interior_1k"}
"""Scene -> environment of data/public/env; None: the one that the data was rendered with."""

LONG = "aniso"
WHOLE, WITHOUT_LONG = "whole frame", "without the two 1:11 spheres"
TOLERANCE = 0.02  # of the reference


@dataclasses.dataclass(frozen=True)
class Scene:
    """Files that every rival is given; the surfaces are those of Cycles' own frame."""

    name: str
    frame: object  # paths
    light: object
    described: dict  # camera, materials and environment, as Cycles was told
    converged: bool  # whether `frame` holds the pass of 1024 samples under this very light

    @property
    def materials(self):
        """Name -> description."""
        return self.described["materials"]

    @property
    def rotation_deg(self):
        """How far the light is turned."""
        return self.described["environment"]["mapping_node"]["rotation_z_deg"]

    def shot(self):
        """The scene as a shot file of burnish."""
        job = cycles.job_of(self.frame.parent, self.frame.stem)
        sky = {"file": str(self.light), "up": job["up"], "rotate": job["env_rotate"]}
        return {"aovs": str(self.frame), "lights": {"sky": sky}, "materials": job["materials"], "assign": job["assign"]}


def scene_of(name, data, folder):
    """The scene `name`, its light written to `folder` as an EXR under the name that Cycles' script looks for."""
    rendered, source = data / "cycles" / "spheres", LIGHTS[name]
    light = folder / f"env_{name}.exr"
    picture = rendered / "env_courtyard.exr" if source is None else data / "public" / "env" / f"{source}.hdr"
    pixels = oiio.ImageBuf(str(picture)).get_pixels(oiio.FLOAT)[..., :3]
    scenes.write_exr(light, ["R", "G", "B"], pixels)
    described = json.loads((rendered / "spheres.json").read_text())
    return Scene(name, rendered / "spheres.exr", light, described, source is None)


def glossy(path):
    """The specular layer of a frame that Cycles rendered."""
    layers = scenes.read_exr(path)
    direct, indirect, colour = (scenes.stacked(layers, *(f"ViewLayer.{name}.{c}" for c in "RGB"))
                                for name in ("GlossDir", "GlossInd", "GlossCol"))
    return colour * (direct + indirect)


class Judge:
    """Measures pictures of a scene: display PSNR over the interiors of each object, and over those of all of them."""

    def __init__(self, scene, most_samples):
        index = scenes.read_exr(scene.frame)["ViewLayer.IndexMA.X"]
        masks = {name: cycles.interior(index, of["pass_index"]) for name, of in scene.materials.items()}
        short = [mask for name, mask in masks.items() if not name.startswith(LONG)]
        self.masks = {WHOLE: np.any(list(masks.values()), 0), WITHOUT_LONG: np.any(short, 0), **masks}
        shot = scene.shot()
        layers = burnish.composite(shot["aovs"], None, shot["materials"], assign=shot["assign"], lights=shot["lights"],
                                   estimator="reference", tolerance=TOLERANCE, max_samples=most_samples)
        self.reference = {name: truth_of(layers, mask) for name, mask in self.masks.items()}
        self.cycles = {}
        if scene.converged:
            specular = glossy(scene.frame)
            self.cycles = {name: Truth(specular[mask], np.zeros(1)) for name, mask in self.masks.items()}

    def noise_db(self):
        """How far the reference's own noise lies below white, over the whole frame: what was taken out of the figures."""
        truth = self.reference[WHOLE]
        exact = Truth(truth.radiance, np.zeros(1))
        random = np.random.default_rng(1).standard_normal(truth.noise.shape)
        return exact.psnr_db(truth.radiance + truth.noise * random)

    def db(self, overlay, truths):
        """Part of the frame -> dB."""
        return {name: float(truth.psnr_db(overlay[self.masks[name]])) for name, truth in truths.items()}

    def agreement_db(self):
        """The two truths against each other, part by part."""
        return {name: float(self.reference[name].psnr_db(truth.radiance)) for name, truth in self.cycles.items()}
