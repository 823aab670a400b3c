# SPDX-License-Identifier: GPL-3.0-or-later
"""A frame and its light, read once and composited again as its look changes. Knows burnish, but no bpy: it runs in a thread.

The overlay is the sum over the materials. When one of them moves, it alone is shaded (the others without lobes), and takes the
place of what it was: by a regular pattern without tables, once a pixel, as long as it moves (`shade`), and as it is set when it
rests (`refine`).
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
        self._light = self._read_light()
        self._shares_pixels = is_filtered and self._fine is None
        self._still = {name: value for name, value in shot.items() if name not in (*_LIGHT, *_FRAME, "materials")}
        self._apart, self._rest = None, None  # the material that moved last, and the overlay of all others
        self._is_exact = True
        self._light = self._lit(look)
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
            self._apart, self._light = None, self._lit(look)
            self._overlay, self._is_exact = self._composite(self._worn(look), _QUICK, is_fine=False)["overlay"], False
        elif moved:
            self._take_apart(moved[0])
            self._overlay, self._is_exact = self._rest + self._quick_part(moved[0], look), False
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

    def part(self, name):
        """The overlay of one material."""
        return self._composite(self._alone(name, self._look), self._rules(name, self._shares_pixels))["overlay"]

    def rendered(self):
        """What the renderer itself has in the overlay's place: specular radiance (height, width, 3)."""
        bare = dict.fromkeys(self._worn(self._look), _BARE)
        whole, without = (self._composite(bare, {**_QUICK, "mode": mode})["beauty"][:, :, :3] for mode in ("add", "replace"))
        return whole - without

    def _quick_part(self, name, look):
        """Of the frame's own surfaces, though finer ones are there."""
        return self._composite(self._alone(name, look), {**_QUICK, **self._rules(name, False)}, is_fine=False)["overlay"]

    def _alone(self, name, look):
        """Materials by name, all others without lobes."""
        kept = (name, name + AS_RENDERED)
        return {other: material if other in kept else _BARE for other, material in self._worn(look).items()}

    def _rules(self, name, all_compete):
        """Who wears what, where one material is looked at: its own pixels, or what others leave it of shared ones."""
        return {"assign": [rule for rule in self._still["assign"] if all_compete or rule["material"] == name]}

    def _take_apart(self, name):
        """Keep what the other materials add; a target is reached by the frame as a whole, and leaves nothing to keep."""
        if self._apart == name:
            return
        if self._has_target():
            self._rest = self._composite({**self._worn(self._look), name: _BARE}, _QUICK, is_fine=False)["overlay"]
        else:
            self.refine()
            self._rest = self._overlay - self.part(name)
        self._apart = name

    def _has_target(self):
        return "psnr" in self._still

    def _worn(self, look):
        own = self._shot["materials"]
        return {**own, **{name: adjusted(own[name], sliders) for name, sliders in look.sliders.items()}}

    def _read_light(self):
        if "env" not in self._shot:
            return None
        settings = {name: self._shot[name] for name in (*_LIGHT, "up") if name in self._shot}
        return self._burnish.Environment(settings.pop("env"), **settings)

    def _lit(self, look):
        """The light as a look turns and weighs it; its picture is shared."""
        return self._light and self._burnish.Environment(self._light, **lit(self._shot, look))

    def _composite(self, materials, settings=None, is_fine=True, progress=None):
        """As it is set, or with other settings."""
        return self._burnish.composite(self._frame, self._light, fine_aovs=self._fine if is_fine else None, progress=progress,
                                       **{**self._still, **(settings or {}), "materials": materials})
