"""Materials as burnish's: the numbers of each kind of shader, what comes from layers, and what is told instead."""

import math

import bpy
from addon import add, ball, blotches, empty_scene, material

from burnish_addon.scene import layers, materials, passes

scene = empty_scene()


def lobes(made):
    """The lobes' JSON, and the notes; the material worn by a new object."""
    ball(made.name, made)
    wardrobe = materials.read_materials(scene)
    notes = [note.split(": ", 1)[1] for note in wardrobe.notes if note.startswith(made.name + ": ") and "pass index" not in note]
    return wardrobe.materials.get(made.name, {"lobes": []})["lobes"], notes


def near(lobe, **expected):
    for key, value in expected.items():
        assert key in lobe, (key, lobe)
        found = lobe[key] if isinstance(lobe[key], (list, str)) else [lobe[key]]
        wanted = value if isinstance(value, (list, str)) else [value]
        assert found == wanted or all(abs(a - b) < 1e-4 for a, b in zip(found, wanted, strict=True)), (key, lobe)


# One lobe each.
(glossy,), notes = lobes(material("glossy", "Glossy", "GGX", Color=(0.9, 0.6, 0.3), Roughness=0.3)[0])
near(glossy, model="ggx", roughness=0.3, tint=[0.9, 0.6, 0.3])
assert not notes and not {"ior", "r0", "per_pixel", "anisotropy"} & glossy.keys()
(sharp,), _ = lobes(material("sharp", "Glossy", "SHARP", Roughness=0.3)[0])
near(sharp, roughness=0)
(beckmann,), _ = lobes(material("beckmann", "Glossy", "BECKMANN", Roughness=0.5)[0])
near(beckmann, model="beckmann", roughness=0.5)
(brushed,), _ = lobes(material("brushed", "Anisotropic", "GGX", Roughness=0.4, Anisotropy=0.7, Rotation=0.125)[0])
near(brushed, anisotropy=0.7, rotation_deg=45)
(pane,), notes = lobes(material("pane", "Glass", "SHARP", Color=(0.5, 1.0, 1.0), IOR=1.45)[0])
near(pane, ior=1.45, tint=[0.5, 1, 1])
assert ["stays as rendered" in note for note in notes] == [True]

# Principled.
(plastic,), notes = lobes(material("plastic", "Principled", "GGX", Roughness=0.2, Specular=0.25)[0])
near(plastic, ior=2 / (1 - math.sqrt(0.02)) - 1, roughness=0.2)
(gold,), _ = lobes(material("gold", "Principled", "GGX", Base_Color=(1.0, 0.8, 0.5), Metallic=1.0)[0])
near(gold, r0=[1, 0.8, 0.5], roughness=0.5)
base, coat, tail = lobes(material("coated", "Principled", "GGX", Clearcoat=1.0, Clearcoat_Roughness=0.1)[0])[0]
near(coat, ks=0.25, ior=1.5, roughness=0.1)
(aluminium,), _ = lobes(material("aluminium", "Principled", "GGX", Metallic=1.0, Anisotropic=0.8, Anisotropic_Rotation=0.25)[0])
aspect = math.sqrt(1 - 0.9 * 0.8)
near(aluminium, anisotropy=aspect - 1, rotation_deg=90)
assert lobes(material("dull", "Principled", "GGX", Specular=0.0)[0]) == ([], [])
assert lobes(material("chalk", "Diffuse")[0]) == ([], [])
assert "no lobe" in lobes(material("cloth", "Velvet")[0])[1][0]


# Trees: a mix by a number, by rays, by Fresnel; through a reroute, a muted node and a group.
def mixed(name, factor, roughness=0.1):
    made, output = material(name)
    tree = made.node_tree
    mix, glossy, diffuse = (tree.nodes.new(kind) for kind in ("ShaderNodeMixShader", "ShaderNodeBsdfGlossy", "ShaderNodeBsdfDiffuse"))
    glossy.inputs["Roughness"].default_value = roughness
    tree.links.new(diffuse.outputs[0], mix.inputs[1])
    tree.links.new(glossy.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], output.inputs["Surface"])
    source = factor(tree)
    if isinstance(source, float):
        mix.inputs[0].default_value = source
    else:
        tree.links.new(source, mix.inputs[0])
    return made


def rerouted(tree):
    number, muted, reroute = (tree.nodes.new(kind) for kind in ("ShaderNodeValue", "ShaderNodeGamma", "NodeReroute"))
    number.outputs[0].default_value = 0.25
    muted.mute = True
    tree.links.new(number.outputs[0], muted.inputs["Color"])
    tree.links.new(muted.outputs[0], reroute.inputs[0])
    return reroute.outputs[0]


