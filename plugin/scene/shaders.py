# SPDX-License-Identifier: GPL-3.0-or-later
"""A material's nodes as specular lobes: glossy BSDFs with what multiplies them on the way through Mix and Add Shaders.

What is not specular (diffuse, emission, transparency) stays in the rendered frame and is passed over. So does what is refracted:
Cycles keeps it in its transmission passes. Lobes are Cycles' own where burnish has them: GGX and Beckmann with separable Smith
shadowing, without Fresnel for Glossy and Anisotropic BSDFs, tinted. Two differ. Multiscatter GGX is GGX made as much brighter as
its width loses light by scattering once. A mix by Fresnel becomes the Fresnel of narrow lobes, which is taken at the microfacets'
normals instead of the surface's; wide lobes have it as a layer.
"""

from __future__ import annotations

import dataclasses

from . import links, principled, values
from .lobes import Lobe, Weight

_NOT_SPECULAR = {"BSDF_DIFFUSE", "BSDF_TRANSLUCENT", "BSDF_TRANSPARENT", "SUBSURFACE_SCATTERING", "EMISSION", "HOLDOUT",
                 "AMBIENT_OCCLUSION", "PRINCIPLED_VOLUME", "VOLUME_ABSORPTION", "VOLUME_SCATTER", "BACKGROUND"}
_MODELS = {"BECKMANN": "beckmann", "ASHIKHMIN_SHIRLEY": "ashikhmin-shirley"}


def lobes_of(material):
    """(lobes, notes) of what Cycles renders of a material; notes name node and socket of what has no lobe."""
    notes = []
    output = material.node_tree.get_output_node("CYCLES") if material.use_nodes and material.node_tree else None
    if output is None:
        return [], notes
    lobes = _walk(links.Place(output.inputs["Surface"]), Weight(), notes)
    return [lobe for lobe in lobes if not values.is_known(lobe.scale) or max(values.channels(lobe.scale)) > 0], notes


def _walk(place, weight, notes):
    shader = links.source(place)
    if shader is None or (values.is_known(weight.scale) and weight.scale == 0):
        return []
    node = shader.node
    if node.type == "MIX_SHADER":
        first, second = _branches(shader, weight, notes)
        return _walk(_input(shader, 1), first, notes) + _walk(_input(shader, 2), second, notes)
    if node.type == "ADD_SHADER":
        return _walk(_input(shader, 0), weight, notes) + _walk(_input(shader, 1), weight, notes)
    if node.type in _BUILDERS:
        return _BUILDERS[node.type](shader, weight, notes)
    if node.type not in _NOT_SPECULAR:
        notes.append(f"{node.name}: burnish has no lobe for a {node.bl_label}; it stays as rendered")
    return []


def _input(shader, index):
    return links.Place(shader.node.inputs[index], shader.groups)


def _branches(mix, weight, notes):
    """What the two shaders of a mix are multiplied by."""
    factor = principled.number(mix, notes, "Fac", "Factor")
    if values.is_known(factor):
        factor = min(max(factor, 0.0), 1.0)
    ior = _index_of(links.source(_input(mix, 0)))
    second = weight.times(factor) if ior is None or weight.ior else dataclasses.replace(weight, ior=ior, at_normal=factor)
    return weight.times(values.complement(factor)), second


def _index_of(factor):
    """The index of refraction where a factor is the Fresnel of the surface, known and unbent; else None."""
    if factor is None or factor.node.type not in ("FRESNEL", "LAYER_WEIGHT") or factor.node.inputs["Normal"].is_linked:
        return None
    if factor.node.type == "FRESNEL":
        ior = links.value(factor.input("IOR"))
        return ior if isinstance(ior, float) and ior > 1 else None
    if factor.socket.name == "Fresnel":
        blend = links.value(factor.input("Blend"))
        return 1 / max(1 - blend, 0.1) if isinstance(blend, float) and 0 < blend else None
    return None


def _glossy(shader, weight, notes):
    distribution = shader.node.distribution
    roughness = 0.0 if distribution == "SHARP" else principled.number(shader, notes, "Roughness")
    lobe = Lobe(shader.node.name, _MODELS.get(distribution, "ggx"), roughness)
    if shader.input("Anisotropy") and distribution != "SHARP":
        lobe.anisotropy = principled.number(shader, notes, "Anisotropy")
        lobe.rotation = principled.number(shader, notes, "Rotation")
        lobe.tangent = principled.tangent(shader)
    colour = principled.colour(shader, notes, "Color")
    scale = values.multiply(colour, lobe.energy_gain(colour)) if distribution == "MULTI_GGX" else colour
    return [lobe.under(weight, scale)]


def _glass(shader, weight, notes):
    distribution = shader.node.distribution
    roughness = 0.0 if distribution == "SHARP" else principled.number(shader, notes, "Roughness")
    lobe = Lobe(shader.node.name, _MODELS.get(distribution, "ggx"), roughness)
    notes.append(f"{shader.node.name}: what shines through stays as rendered")
    tinted = weight.times(principled.colour(shader, notes, "Color"))
    return [lobe.under(principled.through_glass(shader, tinted, notes), 1.0)]


def _refraction(shader, weight, notes):
    notes.append(f"{shader.node.name}: what shines through stays as rendered")
    return []


_BUILDERS = {"BSDF_GLOSSY": _glossy, "BSDF_ANISOTROPIC": _glossy, "BSDF_GLASS": _glass, "BSDF_REFRACTION": _refraction,
             "BSDF_PRINCIPLED": principled.lobes}
