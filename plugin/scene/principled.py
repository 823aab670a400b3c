# SPDX-License-Identifier: GPL-3.0-or-later
"""The Principled BSDF as lobes, for Blender 3.4 and for 4.x, whose sockets and formulas differ.

Base      GGX, alpha_x = r^2 / A, alpha_y = r^2 A, A = sqrt(1 - 0.9 anisotropic), and
          F = c + (1 - c) F_H,  c = 0.08 specular tint (1 - metallic) + base metallic,
          F_H = the Fresnel of ior = 2 / (1 - sqrt(0.08 specular)) - 1 less its F0, made to go from 0 to 1.
          A dielectric without tint is just the Fresnel of that index; else F_H is Schlick's. Where textures drive c there are
          two lobes: c - (1 - c) F0 / (1 - F0) in the AOV Tint, and (1 - c) / (1 - F0) in Weight, with the Fresnel of the index.
Coat      3.4: 0.25 clearcoat F D G, ior 1.5, D = GTR1, whose nearest is the model `abc` with C = 1; 4.x: GGX of its own index.
Glass     the part that reflects: GGX with the Fresnel of the IOR socket. What shines through stays as rendered.
"""

from __future__ import annotations

import math

from . import links, values
from .lobes import Lobe

_COAT_IOR = 1.5


def number(place, notes, *names, default=0.0):
    """A socket's number, known or an expression; without such a socket `default`."""
    socket = place.input(*names)
    if socket is None:
        return default
    value = links.value(socket)
    if value is None:
        notes.append(f"{place.node.name}, {socket.socket.name}: comes from inside a node group; its plain number is used")
        value = links.plain(socket)
    return values.mean(value)


def colour(place, notes, *names, default=(1.0, 1.0, 1.0)):
    socket = place.input(*names)
    if socket is None:
        return default
    value = links.value(socket)
    if value is None:
        notes.append(f"{place.node.name}, {socket.socket.name}: comes from inside a node group; its plain colour is used")
        value = links.plain(socket)
    return values.channels(value) if values.is_known(value) else value


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
    return found + coat


def _index(shader, notes):
    """(specular as of 3.4, its index of refraction): F0 = 0.08 specular."""
    level = number(shader, notes, "Specular", "Specular IOR Level", default=0.5)
    if shader.input("Specular IOR Level"):
        ior = values.typical(number(shader, notes, "IOR"))
        level = values.multiply(level, 2 * ((ior - 1) / (ior + 1)) ** 2 / 0.08)
    root = math.sqrt(min(max(0.08 * values.typical(level), 0.0), 0.98))
    return level, 2 / (1 - root) - 1


def _stretched(shader, notes, name="Principled BSDF"):
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
        weight = weight.times(lobe.energy_gain(values.mix(0.04, base, metallic))[0])
    dielectric = values.multiply(values.multiply(0.08, specular), tint)
    c = values.mix(dielectric, base, metallic)
    if not values.is_known(c):
        return _textured_base(lobe, weight, c, specular, ior)
    if values.is_known(metallic) and metallic == 0 and tint == 1.0:
        return [_with_fresnel(lobe, weight, {"ior": ior})] if ior > 1 else []
    fresnel = {"r0": [min(channel, 1.0) for channel in values.channels(c)]}
    return [_with_fresnel(lobe, weight, fresnel)]


def _with_fresnel(lobe, weight, fresnel, scale=1.0):
    lobe = Lobe(**{**vars(lobe), "fresnel": fresnel})
    return lobe.under(weight, scale)


def _textured_base(lobe, weight, c, specular, ior):
    """F = c + (1 - c) F_H with c from an AOV."""
    grazing = values.complement(values.mean(c))
    if values.is_known(specular):
        f0 = ((ior - 1) / (ior + 1)) ** 2
        normalised = values.multiply(1 / (1 - f0), values.apply("SUBTRACT", c, f0))
        flat = values.apply("MAXIMUM", normalised, 0.0)
        return [lobe.under(weight, flat), _with_fresnel(lobe, weight, {"ior": ior}, values.multiply(1 / (1 - f0), grazing))]
    return [lobe.under(weight, c), _with_fresnel(lobe, weight, {"r0": 0.0}, grazing)]


def _reflecting_glass(shader, weight, notes):
    ior = values.typical(number(shader, notes, "IOR"))
    notes.append(f"{shader.node.name}: what shines through stays as rendered")
    lobe = Lobe(shader.node.name, "ggx", number(shader, notes, "Roughness"), fresnel={"ior": min(max(ior, 0.1), 10)})
    return lobe.under(weight, 1.0)


def _clearcoat(shader, weight, notes):
    strength = number(shader, notes, "Clearcoat")
    if values.is_known(strength) and strength <= 0:
        return []
    roughness = number(shader, notes, "Clearcoat Roughness")
    if not values.is_known(roughness):
        notes.append(f"{shader.node.name}, Clearcoat Roughness: from a texture, which a clearcoat cannot have; {values.typical(roughness):g} is used")
    alpha = max(values.typical(roughness) ** 2, 1.5e-4)
    lobe = Lobe(shader.node.name, "abc", 0.0, fresnel={"ior": _COAT_IOR}, extra={"B": 2 * (1 - alpha**2) / alpha**2, "C": 1.0})
    return [lobe.under(weight, values.multiply(0.25, strength))]


def _coat(shader, weight, notes):
    strength = number(shader, notes, "Coat Weight")
    if values.is_known(strength) and strength <= 0:
        return []
    ior = values.typical(number(shader, notes, "Coat IOR", default=_COAT_IOR))
    lobe = Lobe(shader.node.name, "ggx", number(shader, notes, "Coat Roughness"), fresnel={"ior": max(ior, 1.0)})
    return [lobe.under(weight, strength)]
