# SPDX-License-Identifier: GPL-3.0-or-later
"""What a composite looks like: sliders over what was rendered. Plain values and burnish's documents, no bpy.

Widths are burnish's: alpha = roughness^2, mx = alpha (1 - a) and my = alpha / (1 - a) for an anisotropy a >= 0, and the other way
round for a < 0. The sliders move the lobes that are as wide as the first one; a coat stays as it is.
"""

import dataclasses

_SHAPE = ("m", "mx", "my", "roughness", "anisotropy", "rotation_deg")


@dataclasses.dataclass
class Look:
    """`sliders`: of each material, by name. `light`: env_rotate is added to the world's, env_scale and env_tint multiply it.
    `weight`: of the whole overlay, a number a channel."""

    sliders: dict
    light: dict
    weight: tuple = (1.0, 1.0, 1.0)

    def moved(self, other):
        """The materials that differ."""
        return [name for name in self.sliders if self.sliders[name] != other.sliders.get(name)]


def sliders_of(material):
    """Roughness, anisotropy and rotation (0..1 is a whole turn) of the first lobe, and the neutral weight."""
    lobe = _lobes(material)[0]
    mx, my = _widths(lobe)
    bend = (mx / my) ** 0.5
    return {"roughness": (mx * my) ** 0.25, "anisotropy": 1 - bend if bend <= 1 else 1 / bend - 1,
            "rotation": lobe.get("rotation_deg", 0.0) / 360, "gain": 1.0, "tint": (1.0, 1.0, 1.0)}


def textured(material):
    """Which numbers of the first lobe come from the frame's layers."""
    return list(_lobes(material)[0].get("per_pixel", ()))


def adjusted(material, sliders):
    """The material as its sliders say."""
    lobes = _lobes(material)
    widths = _widths(lobes[0])
    is_moved = any(abs(sliders[name] - value) > 1e-5 for name, value in sliders_of(material).items() if isinstance(value, float))
    changed = [_weighted(_shaped(lobe, sliders) if is_moved and _widths(lobe) == widths else lobe, sliders) for lobe in lobes]
    return {**material, "lobes": changed} if "lobes" in material else changed[0]


def folded(shot, look):
    """Settings by name with a look in them."""
    worn = {name: adjusted(shot["materials"][name], sliders) for name, sliders in look.sliders.items()}
    return {**shot, **lit(shot, look), "materials": {**shot["materials"], **worn}}


def lit(shot, look):
    """The settings of the light that a look changes; none where the shot has no environment."""
    if "env" not in shot:
        return {}
    tint = [a * b for a, b in zip(shot.get("env_tint", (1, 1, 1)), look.light.get("env_tint", (1, 1, 1)))]
    return {"env_rotate": shot.get("env_rotate", 0.0) + look.light.get("env_rotate", 0.0),
            "env_scale": shot.get("env_scale", 1.0) * look.light.get("env_scale", 1.0), "env_tint": tint}


def _lobes(material):
    return material["lobes"] if "lobes" in material else [material]


def _shaped(lobe, sliders):
    mx, my = _stretched(sliders["roughness"] ** 2, sliders["anisotropy"])
    turn = {"rotation_deg": 360 * sliders["rotation"]} if sliders["rotation"] else {}
    return {**{key: value for key, value in lobe.items() if key not in _SHAPE}, "mx": mx, "my": my, **turn}


def _weighted(lobe, sliders):
    weight = [sliders["gain"] * channel for channel in sliders["tint"]]
    if weight == [1.0, 1.0, 1.0]:
        return lobe
    tint = lobe.get("tint", 1.0)
    channels = tint if isinstance(tint, (list, tuple)) else [tint] * 3
    return {**lobe, "tint": [a * b for a, b in zip(channels, weight)]}


def _widths(lobe):
    if "mx" in lobe or "my" in lobe:
        return lobe.get("mx", 0.1), lobe.get("my", 0.1)
    alpha = lobe["roughness"] ** 2 if "roughness" in lobe else lobe.get("m", 0.1)
    return _stretched(alpha, lobe.get("anisotropy", 0.0))


def _stretched(alpha, a):
    """Widths along t and b, in the range that lobes have."""
    stretch = 1 - min(abs(a), 0.9999)
    widths = (alpha * stretch, alpha / stretch) if a >= 0 else (alpha / stretch, alpha * stretch)
    return tuple(min(max(m, 1e-4), 1.0) for m in widths)
