# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the scene's mirrors by itself: flat glossy surfaces that fill a good part of the picture, floors above all.

Only whole objects can be left out of a mirror's picture, so an object counts by the largest plane among its faces: all of a
floor, the top of a slab, but not the sides of a box.
"""

from __future__ import annotations

import dataclasses

import bpy
import numpy as np
from mathutils import Vector

from . import camera, layers, values

_FLAT = 1e-3  # of the object's size: how far faces may be off the plane
_LEAST_SHARE = 0.4  # of the object's faces that lie in the plane
_LEAST_AREA = 0.02  # of the picture
_ROUGHEST = 0.5  # roughness that still makes a mirror


@dataclasses.dataclass(frozen=True)
class Mirror:
    object_name: str
    point: tuple
    normal: tuple  # unit, towards the camera
    area: float  # share of the picture that it would fill if nothing stood before it
    material_name: str


def find_mirrors(scene):
    """Flat glossy surfaces in sight of the camera, the largest first.

    Returns
    -------
    list of Mirror
    """
    if scene.camera is None or scene.camera.type != "CAMERA" or scene.camera.data.type == "PANO":
        return []
    graph = bpy.context.evaluated_depsgraph_get()
    glossy = {}
    found = []
    for thing in scene.objects:
        if thing.type == "MESH" and not thing.hide_render and thing.visible_camera:
            mirror = _mirror(scene, thing.evaluated_get(graph), glossy)
            if mirror:
                found.append(mirror)
    return sorted(found, key=lambda mirror: -mirror.area)


def _mirror(scene, thing, glossy):
    eye = np.array(scene.camera.matrix_world.translation)
    plane = _largest_plane(thing, [_is_glossy(slot.material, glossy) for slot in thing.material_slots], eye)
    if plane is None:
        return None
    point, normal, own = plane
    area = sum(_seen_area(scene, [thing.matrix_world @ thing.data.vertices[i].co for i in face.vertices]) for face in own)
    if area < _LEAST_AREA:
        return None
    return Mirror(thing.name, tuple(point), tuple(normal), area, thing.material_slots[own[0].material_index].material.name)


def _is_glossy(material, known):
    if material is None:
        return False
    if material.name not in known:
        known[material.name] = any(values.typical(lobe.roughness) <= _ROUGHEST for lobe, _ in layers.plan(material).lobes)
    return known[material.name]


def _largest_plane(thing, is_glossy, eye):
    """(point, unit normal, faces) around the largest glossy face that the eye sees, world space; None: a small part of the object."""
    if not any(is_glossy) or not len(thing.data.polygons):
        return None
    area, normal, centre, slot = _in_world(thing)
    facing = ((eye - centre) * normal).sum(1)
    if facing.max() <= 0:  # a sheet, from behind
        normal, facing = -normal, -facing
    shines = np.array(is_glossy)[np.minimum(slot, len(is_glossy) - 1)] & (facing > 0)
    if not shines.any():
        return None
    largest = int(np.argmax(area * shines))
    n, c = normal[largest], centre[largest]
    reach = _FLAT * max(np.ptp(centre, axis=0).max(), np.sqrt(area.max()))
    in_plane = shines & (normal @ n > 1 - _FLAT) & (np.abs((centre - c) @ n) < reach)
    if area[in_plane].sum() < _LEAST_SHARE * area.sum():
        return None
    return Vector(c), Vector(n), [thing.data.polygons[int(i)] for i in np.flatnonzero(in_plane)]


def _in_world(thing):
    """Areas, unit normals, centres and material slots of an object's faces."""
    area, normal, centre = (_all(thing.data.polygons, name, width) for name, width in (("area", 1), ("normal", 3), ("center", 3)))
    slot = _all(thing.data.polygons, "material_index", 1, np.int32)
    matrix = np.array(thing.matrix_world, np.float64)
    turned = normal @ np.linalg.pinv(matrix[:3, :3])
    length = np.maximum(np.linalg.norm(turned, axis=1), 1e-30)
    stretch = abs(np.linalg.det(matrix[:3, :3])) * length
    return area[:, 0] * stretch, turned / length[:, None], centre @ matrix[:3, :3].T + matrix[:3, 3], slot[:, 0]


def _all(faces, name, width, kind=np.float32):
    numbers = np.empty(len(faces) * width, kind)
    faces.foreach_get(name, numbers)
    return numbers.reshape(-1, width)


def _seen_area(scene, corners):
    """Share of the picture that a polygon in world space fills."""
    to_clip = camera.projection_of(scene) @ scene.camera.matrix_world.normalized().inverted()
    polygon = [to_clip @ corner.to_4d() for corner in corners]
    for axis, sign in ((3, 0), (0, 1), (0, -1), (1, 1), (1, -1)):
        polygon = _clipped(polygon, lambda place: place.w - 1e-6 if sign == 0 else place.w + sign * place[axis])
    flat = [Vector((place.x / place.w, place.y / place.w)) for place in polygon]
    doubled = sum(one.x * other.y - one.y * other.x for one, other in zip(flat, flat[1:] + flat[:1]))
    return abs(doubled) / 2 / 4


def _clipped(polygon, inside):
    """The part of a polygon where `inside` is positive (Sutherland & Hodgman)."""
    kept = []
    for one, other in zip(polygon, polygon[1:] + polygon[:1]):
        a, b = inside(one), inside(other)
        if a > 0:
            kept.append(one)
        if (a > 0) != (b > 0):
            kept.append(one + (other - one) * (a / (a - b)))
    return kept
