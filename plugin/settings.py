# SPDX-License-Identifier: GPL-3.0-or-later
"""burnish's settings as Blender properties, out of the table `burnish.settings()`: no default, range or help text of our own."""

import functools

import bpy

from . import package

# What a scene offers; the rest of a shot comes from the scene itself.
OFFERED = ("psnr", "estimator", "samples", "density", "safety", "mode", "edge_coverage", "env_rotate", "env_scale", "env_tint",
           "gain", "tint", "pixel_type", "threads")
# What shows at once in the images of the last composite.
LIVE = ("env_rotate", "env_scale", "env_tint", "gain", "tint")
_SOFT_MAX = {"env_scale": 10.0, "gain": 4.0, "safety": 4.0, "samples": 64, "threads": 16}


@functools.cache
def table():
    """Name -> setting, of those that are offered; nothing where there is no burnish."""
    burnish = package.load()
    return {s["name"]: s for s in burnish.settings() if s["name"] in OFFERED} if burnish else {}


def properties(update):
    """Name -> Blender property; `update` is called by those that are live."""
    return {name: _property(setting, update if name in LIVE else None) for name, setting in table().items()}


def values(group, live):
    """What differs from burnish's own defaults, of the live settings or of the others, by name as the shot file spells it."""
    found = {name: _value(getattr(group, name)) for name in table() if (name in LIVE) == live}
    return {name: value for name, value in found.items() if not _same(value, table()[name]["default"])}


def live_values(group):
    """All that are live."""
    return {name: _value(getattr(group, name)) for name in LIVE}


def _property(setting, update):
    default, choices = setting["default"], setting["choices"]
    words = {"name": setting["name"].replace("_", " ").capitalize(), "description": _help(setting), "update": update}
    if choices:
        items = [(choice, choice.replace("_", " ").capitalize(), "") for choice in choices]
        return bpy.props.EnumProperty(items=items, default=default, **words)
    if isinstance(default, bool):
        return bpy.props.BoolProperty(default=default, **words)
    if isinstance(default, list):
        return bpy.props.FloatVectorProperty(subtype="COLOR", size=3, default=default, soft_max=1.0, **_range(setting), **words)
    number = bpy.props.IntProperty if isinstance(default, int) else bpy.props.FloatProperty
    return number(default=default, **_range(setting), **words)


def _help(setting):
    """The help text with its unit; Blender adds the full stop."""
    text = setting["help"][:1].upper() + setting["help"][1:]
    return f"{text} ({setting['unit']})" if setting["unit"] else text


def _range(setting):
    kind = int if isinstance(setting["default"], int) else float
    limits = {side: kind(setting[side]) for side in ("min", "max") if setting[side] is not None}
    if setting["name"] in _SOFT_MAX:
        limits["soft_max"] = _SOFT_MAX[setting["name"]]
    return limits


def _value(value):
    return value if isinstance(value, (bool, int, float, str)) else list(value)


def _same(value, default):
    """Blender keeps single precision."""
    if isinstance(default, list):
        return all(_same(a, b) for a, b in zip(value, default))
    return abs(value - default) < 1e-6 if isinstance(default, float) else value == default
