# SPDX-License-Identifier: GPL-3.0-or-later
"""A frame and its light, read once and composited again as its look changes. Knows burnish, but no bpy: it runs in a thread.

The overlay is the sum over the materials. When one of them moves, it alone is shaded (the others without lobes), and takes the
place of what it was: by a regular pattern without tables, as long as it moves (`shade`), and as it is set when
it rests (`refine`).
"""

import numpy as np

from . import package
from .look import adjusted, lit

AS_RENDERED = " (as rendered)"  # the old material of mode difference

_LIGHT = ("env", "env_convention", "env_rotate", "env_flip", "env_scale", "env_tint", "env_face_size", "env_kernel", "env_suns")
_FRAME = ("aovs", "fine_aovs", "camera", "channel", "view")
_BARE = {"lobes": []}
_QUICK = {"estimator": "regular", "samples": 12, "albedo_correction": False, "density": "dense", "psnr": 0.0}


class Session:
    """`shot`: settings by name, with the materials and the light as they were rendered; `look`: how they are now; `is_filtered`:
    whether pixels may show several materials at once."""

    def __init__(self, shot, look, is_filtered=True, progress=None):
        self._burnish = package.load()
        self._shot, self._look = shot, look
        frame = {name: value for name, value in shot.items() if name not in (*_LIGHT, "up", "lights", "fine_aovs")}
        self._frame = self._burnish.Frame(**frame)
        self._fine = self._burnish.Frame(**{**frame, "aovs": shot["fine_aovs"]}) if "fine_aovs" in shot else None
        self._light = self._read_light(look)
        self._shares_pixels = is_filtered and self._fine is None
        self._still = {name: value for name, value in shot.items() if name not in (*_LIGHT, *_FRAME, "materials")}
        self._apart, self._rest = None, None  # the material that moved last, and the overlay of all others
        self._is_exact = True
        layers = self._composite(self._worn(look), progress=progress)
        self.report, self.covered = layers["report"], layers["validity"] == 0
        self._overlay, self._base = layers["overlay"], layers["beauty"]
        self._base[:, :, :3] -= layers["overlay"]

    @property
    def materials(self):
        """The names of what the frame wears."""
        return list(self._look.sliders)

    def shade(self, look):
        """Bring the overlay up to a look, quickly."""
        moved = look.moved(self._look)
        if look.light != self._look.light or len(moved) > 1:
            self._apart, self._light = None, self._read_light(look)
            self._overlay, self._is_exact = self._composite(self._worn(look), _QUICK)["overlay"], False
        elif moved:
            self._take_apart(moved[0])
            self._overlay, self._is_exact = self._rest + self.part(moved[0], look, _QUICK), False
        self._look = look

    def refine(self):
        """Make the overlay as exact as it is set."""
        if self._is_exact:
            return
        if self._apart and not self._has_target():
            self._overlay = self._rest + self.part(self._apart)
        else:
            self._overlay = self._composite(self._worn(self._look))["overlay"]
        self._is_exact = True

    def pictures(self):
        """Overlay (height, width, 3) and composite (height, width, 4), linear."""
        overlay = self._overlay * np.asarray(self._look.weight, np.float32)
        composite = self._base.copy()
        composite[:, :, :3] += overlay
        return overlay, composite

    def part(self, name, look=None, settings=None):
        """The overlay of one material: by its own rules, or among all of them where they compete for pixels."""
        worn, kept = self._worn(look or self._look), (name, name + AS_RENDERED)
        bare = {other: material if other in kept else _BARE for other, material in worn.items()}
        rules = [rule for rule in self._still["assign"] if self._shares_pixels or rule["material"] == name]
        return self._composite(bare, {**(settings or {}), "assign": rules})["overlay"]

    def rendered(self):
        """What the renderer itself has in the overlay's place: specular radiance (height, width, 3)."""
        bare = dict.fromkeys(self._worn(self._look), _BARE)
        whole, without = (self._composite(bare, {**_QUICK, "mode": mode})["beauty"][:, :, :3] for mode in ("add", "replace"))
        return whole - without

    def _take_apart(self, name):
        """Keep what the other materials add; a target is reached by the frame as a whole, and leaves nothing to keep."""
        if self._apart == name:
            return
        if self._has_target():
            self._rest = self._composite({**self._worn(self._look), name: _BARE}, _QUICK)["overlay"]
        else:
            self.refine()
            self._rest = self._overlay - self.part(name)
        self._apart = name

    def _has_target(self):
        return "psnr" in self._still

    def _worn(self, look):
        own = self._shot["materials"]
        return {**own, **{name: adjusted(own[name], sliders) for name, sliders in look.sliders.items()}}

    def _read_light(self, look):
        if "env" not in self._shot:
            return None
        settings = {name: self._shot[name] for name in (*_LIGHT, "up") if name in self._shot}
        return self._burnish.Environment(settings.pop("env"), **{**settings, **lit(self._shot, look)})

    def _composite(self, materials, settings=None, progress=None):
        """As it is set, or with other settings."""
        return self._burnish.composite(self._frame, self._light, fine_aovs=self._fine, progress=progress, materials=materials,
                                       **{**self._still, **(settings or {})})
