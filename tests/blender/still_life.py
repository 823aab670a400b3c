"""A still life for the picture in the docs, made in Blender: brushed steel, gold and lacquer on a dull table.

Reflections see the world alone, so that they can be compared with those that burnish makes of it.
"""

import math
import pathlib

import bpy

HDRI = pathlib.Path(bpy.utils.system_resource("DATAFILES")) / "studiolights" / "world" / "interior.exr"


def build(_folder, width, height, samples):
    """An empty file with the scene in it; returns the scene."""
    bpy.ops.wm.read_homefile(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = samples, False, False
    scene.cycles.sample_clamp_indirect = 0
    _world(scene)
    _camera(scene)
    bpy.ops.mesh.primitive_plane_add(size=60)
    _wear("table", **{"Base Color": (0.16, 0.13, 0.11, 1), "Roughness": 1.0, "Specular": 0.0})
    bpy.context.view_layer.objects.active.visible_shadow = False
    bpy.ops.mesh.primitive_monkey_add(size=1.9, location=(0, 0.3, 0.95), rotation=(math.radians(-12), 0, math.radians(8)))
    _smooth(2)
    _wear("gold", **{"Base Color": (1.0, 0.72, 0.3, 1), "Metallic": 1.0, "Roughness": 0.28})
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=0.8, location=(-2.1, 0, 0.8))
    _smooth(0)
    _wear("steel", **{"Base Color": (0.75, 0.76, 0.78, 1), "Metallic": 1.0, "Roughness": 0.35, "Anisotropic": 0.6})
    bpy.ops.mesh.primitive_torus_add(major_radius=0.62, minor_radius=0.27, major_segments=128, minor_segments=64, location=(2.1, 0, 0.75),
                                     rotation=(math.radians(70), 0, math.radians(-25)))
    _smooth(0)
    _wear("lacquer", **{"Base Color": (0.45, 0.02, 0.03, 1), "Roughness": 0.12})
    return scene


def _world(scene):
    scene.world = bpy.data.worlds.new("interior")
    scene.world.use_nodes = True
    nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(str(HDRI))
    links.new(picture.outputs["Color"], nodes["Background"].inputs["Color"])


def _camera(scene):
    data = bpy.data.cameras.new("camera")
    data.lens = 50
    camera = bpy.data.objects.new("camera", data)
    scene.collection.objects.link(camera)
    camera.location, camera.rotation_euler = (0, -7.6, 2.6), (math.radians(77), 0, 0)
    scene.camera = camera


def _smooth(levels):
    thing = bpy.context.view_layer.objects.active
    for face in thing.data.polygons:
        face.use_smooth = True
    if levels:
        thing.modifiers.new("fine", "SUBSURF").render_levels = levels


def _wear(name, **inputs):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    for socket, value in inputs.items():
        shader.inputs[socket].default_value = value
    thing = bpy.context.view_layer.objects.active
    thing.name, thing.visible_glossy = name, False
    thing.data.materials.clear()
    thing.data.materials.append(material)
