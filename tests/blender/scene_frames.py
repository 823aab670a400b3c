"""Frames that Cycles renders, with what the add-on makes of their scenes: test_addon_scene.py lets burnish reproduce them."""

import json
import math
import os

import bpy
import numpy as np
from addon import OUT, add, ball, blotches, empty_scene, material
from mathutils import Vector

from burnish_addon.scene import bake, camera, lamps, materials, mirrors, passes, world

SHOTS = {}


def picture(folder, width=128):
    """A lat-long EXR with soft lights of several colours."""
    v, u = np.mgrid[0:width // 2, 0:width] + 0.5
    u, v = u / width, v / (width // 2)
    sky = np.ones((width // 2, width, 4), np.float32)
    sky[..., 0] = 0.3 + 0.25 * np.cos(2 * np.pi * u) + 3 * np.exp(-((u - 0.3) ** 2 + (v - 0.6) ** 2) / 0.01)
    sky[..., 1] = 0.4 + 0.2 * np.cos(4 * np.pi * u) * v + 3 * np.exp(-((u - 0.7) ** 2 + (v - 0.7) ** 2) / 0.01)
    sky[..., 2] = 0.3 + 0.4 * v + 3 * np.exp(-((u - 0.7) ** 2 + (v - 0.4) ** 2) / 0.02)
    image = bpy.data.images.new("sky", width, width // 2, float_buffer=True)
    image.pixels.foreach_set(sky.ravel())
    image.filepath_raw, image.file_format = os.path.join(folder, "sky.exr"), "OPEN_EXR"
    image.save()
    bpy.data.images.remove(image)
    loaded = bpy.data.images.load(os.path.join(folder, "sky.exr"))
    loaded.colorspace_settings.name = "Linear"
    return loaded


def lit_by_picture(scene, folder, turn=(0, 0, 0), strength=1.0, tint=None):
    """Nodes for a world that is a picture; returns its Background."""
    tree = scene.world.node_tree
    place, mapping, texture = (tree.nodes.new("ShaderNode" + kind) for kind in ("TexCoord", "Mapping", "TexEnvironment"))
    texture.image, mapping.inputs["Rotation"].default_value = picture(folder), turn
    tree.links.new(place.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs[0], texture.inputs["Vector"])
    background, colour = tree.nodes["Background"], texture.outputs[0]
    background.inputs["Strength"].default_value = strength
    if tint:
        product = tree.nodes.new("ShaderNodeMixRGB")
        product.blend_type, product.inputs["Fac"].default_value = "MULTIPLY", 1.0
        product.inputs["Color2"].default_value = (*tint, 1)
        tree.links.new(colour, product.inputs["Color1"])
        colour = product.outputs[0]
    tree.links.new(colour, background.inputs["Color"])
    return background


def shoot(name, scene, folder, lights=None):
    """Prepare, render, and keep the shot that the add-on's parts make."""
    passes.prepare(scene, scene.view_layers[0])
    scene.render.filepath = os.path.join(folder, "frame.exr")
    bpy.context.view_layer.update()
    wardrobe, sky, found = materials.read_materials(scene), world.read_world(scene, folder), lamps.read_lamps(scene)
    shot = {"aovs": scene.render.filepath, "materials": wardrobe.materials, "assign": wardrobe.assign, "camera": camera.read_camera(scene)}
    SHOTS[name] = {"shot": {**shot, "lights": {**(lights or {}), **found.lights}, **sky.settings},
                   "notes": {"world": sky.notes, "lamps": found.notes, "materials": wardrobe.notes}}
    SHOTS[name]["objects"] = ["ball"]
    bpy.ops.render.render(write_still=True)


def folder_of(name):
    folder = os.path.join(OUT, name)
    os.makedirs(folder)
    return folder


def sheet():
    """Materials on balls, four in a row."""
    scene, folder = empty_scene(160, 80, samples=192), folder_of("sheet")
    scene.camera.data.sensor_width, scene.camera.data.lens = 4, 6
    lit_by_picture(scene, folder, turn=(0, 0, 0.5))
    rough, shader = material("textured roughness", "Glossy", "GGX", Color=(0.9, 0.6, 0.3))
    rough.node_tree.links.new(blotches(rough.node_tree, 0.2, 0.6), shader.inputs["Roughness"])
    textured, shader = material("textured principled", "Principled", "GGX", Roughness=0.3)
    textured.node_tree.links.new(blotches(textured.node_tree, (0.9, 0.7, 0.1), (0.1, 0.1, 0.9)), shader.inputs["Base Color"])
    textured.node_tree.links.new(blotches(textured.node_tree, 0.0, 1.0), shader.inputs["Metallic"])
    made = [material("glossy ggx", "Glossy", "GGX", Color=(0.9, 0.6, 0.3), Roughness=0.3)[0],
            material("glossy beckmann", "Glossy", "BECKMANN", Color=(0.4, 0.7, 0.9), Roughness=0.35)[0],
            material("anisotropic", "Anisotropic", "GGX", Roughness=0.35, Anisotropy=0.5, Rotation=0.125)[0],
            material("dielectric", "Principled", "GGX", Base_Color=(0.8, 0.1, 0.1), Roughness=0.25)[0],
            material("metallic", "Principled", "GGX", Base_Color=(0.9, 0.6, 0.2), Roughness=0.3, Metallic=1.0)[0],
            material("clearcoat", "Principled", "GGX", Roughness=0.5, Clearcoat=1.0, Clearcoat_Roughness=0.1)[0], rough, textured]
    for index, each in enumerate(made):
        ball(each.name, each, (index % 4 - 1.5, 0, 0.5 - index // 4), radius=0.46).pass_index = index + 1
    shoot("sheet", scene, folder)
    SHOTS["sheet"]["objects"] = [each.name for each in made]


def one_ball(name, roughness=0.3, samples=64):
    scene = empty_scene(48, 48, samples)
    scene.camera.data.lens = 90
    ball("ball", material("shiny", "Glossy", "GGX", Color=(1.0, 1.0, 1.0), Roughness=roughness)[0]).pass_index = 1
    return scene, folder_of(name)


def worlds():
    for name, options in {"turned": {"turn": (0, 0, 1.0), "strength": 1.5, "tint": (1, 0.5, 0.25)}, "bent": {"turn": (0.7, 0, 0)}}.items():
        scene, folder = one_ball(name)
        lit_by_picture(scene, folder, **options)
        shoot(name, scene, folder)
    scene, folder = one_ball("packed")
    lit_by_picture(scene, folder)
    bpy.data.images["sky.exr"].pack()
    os.remove(os.path.join(folder, "sky.exr"))
    shoot("packed", scene, folder)
    scene, folder = one_ball("by rays")  # black for the camera, white for what is reflected
    tree = scene.world.node_tree
    background, path = tree.nodes["Background"], tree.nodes.new("ShaderNodeLightPath")
    tree.links.new(path.outputs["Is Glossy Ray"], background.inputs["Strength"])
    shoot("by rays", scene, folder)


def lamp(kind, **numbers):
    data = bpy.data.lights.new(kind, kind)
    for word, number in numbers.items():
        setattr(data, word, number)
    place = Vector((2, -3, 3))
    thing = add(kind, data, place)
    thing.rotation_euler = (-place).to_track_quat("-Z", "Y").to_euler()
    return thing


def lit_by_lamps():
    for name, kind, numbers in (("rectangle", "AREA", {"shape": "RECTANGLE", "size": 1.5, "size_y": 0.6}),
                                ("disk", "AREA", {"shape": "DISK", "size": 1.2}), ("sun", "SUN", {"angle": 0.2})):
        scene, folder = one_ball(name, roughness=0.4)
        scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0
        lamp(kind, energy=3 if kind == "SUN" else 200, color=(1, 0.8, 0.5), **numbers)
        shoot(name, scene, folder)


def room():
    """A polished floor and a ball in a box with coloured walls; the mirror and the cube map are baked."""
    scene, folder = empty_scene(80, 45, samples=64), folder_of("room")
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0
    scene.camera.location, scene.camera.data.lens, scene.camera.data.shift_y = (0, -3.5, 1), 28, -0.1
    right_angle = math.pi / 2
    for name, colour, place, turn in (("floor", None, (0, 0, 0), (0, 0, 0)), ("ceiling", (0.8, 0.8, 0.8), (0, 0, 3), (math.pi, 0, 0)),
                                      ("left", (0.7, 0.1, 0.1), (-2, 0, 1.5), (0, right_angle, 0)),
                                      ("right", (0.1, 0.6, 0.1), (2, 0, 1.5), (0, -right_angle, 0)),
                                      ("back", (0.5, 0.5, 0.7), (0, 2, 1.5), (right_angle, 0, 0))):
        bpy.ops.mesh.primitive_plane_add(size=8 if name in ("floor", "ceiling") else 4, location=place, rotation=turn)
        bpy.context.object.name, bpy.context.object.pass_index = name, name == "floor"
        polished = {"Color": (0.6, 0.6, 0.6), "Roughness": 0.15}
        made, _ = material(name, "Diffuse", Color=colour) if colour else material(name, "Glossy", "GGX", **polished)
        bpy.context.object.data.materials.append(made)
    chrome, _ = material("chrome", "Glossy", "GGX", Color=(0.9, 0.9, 0.9), Roughness=0.25)
    ball("ball", chrome, (0.5, 0.2, 0.6), 0.5, camera_only=False).pass_index = 2
    shine = material("shine", "Diffuse", Color=(0.8, 0.8, 0.8))[0]
    glow = shine.node_tree.nodes.new("ShaderNodeEmission")
    glow.inputs["Strength"].default_value = 6
    shine.node_tree.links.new(glow.outputs[0], shine.node_tree.nodes["Material Output"].inputs["Surface"])
    bpy.ops.mesh.primitive_plane_add(size=1.5, location=(0, 0, 2.98), rotation=(math.pi, 0, 0))
    bpy.context.object.name = "panel"
    bpy.context.object.data.materials.append(shine)
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, -5))  # wholly behind the mirror: it must not stand before it
    bpy.context.view_layer.update()
    found = mirrors.find_mirrors(scene)
    assert [mirror.object_name for mirror in found] == ["floor"] and found[0].normal == (0, 0, 1), found
    cube = bake.bake_cube(scene, "ball", folder, size=64, samples=32)
    shoot("room", scene, folder, {"mirror": bake.bake_mirror(scene, found[0], folder, samples=32), "cube": cube})
    SHOTS["room"]["objects"] = ["floor", "ball"]


sheet()
worlds()
lit_by_lamps()
room()
with open(os.path.join(OUT, "shots.json"), "w") as out:
    json.dump(SHOTS, out)
print("CHECKED")
