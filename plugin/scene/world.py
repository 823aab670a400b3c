# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene's world as burnish's environment map.

A background that is a picture (an EXR or HDR in linear colour, lat-long, turned about Z, as bright and tinted as one likes) is
taken as it is. Every other world that shines is baked: Cycles renders it to a lat-long picture, as glossy rays see it.
"""

from __future__ import annotations

import dataclasses
import math

from mathutils import Euler

from . import links, values, world_picture


@dataclasses.dataclass
class World:
    """Settings of burnish by name, and what the user should know of them. No settings: there is no such light."""

    settings: dict
    notes: list


@dataclasses.dataclass(frozen=True)
class _Background:
    image: object
    tint: tuple
    turn: float  # degrees


def read_world(scene, folder):
    """The environment that glossy rays see.

    Parameters
    ----------
    scene : bpy.types.Scene
    folder : str
        Where pictures that have no file of their own go; made if need be.

    Returns
    -------
    World
        Settings env, env_convention, up, and env_rotate, env_scale, env_tint where they are not neutral.
    """
    world = scene.world
    if world is None:
        return World({}, ["the scene has no world"])
    if not world.cycles_visibility.glossy:
        return World({}, [f"{world.name}: hidden from glossy rays"])
    common = {"env_convention": "blender", "up": "z"}
    background = _background(world)
    if background == 0.0:
        return World({}, [f"{world.name}: black"])
    file = world_picture.file_of(background.image, folder) if isinstance(background, _Background) else None
    if file is None:
        file = world_picture.bake(scene, folder, is_even=isinstance(background, tuple))
        return World({"env": file, **common}, [f"{world.name}: rendered to a picture"])
    scale = max(background.tint)
    settings = {"env": file, **common}
    if background.turn:
        settings["env_rotate"] = background.turn
    if scale != 1:
        settings["env_scale"] = scale
    if min(background.tint) != scale:
        settings["env_tint"] = [part / scale for part in background.tint]
    return World(settings, [])


def _background(world):
    """A _Background for a plain picture, 0.0 for a black world, a colour for an even one, None for anything else."""
    if not world.use_nodes or world.node_tree is None:
        return tuple(world.color)[:3] if max(world.color) > 0 else 0.0
    output = world.node_tree.get_output_node("CYCLES")
    shader = links.source(links.Place(output.inputs["Surface"])) if output else None
    if shader is None:
        return 0.0
    if shader.node.type != "BACKGROUND":
        return None
    strength = links.value(shader.input("Strength"), links.REFLECTED)
    if not isinstance(strength, float):
        return None
    return 0.0 if strength <= 0 else _picture(shader.input("Color"), strength)


def _picture(place, factor):
    """A colour socket times a factor (number or colour), as for `_background`."""
    found = links.source(place)
    if found is None:
        colour = values.multiply(values.channels(links.value(place, links.REFLECTED)), factor)
        return 0.0 if max(values.channels(colour)) <= 0 else values.channels(colour)
    if found.node.type == "TEX_ENVIRONMENT":
        turn = _turn(found)
        image = found.node.image
        return None if turn is None or image is None else _Background(image, values.channels(factor), turn)
    return _product(found, factor)


def _product(found, factor):
    """Of a node that multiplies a picture by a known colour; None for other nodes."""
    node = found.node
    sockets = [socket for socket in node.inputs if socket.type == "RGBA" and socket.enabled]
    is_mix = node.type == "MIX_RGB" or (node.type == "MIX" and node.data_type == "RGBA" and not node.clamp_result)
    if not is_mix or node.blend_type != "MULTIPLY" or len(sockets) != 2 or getattr(node, "use_clamp", False):
        return None
    if links.value(found.input("Fac", "Factor_Float")) != 1:
        return None
    for one, other in (sockets, sockets[::-1]):
        colour = links.value(links.Place(one, found.groups))
        if isinstance(colour, tuple):
            return _picture(links.Place(other, found.groups), values.multiply(colour, factor))
    return None


def _turn(texture):
    """Degrees about Z that the picture is turned by; None where it is bent or moved otherwise, or is no lat-long."""
    if texture.node.projection != "EQUIRECTANGULAR":
        return None
    mapping = links.source(texture.input("Vector"))
    if mapping is None or _is_direction(mapping):
        return 0.0
    vector = mapping.node.type == "MAPPING" and links.source(mapping.input("Vector"))
    if not vector or not _is_direction(vector):
        return None
    location, rotation, scale = (links.value(mapping.input(name)) if mapping.input(name) else default for name, default in
                                 (("Location", (0, 0, 0)), ("Rotation", (0, 0, 0)), ("Scale", (1, 1, 1))))
    if not all(values.is_known(value) for value in (location, rotation, scale)) or any(location) or len(set(scale)) != 1 or scale[0] <= 0:
        return None
    matrix = Euler(rotation).to_matrix()
    if abs(matrix[2][2] - 1) > 1e-6:
        return None
    turn = math.degrees(math.atan2(matrix[1][0], matrix[0][0]))
    return -turn if mapping.node.vector_type == "TEXTURE" else turn


def _is_direction(place):
    return place.node.type == "TEX_COORD" and place.socket.name == "Generated"
