# SPDX-License-Identifier: GPL-3.0-or-later
"""A frame and its light, read once and composited again as its look changes. Knows burnish, but no bpy: it runs in a thread.

The overlay is the sum over the materials. When one of them moves, it alone is shaded (the others without lobes), and takes the
place of what it was.
"""

import numpy as np

from . import package
from .look import adjusted, lit

AS_RENDERED = " (as rendered)"  # the old material of mode difference

_LIGHT = ("env", "env_convention", "env_rotate", "env_flip", "env_scale", "env_tint", "env_face_size", "env_kernel", "env_suns")
_FRAME = ("aovs", "fine_aovs", "camera", "channel", "view")
_BARE = {"lobes": []}


class Session:
    """`shot`: settings by name, with the materials and the light as they were rendered; `look`: how they are now."""

    def __init__(self, shot, look, progress=None):
        self._burnish = package.load()
        self._shot, self._look = shot, look
        frame = {name: value for name, value in shot.items() if name not in (*_LIGHT, "up", "lights", "fine_aovs")}
        self._frame = self._burnish.Frame(**frame)
        self._fine = self._burnish.Frame(**{**frame, "aovs": shot["fine_aovs"]}) if "fine_aovs" in shot else None
        self._light = self._read_light()
        still = {name: value for name, value in shot.items() if name not in (*_LIGHT, *_FRAME, "materials")}
        self._sliding = _as_sliders_do(still)
        self._apart, self._rest = None, None  # the material that moved last, and the overlay of all others
        layers = self._composite(self._worn(look), progress, **still)
        self.report, self.covered = layers["report"], layers["validity"] == 0
        self._overlay, self._base = layers["overlay"], layers["beauty"]
        self._base[:, :, :3] -= layers["overlay"]

    @property
    def materials(self):
        """The names of what the frame wears."""
        return list(self._look.sliders)

    def warm(self):
        """Shade everything as sliders will, so that the first move is as quick as the next."""
        self._overlay = self._composite(self._worn(self._look))["overlay"]

    def shade(self, look):
        """Bring the overlay up to a look."""
        before, self._look = self._look, look
        moved = look.moved(before)
        if look.light != before.light:
            self._light = self._read_light()
        if look.light != before.light or len(moved) > 1:
            self._apart = None
            self.warm()
        elif moved:
            self._exchange(moved[0], before)

    def pictures(self):
        """Overlay (height, width, 3) and composite (height, width, 4), linear."""
        overlay = self._overlay * np.asarray(self._look.weight, np.float32)
        composite = self._base.copy()
        composite[:, :, :3] += overlay
        return overlay, composite

    def part(self, name, look=None):
        """The overlay of one material."""
        worn = self._worn(look or self._look)
        kept = (name, name + AS_RENDERED)
        return self._composite({other: material if other in kept else _BARE for other, material in worn.items()})["overlay"]

    def rendered(self):
        """What the renderer itself has in the overlay's place: specular radiance (height, width, 3)."""
        bare = dict.fromkeys(self._worn(self._look), _BARE)
        whole, without = (self._composite(bare, **{**self._sliding, "mode": mode})["beauty"][:, :, :3] for mode in ("add", "replace"))
        return whole - without

    def _exchange(self, name, before):
        if self._apart != name:
            self._apart, self._rest = name, self._overlay - self.part(name, before)
        self._overlay = self._rest + self.part(name)

    def _worn(self, look):
        own = self._shot["materials"]
        return {**own, **{name: adjusted(own[name], sliders) for name, sliders in look.sliders.items()}}

    def _read_light(self):
        if "env" not in self._shot:
            return None
        settings = {name: self._shot[name] for name in (*_LIGHT, "up") if name in self._shot}
        return self._burnish.Environment(settings.pop("env"), **{**settings, **lit(self._shot, self._look)})

    def _composite(self, materials, progress=None, **settings):
        return self._burnish.composite(self._frame, self._light, fine_aovs=self._fine, progress=progress, materials=materials,
                                       **(settings or self._sliding))


def _as_sliders_do(settings):
    """Densely, without a target, and not by the reference, which is slow."""
    kept = {name: value for name, value in settings.items() if name != "psnr" and (name, value) != ("estimator", "reference")}
    return {**kept, "density": "dense"}
