# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pieces of mesh that shine evenly: ceiling panels, screens, windows; as area lights of a shot file.

One convex face whose material is an Emission with known colour and strength, on both sides or, mixed by Backfacing, in front. Its
radiance is colour times strength. What else shines is seen in baked lights only.
"""

from __future__ import annotations

import bpy
from mathutils import Vector

from . import links, values

_FLAT = 1e-3  # of the face's size


def glowing_faces(scene):
    """Area lights by the names of their objects."""
    graph = bpy.context.evaluated_depsgraph_get()
    lights = {}
    for thing in scene.objects:
        if thing.type != "MESH" or thing.hide_render or not thing.visible_glossy or not thing.material_slots:
            continue
        shine = _shine(thing.material_slots[0].material)
        corners = _face(thing.evaluated_get(graph)) if shine else None
        if corners:
            radiance, two_sided = shine
            shape = {"type": "area", "corners": [list(corner) for corner in corners], "blocks": True}
            lights[thing.name] = {**shape, "radiance": radiance, "two_sided": two_sided}
    return lights


def _shine(material):
    """(radiance, whether on both sides) of a material that does nothing else; None for others."""
    output = material.node_tree.get_output_node("CYCLES") if material and material.use_nodes and material.node_tree else None
    shader = links.source(links.Place(output.inputs["Surface"])) if output else None
    if shader is None:
        return None
    two_sided = shader.node.type != "MIX_SHADER"
    if not two_sided:
        factor, front, back = (links.source(links.Place(socket, shader.groups)) for socket in shader.node.inputs)
        if back or not factor or factor.node.type != "NEW_GEOMETRY" or factor.socket.name != "Backfacing":
            return None
        shader = front
    radiance = emission(shader)
    return ([float(part) for part in radiance], two_sided) if radiance and max(radiance) > 0 else None


def emission(shader):
    """Colour times strength of an Emission shader; None where it is none or its nodes make it uneven."""
    if shader is None or shader.node.type != "EMISSION":
        return None
    colour, strength = (links.value(shader.input(name)) for name in ("Color", "Strength"))
    if colour is None or strength is None:
        return None
    product = values.multiply(colour, strength)
    return values.channels(product) if values.is_known(product) else None


def _face(thing):
    """World-space corners of the one convex flat face of an object, counter-clockwise from its front; None where it has others."""
    mesh = thing.data
    if len(mesh.polygons) != 1:
        return None
    corners = [thing.matrix_world @ mesh.vertices[i].co for i in mesh.polygons[0].vertices]
    edges = [other - one for one, other in zip(corners, corners[1:] + corners[:1])]
    turns = [one.cross(other) for one, other in zip(edges, edges[1:] + edges[:1])]
    normal = sum(turns, Vector((0, 0, 0))).normalized()
    size = max(edge.length for edge in edges)
    is_flat = all(abs((corner - corners[0]).dot(normal)) < _FLAT * size for corner in corners)
    is_convex = all(turn.dot(normal) > 0 for turn in turns)
    return corners if is_flat and is_convex else None
