# SPDX-License-Identifier: GPL-3.0-or-later
"""A material's lobes against the AOVs of the frame: which of their numbers come from a layer, pixel by pixel.

A frame has one layer of each kind, so lobes of one material share it: the first that needs a layer has it, and others where they
need the very same. What finds no layer is told, and its typical number stands for it. Layers are named as burnish knows them;
Roughness, and Tangent where a lobe is stretched, are written for every specular material, so that they can be edited later.
"""

from __future__ import annotations

import dataclasses

from . import values
from .shaders import lobes_of

NAMES = {"roughness": "Roughness", "anisotropy": "Anisotropy", "rotation": "Rotation", "tint": "Burnish Tint",
         "weight": "Burnish Weight", "tangent": "Tangent"}
TYPES = {name: "COLOR" if kind in ("tint", "tangent") else "VALUE" for kind, name in NAMES.items()}
_WORDS = {"roughness": "Roughness", "anisotropy": "Anisotropy", "rotation": "Rotation", "tint": "Color", "weight": "Color"}


@dataclasses.dataclass
class Plan:
    lobes: list  # (lobe, kinds that come from layers)
    layers: dict  # kind -> value; tangent: (node name, output) or None for the object's Z axis
    notes: list


def plan(material):
    """How a material's lobes are shown to burnish."""
    lobes, notes = lobes_of(material)
    if material.library and not all(map(_is_constant, lobes)):
        notes.append("linked from another file, so no layers can be wired into it; plain numbers stand for its textures")
        return Plan([(lobe, set()) for lobe in lobes], {}, notes)
    result = Plan([(lobe, set()) for lobe in lobes], {}, notes)
    for kind in ("roughness", "anisotropy", "rotation"):
        for lobe, kinds in result.lobes:
            _take(result, lobe, kinds, getattr(lobe, kind), [kind])
    for colours_first in (True, False):
        for lobe, kinds in result.lobes:
            if values.is_colour(values.factors(lobe.scale)[1]) == colours_first:
                _take(result, lobe, kinds, values.factors(lobe.scale)[1], ["tint"] if colours_first else ["weight", "tint"])
    if lobes:
        result.layers.setdefault("roughness", lobes[0].roughness)
    stretched = next((lobe for lobe in lobes if lobe.is_stretched), None)
    if stretched:
        result.layers["tangent"] = stretched.tangent
    return result


def _is_constant(lobe):
    return all(map(values.is_known, (lobe.roughness, lobe.anisotropy, lobe.rotation, lobe.scale)))


def _take(result, lobe, kinds, value, possible):
    if values.is_known(value):
        return
    for kind in possible:
        if result.layers.setdefault(kind, value) == value:
            kinds.add(kind)
            return
    result.notes.append(f"{lobe.node}, {_WORDS[possible[0]]}: another lobe of the material has the layer {NAMES[possible[0]]}; "
                        f"{_text(values.typical(value))} is used")


def _text(value):
    return ", ".join(f"{part:.3g}" for part in values.channels(value)) if isinstance(value, tuple) else f"{value:.3g}"
