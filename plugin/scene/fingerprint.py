# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether nodes still compute what they did when a picture was made of them: a hash of all that they depend on.

Images count by name, file and size; those of a sequence also by the frame.
"""

from __future__ import annotations

import hashlib

import bpy

_LAYOUT = {prop.identifier for prop in bpy.types.Node.bl_rna.properties}


def of_world(world, frame):
    """Of a world in the current frame, as text."""
    found = [tuple(world.color), world.use_nodes]
    if world.use_nodes and world.node_tree:
        _add_tree(world.node_tree, found, set(), frame)
    return hashlib.sha256(repr(found).encode()).hexdigest()


def _add_tree(tree, found, seen, frame):
    if tree in seen:
        return
    seen.add(tree)
    for node in tree.nodes:
        found += [node.bl_idname, node.name, node.mute]
        _add_properties(node, found, frame, _LAYOUT)
        found += [_plain(socket.default_value) for socket in (*node.inputs, *node.outputs) if hasattr(socket, "default_value")]
        if node.type == "GROUP" and node.node_tree:
            _add_tree(node.node_tree, found, seen, frame)
    found += [(link.from_node.name, link.from_socket.identifier, link.to_node.name, link.to_socket.identifier) for link in tree.links]


def _add_properties(struct, found, frame, left_out=frozenset()):
    """What a node, or a ramp or curve of it, is set to."""
    for prop in struct.bl_rna.properties:
        value = getattr(struct, prop.identifier)
        if value is None or prop.identifier in left_out or prop.identifier == "rna_type":
            continue
        if prop.type == "COLLECTION":
            for item in value:
                _add_properties(item, found, frame)
        elif prop.type != "POINTER":
            found.append((prop.identifier, _plain(value)))
        elif isinstance(value, bpy.types.Image):
            moves = frame if value.source in ("SEQUENCE", "MOVIE") else 0
            found.append((value.name, value.filepath, value.colorspace_settings.name, tuple(value.size), moves))
        elif not isinstance(value, bpy.types.ID):
            _add_properties(value, found, frame)


def _plain(value):
    return tuple(_plain(part) for part in value) if hasattr(value, "__len__") and not isinstance(value, (str, set)) else value
