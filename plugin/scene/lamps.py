# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene's lamps as area lights of a shot file, as bright as Cycles has them.

    area lamps    radiance = power / (4 area), from the side that shines; discs and ellipses as polygons of the same area
    suns          a disc of the same angle, far away: radiance = strength / (pi tan^2(angle / 2))
    points        a disc of the lamp's radius that faces the middle of the scene: radiance = power / (4 pi^2 radius^2)
    spots         as points, without their cone
"""

from __future__ import annotations

import dataclasses
import math

from mathutils import Vector

from . import links, values
from .glowing import emission, glowing_faces

_SIDES = 16  # of a polygon that stands for a disc
_SMALLEST_SUN, _SMALLEST_RADIUS = math.radians(0.25), 1e-3
_SUN_DISTANCE = 1e4


@dataclasses.dataclass
class Lamps:
    """Lights by name, and what of the scene's lamps they do not show."""

    lights: dict
    notes: list


def read_lamps(scene):
    """The lamps that glossy rays see, and flat pieces of mesh that shine, as lights of a shot file; named like their objects."""
    lamps = Lamps(glowing_faces(scene), [])
    for thing in scene.objects:
        if thing.type == "LIGHT" and not thing.hide_render and thing.visible_glossy:
            emitted = _emitted(thing, lamps.notes)
            if emitted and max(emitted) > 0:
                _add(lamps, scene, thing, emitted)
    return lamps


def _add(lamps, scene, thing, emitted):
    lamp = thing.data
    if lamp.type == "AREA":
        if getattr(lamp.cycles, "is_portal", False):
            return
        if lamp.spread < math.radians(179.9):
            lamps.notes.append(f"{thing.name}: its spread of {math.degrees(lamp.spread):.0f} degrees is not followed")
        corners = _area_corners(thing)
        area = _area(corners)
        brightness = 1 / (4 * area) if area > 0 else 0.0
    elif lamp.type == "SUN":
        corners, brightness = _sun(thing)
    else:
        corners, brightness = _ball(scene, thing)
        lamps.notes.append(f"{thing.name}: a {lamp.type.lower()} lamp; its highlight is that of a disc that faces the scene")
    radiance = [part * brightness for part in emitted]
    lamps.lights[thing.name] = {"type": "area", "corners": [list(corner) for corner in corners], "radiance": radiance}
    if lamp.type in ("POINT", "SPOT"):
        lamps.lights[thing.name]["two_sided"] = True


def _emitted(thing, notes):
    """Power (of a sun: strength) in each channel; None where nodes make it uneven."""
    lamp = thing.data
    power = tuple(part * lamp.energy for part in lamp.color)
    output = lamp.node_tree.get_output_node("CYCLES") if lamp.use_nodes and lamp.node_tree else None
    if output is None:
        return power
    shader = links.source(links.Place(output.inputs["Surface"]))
    factor = emission(shader)
    if shader and factor is None:
        notes.append(f"{thing.name}: its nodes make it uneven; it is left out")
    return values.multiply(power, factor) if factor else None


def _area_corners(thing):
    """Counter-clockwise as seen from the side that shines, which is -Z."""
    lamp = thing.data
    x = lamp.size / 2
    y = (lamp.size_y if lamp.shape in ("RECTANGLE", "ELLIPSE") else lamp.size) / 2
    if lamp.shape in ("SQUARE", "RECTANGLE"):
        outline = [(-x, -y), (-x, y), (x, y), (x, -y)]
    else:
        outline = [(x * part.x, -y * part.y) for part in _disc(1.0)]
    return [thing.matrix_world @ Vector((*place, 0)) for place in outline]


def _disc(radius):
    """Corners of a polygon with a disc's area, counter-clockwise."""
    step = 2 * math.pi / _SIDES
    reach = radius * math.sqrt(step / math.sin(step))
    return [Vector((math.cos(i * step), math.sin(i * step))) * reach for i in range(_SIDES)]


def _area(corners):
    total = Vector((0, 0, 0))
    for one, other in zip(corners, corners[1:] + corners[:1]):
        total += one.cross(other)
    return total.length / 2


def _facing(centre, direction, radius):
    """A disc around a place that shines along a direction."""
    turn = direction.to_track_quat("Z", "Y").to_matrix()
    return [centre + turn @ part.to_3d() for part in _disc(radius)]


def _sun(thing):
    direction = -thing.matrix_world.col[2].xyz.normalized()
    tangent = math.tan(max(thing.data.angle, _SMALLEST_SUN) / 2)
    corners = _facing(-direction * _SUN_DISTANCE, direction, _SUN_DISTANCE * tangent)
    return corners, 1 / (math.pi * tangent**2)


def _ball(scene, thing):
    radius = max(thing.data.shadow_soft_size, _SMALLEST_RADIUS)
    places = [other.matrix_world.translation for other in scene.objects if other.type == "MESH" and not other.hide_render]
    centre = thing.matrix_world.translation
    towards = sum(places, Vector((0, 0, 0))) / max(len(places), 1) - centre
    return _facing(centre, towards.normalized() if towards.length > 0 else Vector((0, 0, -1)), radius), 1 / (4 * math.pi**2 * radius**2)
