# SPDX-License-Identifier: GPL-3.0-or-later
"""One specular lobe of a material, in burnish's terms: numbers that are known or expressions (values.py)."""

from __future__ import annotations

import dataclasses
from typing import Any

from . import values


NARROW = 0.2  # roughness up to which the microfacets' normals may stand for the surface's in a Fresnel


@dataclasses.dataclass(frozen=True)
class Weight:
    """What a shader is multiplied by on the way to the output."""

    scale: Any = 1.0  # a value
    ior: float | None = None  # the Fresnel of this index, too, which a lobe may take for its own
    at_normal: Any = 1.0  # that Fresnel at the surface's normal, as Cycles takes it

    def times(self, value):
        return dataclasses.replace(self, scale=values.multiply(self.scale, value))


@dataclasses.dataclass
class Lobe:
    node: str  # its name, for notes
    model: str  # as burnish names it
    roughness: Any  # the artist's r, alpha = r^2
    anisotropy: Any = 0.0  # as burnish and the Anisotropic BSDF have it: alpha (1 - a) along the tangent, alpha / (1 - a) across
    rotation: Any = 0.0  # turns of the tangent about the normal
    tangent: tuple | None = None  # (node name, output) of the tangent's socket; None: around the object's Z axis
    scale: Any = 1.0  # colour or number that multiplies it
    fresnel: dict = dataclasses.field(default_factory=dict)  # JSON
    extra: dict = dataclasses.field(default_factory=dict)  # the model's own parameters, JSON

    def under(self, weight, scale):
        """This lobe with all that multiplies it."""
        total = values.multiply(weight.scale, scale)
        if weight.ior and not self.fresnel and values.typical(self.roughness) <= NARROW:
            return dataclasses.replace(self, scale=total, fresnel={"ior": weight.ior})
        return dataclasses.replace(self, scale=values.multiply(total, weight.at_normal))

    def energy_gain(self, colour):
        """How much brighter scattering many times makes it, where each scattering is tinted by c: 1 / (1 - c L) in each channel.

        L = 0.64 alpha^1.24: what white GGX loses by scattering once, by Cycles' renders of spheres.
        """
        loss = 0.64 * min(max(values.typical(self.roughness), 0.0), 1.0) ** 2.48
        return tuple(1 / (1 - min(channel, 1.0) * loss) for channel in values.channels(values.typical(colour)))

    @property
    def is_stretched(self):
        return not values.is_known(self.anisotropy) or self.anisotropy != 0
