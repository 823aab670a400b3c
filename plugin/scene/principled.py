# SPDX-License-Identifier: GPL-3.0-or-later
"""The Principled BSDF as lobes, for Blender 3.4 and for 4.x, whose sockets and formulas differ.

Base      GGX, alpha_x = r^2 / A, alpha_y = r^2 A, A = sqrt(1 - 0.9 anisotropic), and
          F = c + (1 - c) F_H,  c = 0.08 specular tint (1 - metallic) + base metallic,
          F_H = the Fresnel of ior = 2 / (1 - sqrt(0.08 specular)) - 1 less its F0, made to go from 0 to 1.
          A dielectric without tint is just the Fresnel of that index. Else there are two lobes, (c - F0) / (1 - F0) without
          Fresnel and (1 - c) / (1 - F0) with that of the index; textures go to the AOVs Tint and Weight. One lobe with Schlick's
          curve is near enough for bright metals, and for those darker than F0.
Coat      3.4: 0.25 clearcoat F D G, ior 1.5, D = GTR1. Cycles draws its directions as if it were GGX, which shows: its renders have
          GGX's core and only far out GTR1's tail. GGX and a wide lobe a third as bright come near them. 4.x: GGX of its own index.
Glass     the part that reflects: GGX with the Fresnel of the IOR socket. What shines through stays as rendered.
"""

from __future__ import annotations

import dataclasses
import math

from . import links, values
from .lobes import Lobe

_COAT_IOR, _COAT_TAIL = 1.5, 0.3  # tail: alpha of the wide lobe
_BRIGHT = 0.4  # reflectance from which a dielectric's Fresnel and Schlick's make no difference


def number(place, notes, *names, default=0.0):
    """A socket's number, known or an expression; without such a socket `default`."""
    return values.mean(_value(place, notes, names, default))


def colour(place, notes, *names, default=(1.0, 1.0, 1.0)):
    """The same of a colour; known ones are RGB."""
    value = _value(place, notes, names, default)
    return values.channels(value) if values.is_known(value) else value


def _value(place, notes, names, default):
    socket = place.input(*names)
    if socket is None:
        return default
    value = links.value(socket)
    if value is None:
        notes.append(f"{place.node.name}, {socket.socket.name}: comes from inside a node group; what stands in the socket is used")
        value = links.plain(socket)
    return value


def tangent(place):
    """(node name, output index) of what is linked to the Tangent socket, or None."""
    found = links.source(place.input("Tangent"))
    return values.from_socket(found.socket, 0.0).arguments if found and not found.groups else None


def lobes(shader, weight, notes):
    new = shader.input("Coat Weight") is not None
    metallic = number(shader, notes, "Metallic")
    transmission = number(shader, notes, "Transmission", "Transmission Weight")
    alpha = number(shader, notes, "Alpha", default=1.0)
    visible = weight.times(alpha)
    through = values.multiply(transmission, values.complement(metallic))
    base = visible.times(values.complement(through))
    found = _base(shader, base, metallic, notes)
    if not values.is_known(through) or through > 0:
        found.append(_reflecting_glass(shader, visible.times(through), notes))
    coat = (_coat if new else _clearcoat)(shader, visible, notes)
    normal = shader.input("Clearcoat Normal", "Coat Normal")
    if coat and links.source(normal) != links.source(shader.input("Normal")):
        notes.append(f"{shader.node.name}, {normal.socket.name}: coat and base are shaded with the mean of their normals, the Normal pass")
    return found + coat


def _index(shader, notes):
    """(specular as of 3.4, its index of refraction): F0 = 0.08 specular."""
    level = number(shader, notes, "Specular", "Specular IOR Level", default=0.5)
    if shader.input("Specular IOR Level"):
        ior = values.typical(number(shader, notes, "IOR"))
        level = values.multiply(level, 2 * ((ior - 1) / (ior + 1)) ** 2 / 0.08)
    root = math.sqrt(min(max(0.08 * values.typical(level), 0.0), 0.98))
    return level, 2 / (1 - root) - 1


def _stretched(shader, notes):
    """A GGX lobe with the base's widths."""
    lobe = Lobe(shader.node.name, "ggx", number(shader, notes, "Roughness"))
    anisotropic = number(shader, notes, "Anisotropic")
    if not values.is_known(anisotropic) or anisotropic != 0:
        aspect = values.apply("SQRT", values.complement(values.multiply(0.9, anisotropic)))
        lobe.anisotropy = values.apply("SUBTRACT", aspect, 1.0)
        lobe.rotation = number(shader, notes, "Anisotropic Rotation")
        lobe.tangent = tangent(shader)
    return lobe


