# SPDX-License-Identifier: GPL-3.0-or-later
"""The compositor node group "burnish": adds the overlay image to the render, and takes Cycles' own reflections out.

    Image + Tint * Gain * overlay - Replace * coverage * GlossCol * (GlossDir + GlossInd)
"""

import bpy

from . import images
from .scene import touched

NAME = "burnish"
_PASSES = ("GlossDir", "GlossInd", "GlossCol")


def link(scene, replaces):
    """Put the group between the scene's render layers and its composite; returns the node."""
    touched.change(scene, "use_nodes", True)
    tree = scene.node_tree
    node = _own_node(tree) or _inserted(tree)
    node.inputs["Replace"].default_value = float(replaces)
    return node


def unlink(scene):
    """Take it out again; returns whether it was there."""
    tree = scene.node_tree
    node = _own_node(tree) if tree else None
    if node is None:
        return False
    image, output = node.inputs["Image"], node.outputs["Image"]
    targets = [link.to_socket for link in output.links]
    for target in targets if image.links else ():
        tree.links.new(image.links[0].from_socket, target)
    tree.nodes.remove(node)
    if not any(_own_node(other.node_tree) for other in bpy.data.scenes if other.node_tree):
        bpy.data.node_groups.remove(bpy.data.node_groups[NAME])
    return True


def _own_node(tree):
    return next((node for node in tree.nodes if node.type == "GROUP" and node.node_tree and node.node_tree.name == NAME), None)


def _inserted(tree):
    layers = next((node for node in tree.nodes if node.type == "R_LAYERS"), None) or tree.nodes.new("CompositorNodeRLayers")
    target = next((node for node in tree.nodes if node.type == "COMPOSITE"), None) or tree.nodes.new("CompositorNodeComposite")
    node = tree.nodes.new("CompositorNodeGroup")
    node.node_tree = bpy.data.node_groups.get(NAME) or _group()
    node.location = target.location.x - 200, target.location.y
    feeding = target.inputs["Image"].links
    tree.links.new(feeding[0].from_socket if feeding else layers.outputs["Image"], node.inputs["Image"])
    for name in _PASSES:
        if name in layers.outputs:
            tree.links.new(layers.outputs[name], node.inputs[name])
    tree.links.new(node.outputs["Image"], target.inputs["Image"])
    return node


def _group():
    tree = bpy.data.node_groups.new(NAME, "CompositorNodeTree")
    for name in ("Image", "Tint", *_PASSES):
        _socket(tree, name, "NodeSocketColor", (1.0, 1.0, 1.0, 1.0) if name == "Tint" else (0.0, 0.0, 0.0, 1.0))
    for name, value in (("Gain", 1.0), ("Replace", 0.0)):
        _socket(tree, name, "NodeSocketFloat", value)
    _socket(tree, "Image", "NodeSocketColor", None, "OUTPUT")
    taken, given = tree.nodes.new("NodeGroupInput").outputs, tree.nodes.new("NodeGroupOutput").inputs
    overlay = tree.nodes.new("CompositorNodeImage")
    overlay.image = bpy.data.images.get(images.OVERLAY)
    weighted = _mix(tree, "MULTIPLY", _mix(tree, "MULTIPLY", overlay.outputs["Image"], taken["Tint"]), taken["Gain"])
    glossy = _mix(tree, "MULTIPLY", _mix(tree, "ADD", taken["GlossDir"], taken["GlossInd"]), taken["GlossCol"])
    removed = _mix(tree, "MULTIPLY", _mix(tree, "MULTIPLY", glossy, overlay.outputs["Alpha"]), taken["Replace"])
    tree.links.new(_mix(tree, "SUBTRACT", _mix(tree, "ADD", taken["Image"], weighted), removed), given["Image"])
    return tree


def _mix(tree, how, first, second):
    """A Mix node of two sockets; returns its result."""
    node = tree.nodes.new("CompositorNodeMixRGB")
    node.blend_type = how
    tree.links.new(first, node.inputs[1])
    tree.links.new(second, node.inputs[2])
    return node.outputs["Image"]


def _socket(tree, name, kind, value, side="INPUT"):
    if hasattr(tree, "interface"):  # Blender 4
        socket = tree.interface.new_socket(name=name, in_out=side, socket_type=kind)
    else:
        socket = (tree.inputs if side == "INPUT" else tree.outputs).new(kind, name)
    if value is not None:
        socket.default_value = value
