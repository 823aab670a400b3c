"""A small scene for the add-on's tests, made in Blender: three glossy balls under a sky, rendered in a second."""

import os

import bpy
import numpy as np


def build(folder, width=128, height=72, samples=128):
    """An empty file with the scene in it; returns the scene."""
    bpy.ops.wm.read_homefile(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = samples, False, False
    scene.cycles.pixel_filter_type = "BOX"
    _sky(scene, os.path.join(folder, "sky.exr"))
    _ball("red", -2.1, "ShaderNodeBsdfGlossy", Color=(0.9, 0.3, 0.2, 1), Roughness=0.3)
    _ball("steel", 0.0, "ShaderNodeBsdfPrincipled", Metallic=1.0, Roughness=0.4)
    _ball("plastic", 2.1, "ShaderNodeBsdfPrincipled", Roughness=0.25, **{"Base Color": (0.1, 0.3, 0.6, 1)})
    data = bpy.data.cameras.new("eye")
    eye = bpy.data.objects.new("eye", data)
    scene.collection.objects.link(eye)
    eye.location, eye.rotation_euler = (0, -8, 0), (np.pi / 2, 0, 0)
    scene.camera = eye
    return scene


def _sky(scene, file):
    """A smooth sky with a soft box in it, in a file of its own."""
    width, height = 128, 64
    v, u = np.mgrid[0:height, 0:width] + 0.5
    theta, phi = np.pi * v / height, 2 * np.pi * u / width
    glow = np.exp(-((theta - 2.0) ** 2 + (np.abs(phi - 1.5) - 0.5) ** 2) / 0.2)
    picture = np.ones((height, width, 4), np.float32)
    for channel, (base, peak) in enumerate(((0.2, 5.0), (0.3, 4.0), (0.5, 3.0))):
        picture[:, :, channel] = base * (1.2 + np.sin(theta) * np.cos(2 * phi)) + peak * glow
    image = bpy.data.images.new("sky", width, height, float_buffer=True)
    image.pixels.foreach_set(picture.ravel())
    image.filepath_raw, image.file_format = file, "OPEN_EXR"
    image.save()
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(file)
    links.new(texture.outputs["Color"], nodes["Background"].inputs["Color"])
    bpy.data.images.remove(image)


def _ball(name, x, kind, **inputs):
    """A ball that casts no light on others."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=1, location=(x, 0, 0))
    ball = bpy.context.view_layer.objects.active
    ball.name = name
    for face in ball.data.polygons:
        face.use_smooth = True
    for ray in ("diffuse", "glossy", "transmission", "volume_scatter", "shadow"):
        setattr(ball, "visible_" + ray, False)
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    shader, output = tree.nodes.new(kind), tree.nodes.new("ShaderNodeOutputMaterial")
    for socket, value in inputs.items():
        shader.inputs[socket].default_value = value
    tree.links.new(shader.outputs[0], output.inputs["Surface"])
    ball.data.materials.append(material)