near(lobes(mixed("third", lambda tree: 0.3))[0][0], tint=[0.24, 0.24, 0.24])
near(lobes(mixed("rerouted", rerouted))[0][0], tint=[0.2, 0.2, 0.2])
near(lobes(mixed("camera only", lambda tree: tree.nodes.new("ShaderNodeLightPath").outputs["Is Camera Ray"]))[0][0], tint=[0.8, 0.8, 0.8])
assert lobes(mixed("never", lambda tree: tree.nodes.new("ShaderNodeLightPath").outputs["Is Shadow Ray"])) == ([], [])
near(lobes(mixed("polished", lambda tree: tree.nodes.new("ShaderNodeFresnel").outputs[0]))[0][0], ior=1.45)
(waxed,), _ = lobes(mixed("waxed", lambda tree: tree.nodes.new("ShaderNodeFresnel").outputs[0], roughness=0.5))
near(waxed, per_pixel=["weight"], tint=[0.8, 0.8, 0.8])
assert "ior" not in waxed
near(lobes(mixed("layered", lambda tree: tree.nodes.new("ShaderNodeLayerWeight").outputs["Fresnel"]))[0][0], ior=2)

group = bpy.data.node_groups.new("shine", "ShaderNodeTree")
group.inputs.new("NodeSocketFloat", "Shine").default_value = 0.5
group.outputs.new("NodeSocketShader", "BSDF")
inside, outside = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput")
shader = group.nodes.new("ShaderNodeBsdfGlossy")
group.links.new(inside.outputs[0], shader.inputs["Roughness"])
group.links.new(blotches(group, (1, 0, 0), (0, 1, 0)), shader.inputs["Color"])
group.links.new(shader.outputs[0], outside.inputs[0])
grouped, output = material("grouped")
node = grouped.node_tree.nodes.new("ShaderNodeGroup")
node.node_tree = group
node.inputs[0].default_value = 0.35
grouped.node_tree.links.new(node.outputs[0], output.inputs["Surface"])
(lobe,), notes = lobes(grouped)
near(lobe, roughness=0.35)
assert ["Color: comes from inside a node group" in note for note in notes] == [True]

# Textures go to layers, the first that needs one has it.
rusty, shader = material("rusty", "Principled", "GGX", Roughness=0.4)
rusty.node_tree.links.new(blotches(rusty.node_tree, 0.1, 0.6), shader.inputs["Roughness"])
rusty.node_tree.links.new(blotches(rusty.node_tree, (1, 0, 0), (0, 1, 0)), shader.inputs["Base Color"])
rusty.node_tree.links.new(blotches(rusty.node_tree, 0.0, 1.0), shader.inputs["Metallic"])
(flat, grazing), notes = lobes(rusty)
near(flat, per_pixel=["roughness", "tint"])
near(grazing, per_pixel=["roughness", "weight"], ior=1.5)
assert not notes and set(layers.plan(rusty).layers) == {"roughness", "tint", "weight"}

two, _ = material("two")
tree = two.node_tree
shaders = [tree.nodes.new("ShaderNodeBsdfGlossy") for _ in range(2)]
add_shader = tree.nodes.new("ShaderNodeAddShader")
for index, shader in enumerate(shaders):
    tree.links.new(blotches(tree, 0.1, 0.5), shader.inputs["Roughness"])
    tree.links.new(shader.outputs[0], add_shader.inputs[index])
tree.links.new(add_shader.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
shaders[1].inputs["Roughness"].default_value = 0.33
(first, second), notes = lobes(two)
near(first, per_pixel=["roughness"])
near(second, roughness=0.33)
assert notes == ["Glossy BSDF.001, Roughness: another lobe of the material has the layer Roughness; 0.33 is used"], notes

# Worn by geometry nodes, and by an instance.
nodes = bpy.data.node_groups.new("dress", "GeometryNodeTree")
nodes.nodes.new("GeometryNodeSetMaterial").inputs["Material"].default_value = material("by nodes", "Glossy")[0]
ball("dressed").modifiers.new("dress", "NODES").node_group = nodes
library = bpy.data.collections.new("library")
library.objects.link(bpy.data.objects.new("original", bpy.data.meshes.new("original")))
library.objects["original"].data.materials.append(material("instanced", "Glossy")[0])
instance = add("instance", None)
instance.instance_type, instance.instance_collection = "COLLECTION", library
assert {"by nodes", "instanced"} <= materials.read_materials(scene).materials.keys()

# Rules: by index while that is all there is, by cryptomatte once prepared; hidden objects and odd names.
ball("hidden", material("unseen", "Glossy")[0]).hide_render = True
ball("odd", material("odd, *name?", "Glossy")[0])
assert "unseen" not in materials.read_materials(scene).materials
assert not materials.read_materials(scene).assign
scene.view_layers[0].use_pass_material_index = True
bpy.data.materials["gold"].pass_index = 7
assert materials.read_materials(scene).assign == [{"material": "gold", "material_index": 7}]
passes.prepare(scene, scene.view_layers[0])
rules = {rule["material"]: rule for rule in materials.read_materials(scene).assign}
assert rules["gold"]["cryptomatte"] == "CryptoMaterial:gold"
assert rules["odd, *name?"]["cryptomatte"] == "CryptoMaterial:odd\\, \\*name\\?"
print("CHECKED")