def _tint(shader, base, notes):
    """What multiplies the reflectance of the dielectric at normal incidence."""
    socket = shader.input("Specular Tint")
    if socket and socket.socket.type == "RGBA":
        return colour(shader, notes, "Specular Tint")
    amount = number(shader, notes, "Specular Tint")
    if values.is_known(amount) and amount == 0:
        return 1.0
    base = values.channels(values.typical(base))
    luminance = 0.3 * base[0] + 0.6 * base[1] + 0.1 * base[2]
    hue = tuple(part / luminance for part in base) if luminance > 0 else (1.0, 1.0, 1.0)
    return values.mix(1.0, hue, amount)


def _base(shader, weight, metallic, notes):
    base = colour(shader, notes, "Base Color")
    specular, ior = _index(shader, notes)
    tint = _tint(shader, base, notes)
    lobe = _stretched(shader, notes)
    if shader.node.distribution == "MULTI_GGX":
        weight = weight.times(lobe.energy_gain(values.mix(0.04, base, metallic)))
    dielectric = values.multiply(values.multiply(0.08, specular), tint)
    c = values.mix(dielectric, base, metallic)
    if values.is_known(c) and metallic == 0 and tint == 1.0:
        return [_with_fresnel(lobe, weight, {"ior": ior})] if ior > 1 else []
    if values.is_known(c) and (min(values.channels(c)) > _BRIGHT or min(values.channels(c)) < _f0(ior) - 0.01):
        fresnel = {"r0": [min(channel, 1.0) for channel in values.channels(c)]}
        return [_with_fresnel(lobe, weight, {**fresnel, **_bend(1 - sum(values.channels(c)) / 3)})]
    grazing = values.complement(c if values.is_known(c) else values.mean(c))
    if not values.is_known(specular):
        return [lobe.under(weight, c), _with_fresnel(lobe, weight, {"r0": 0.0, **_bend(1.0)}, grazing)]
    flat = values.multiply(1 / (1 - _f0(ior)), values.apply("SUBTRACT", c, _f0(ior)))
    return [lobe.under(weight, values.apply("MAXIMUM", flat, 0.0)),
            _with_fresnel(lobe, weight, {"ior": ior}, values.multiply(1 / (1 - _f0(ior)), grazing))]


def _f0(ior):
    return ((ior - 1) / (ior + 1)) ** 2


def _bend(share):
    """What a dielectric's Fresnel, made to go from 0 to 1, is above Schlick's: about that of ior 1.5."""
    return {"dip": -0.06 * share, "dip_power": 1.1}


def _with_fresnel(lobe, weight, fresnel, scale=1.0):
    return dataclasses.replace(lobe, fresnel=fresnel).under(weight, scale)


def through_glass(shader, weight, notes):
    """A weight times what a smooth surface of glass reflects: the Fresnel of the IOR socket."""
    ior = number(shader, notes, "IOR")
    found = links.source(shader.input("Normal"))
    normal = values.from_socket(found.socket, 0.0) if found and not found.groups else None
    at_normal = values.fresnel(ior, normal)
    if weight.ior or not values.is_known(ior):
        return weight.times(at_normal)
    return dataclasses.replace(weight, ior=min(max(ior, 0.1), 10.0), at_normal=at_normal)


def _reflecting_glass(shader, weight, notes):
    notes.append(f"{shader.node.name}: what shines through stays as rendered")
    return Lobe(shader.node.name, "ggx", number(shader, notes, "Roughness")).under(through_glass(shader, weight, notes), 1.0)


def _clearcoat(shader, weight, notes):
    strength = number(shader, notes, "Clearcoat")
    if values.is_known(strength) and strength <= 0:
        return []
    coat = Lobe(shader.node.name, "ggx", number(shader, notes, "Clearcoat Roughness"), fresnel={"ior": _COAT_IOR})
    tail = dataclasses.replace(coat, roughness=math.sqrt(_COAT_TAIL))
    return [coat.under(weight, values.multiply(0.25, strength)), tail.under(weight, values.multiply(0.08, strength))]


def _coat(shader, weight, notes):
    strength = number(shader, notes, "Coat Weight")
    if values.is_known(strength) and strength <= 0:
        return []
    ior = values.typical(number(shader, notes, "Coat IOR", default=_COAT_IOR))
    lobe = Lobe(shader.node.name, "ggx", number(shader, notes, "Coat Roughness"), fresnel={"ior": max(ior, 1.0)})
    return [lobe.under(weight, strength)]
