"""For scripts inside Blender: the add-on's scene package, scenes to try it on, and all that a file holds as plain values."""

import math
import os
import pathlib
import sys
import types

import bpy

PLUGIN = pathlib.Path(__file__).resolve().parents[2] / "plugin"

package = types.ModuleType("burnish_addon")  # without running its __init__, which registers panels
package.__path__ = [str(PLUGIN)]
sys.modules.setdefault("burnish_addon", package)

OUT = os.environ.get("BURNISH_OUT", "")


def empty_scene(width=64, height=36, samples=16):
    """Cycles, a camera that looks along +Y, a grey world; every sample through the pixel's middle."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    render, cycles = scene.render, scene.cycles
    render.resolution_x, render.resolution_y = width, height
    cycles.samples, cycles.use_adaptive_sampling, cycles.light_sampling_threshold = samples, False, 0
    cycles.pixel_filter_type, cycles.filter_width, cycles.sample_clamp_indirect = "GAUSSIAN", 0.01, 0
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR_MULTILAYER", "32"
    camera = add("camera", bpy.data.cameras.new("camera"), (0, -6, 0))
    camera.rotation_euler = (math.pi / 2, 0, 0)
    scene.camera = camera
    scene.world = bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    bpy.context.view_layer.update()
    return scene


def add(name, data, location=(0, 0, 0)):
    thing = bpy.data.objects.new(name, data)
    thing.location = location
    bpy.context.scene.collection.objects.link(thing)
    return thing


def ball(name, material=None, location=(0, 0, 0), radius=1.0, camera_only=True):
    """Smooth; visible to camera rays only, so that the glossy pass is material times light alone."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=radius, location=location)
    thing = bpy.context.object
    thing.name = name
    thing.data.polygons.foreach_set("use_smooth", [True] * len(thing.data.polygons))
    if material:
        thing.data.materials.append(material)
    for kind in ("diffuse", "glossy", "transmission", "volume_scatter", "shadow") if camera_only else ():
        setattr(thing, "visible_" + kind, False)
    return thing


def material(name, shader=None, distribution=None, **numbers):
    """A material of one shader, "Glossy", "Principled", ...: inputs by name with _ for spaces; returns it and the shader."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    if shader is None:
        return made, output
    node = tree.nodes.new("ShaderNodeBsdf" + shader)
    if distribution:
        node.distribution = distribution
    for word, number in numbers.items():
        node.inputs[word.replace("_", " ")].default_value = (*number, 1) if isinstance(number, tuple) else number
    tree.links.new(node.outputs[0], output.inputs["Surface"])
    return made, node


def blotches(tree, low, high):
    """A socket that varies from one number or colour to another."""
    noise, mixed = tree.nodes.new("ShaderNodeTexNoise"), tree.nodes.new("ShaderNodeMixRGB")
    place = tree.nodes.new("ShaderNodeTexCoord")
    noise.inputs["Scale"].default_value = 1.5
    for index, end in enumerate((low, high)):
        mixed.inputs[index + 1].default_value = (*end, 1) if isinstance(end, tuple) else (end, end, end, 1)
    tree.links.new(place.outputs["Object"], noise.inputs["Vector"])
    tree.links.new(noise.outputs["Fac"], mixed.inputs["Fac"])
    return mixed.outputs[0]


def everything():
    """All data of the file: path -> value."""
    found, seen = {}, set()
    for name in ("scenes", "objects", "meshes", "materials", "worlds", "cameras", "lights", "node_groups", "images", "collections"):
        for thing in getattr(bpy.data, name):
            if name == "images" and thing.type == "RENDER_RESULT":  # of no scene, never saved
                continue
            _dump(thing, f"{name}[{thing.name}]", found, seen)
            if thing.__class__.__name__ == "Material" or name == "worlds":
                _dump(thing.node_tree, f"{name}[{thing.name}].node_tree", found, seen)
    return found


def _dump(struct, path, found, seen):
    if struct is None or struct.as_pointer() in seen:
        return
    seen.add(struct.as_pointer())
    if isinstance(struct, (bpy.types.ID, bpy.types.ViewLayer, bpy.types.Node)):
        found[path + ".keys"] = sorted(key for key in struct.keys() if not key.startswith("cycles"))
    for prop in struct.bl_rna.properties:
        if prop.identifier not in ("rna_type", "bl_rna", "links", "depsgraph", "is_dirty", "session_uuid") or path.endswith("node_tree"):
            _dump_property(struct, prop, f"{path}.{prop.identifier}", found, seen)


def _dump_property(struct, prop, path, found, seen):
    try:
        value = getattr(struct, prop.identifier)
    except (AttributeError, RuntimeError):
        return
    if prop.type == "POINTER":
        is_id = isinstance(value, bpy.types.ID)
        found[path] = value.name if is_id else value is not None
        if not is_id and not isinstance(value, (bpy.types.Node, bpy.types.NodeSocket)):
            _dump(value, path, found, seen)
    elif prop.type == "COLLECTION":
        found[path] = [getattr(item, "name", "") for item in value]
        for index, item in enumerate(value if len(value) < 200 else ()):
            if isinstance(item, bpy.types.NodeLink):
                found[f"{path}[{index}]"] = (item.from_node.name, item.from_socket.identifier, item.to_node.name, item.to_socket.identifier)
            elif not isinstance(item, bpy.types.ID):
                _dump(item, f"{path}[{index}]", found, seen)
    else:
        found[path] = _plain(value)


def _plain(value):
    """Arrays and matrices as tuples."""
    return tuple(map(_plain, value)) if hasattr(value, "__len__") and not isinstance(value, (str, set)) else value


def differences(before, after):
    """What is not the same, in a few words."""
    return [f"{path}: {before.get(path)} -> {after.get(path)}" for path in sorted(before.keys() | after.keys())
            if repr(before.get(path)) != repr(after.get(path))][:20]
