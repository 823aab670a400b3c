"""Node trees put together at random: whatever they are, they are read, prepared and given back, and never break anything."""

import json
import random

import bpy
from addon import OUT, ball, differences, empty_scene, everything

from burnish_addon.scene import materials, passes, touched

random.seed(8)
scene = empty_scene()
worn = ball("worn").data.materials


def kinds_of_nodes():
    """Shaders three times as often as others."""
    found, probe = [], bpy.data.node_groups.new("probe", "ShaderNodeTree")
    for name in dir(bpy.types):
        try:
            node = probe.nodes.new(name) if name.startswith("ShaderNode") else None
        except RuntimeError:  # base classes
            continue
        if node:
            found += [name] * (3 if any(output.type == "SHADER" for output in node.outputs) else 1)
    bpy.data.node_groups.remove(probe)
    return found


def fill(tree, kinds, end):
    for kind in random.choices(kinds, k=12):
        node = tree.nodes.new(kind)
        node.mute = random.random() < 0.08
        if hasattr(node, "distribution"):
            node.distribution = random.choice([item.identifier for item in node.bl_rna.properties["distribution"].enum_items])
        for socket in node.inputs:
            if socket.type == "VALUE":
                socket.default_value = random.choice((-1, 0, 0.5, 1, 2, random.random()))
    nodes = list(tree.nodes)
    for _ in range(36):
        one, other = sorted(random.sample(range(len(nodes)), 2))
        if nodes[one].outputs and nodes[other].inputs:
            tree.links.new(random.choice(nodes[one].outputs), random.choice(nodes[other].inputs))
    shaders = [output for node in nodes for output in node.outputs if output.type == "SHADER"]
    if shaders:
        tree.links.new(random.choice(shaders), end)


kinds, groups = kinds_of_nodes(), [None]
for index in range(6):
    group = bpy.data.node_groups.new(f"group {index}", "ShaderNodeTree")
    group.inputs.new("NodeSocketFloat", "number")
    group.outputs.new("NodeSocketShader", "shader")
    group.nodes.new("NodeGroupInput")
    fill(group, kinds, group.nodes.new("NodeGroupOutput").inputs[0])
    groups.append(group)
for index in range(80):
    made = bpy.data.materials.new(f"{index}")
    made.use_nodes = True
    made.node_tree.nodes.new("ShaderNodeGroup").node_tree = random.choice(groups)
    fill(made.node_tree, [*kinds, "NodeReroute"], made.node_tree.nodes["Material Output"].inputs["Surface"])
    worn.append(made)

everything()  # group nodes get a property of their own when they are first looked at
before, found = everything(), materials.read_materials(scene)
assert len(found.materials) > 20 and found.notes
assert passes.prepare(scene, scene.view_layers[0]) and passes.prepare(scene, scene.view_layers[0]) == []
assert materials.read_materials(scene).materials == found.materials
with open(f"{OUT}/materials.json", "w") as out:
    json.dump(found.materials, out)
touched.restore(scene)
assert differences(before, everything()) == [], "\n".join(differences(before, everything()))
print("CHECKED")
