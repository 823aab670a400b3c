"""Camera, world, lamps, mirrors and problems, as they are read from a scene."""

import math
import os

import bpy
from addon import OUT, add, ball, empty_scene, material
from bpy_extras.object_utils import world_to_camera_view
from mathutils import Vector

from burnish_addon.scene import camera, checks, lamps, mirrors, passes, world, world_picture

scene = empty_scene(160, 90)


def sees(place):
    """Where burnish's camera JSON shows a place: x right, y up, 0..1."""
    seen = camera.read_camera(scene)
    rows, (width, height) = seen["matrix_world"], camera.pixels(scene)
    right, up, back, centre = (Vector(row[column] for row in rows[:3]) for column in range(4))
    away = Vector(place) - centre
    half = math.tan(math.radians(seen["fov_x_deg"]) / 2)
    depth = -away.dot(back)
    x, y = away.dot(right) / depth / half, away.dot(up) / depth / (half * height / width)
    return (x - 2 * seen["shift"][0] + 1) / 2, (y - 2 * seen["shift"][1] * width / height + 1) / 2


data, places = scene.camera.data, [(0.3, 1, 0.4), (-1, 2, -0.5), (2, 5, 1)]
scene.camera.scale = (2, 2, 2)  # Cycles' cameras have none
for sensor_fit, shift, size in (("AUTO", (0, 0), (160, 90)), ("AUTO", (0.1, -0.2), (90, 160)), ("VERTICAL", (0.2, 0.1), (160, 90)),
                                ("HORIZONTAL", (0.3, 0.1), (100, 160))):
    data.sensor_fit, (data.shift_x, data.shift_y) = sensor_fit, shift
    scene.render.resolution_x, scene.render.resolution_y = size
    bpy.context.view_layer.update()
    for place in places:
        expected = world_to_camera_view(scene, scene.camera, Vector(place))
        assert all(abs(a - b) < 1e-5 for a, b in zip(sees(place), expected)), (sensor_fit, shift, size, sees(place), expected)
data.sensor_fit, data.shift_x, data.shift_y = "AUTO", 0, 0
data.type = "ORTHO"
data.ortho_scale = 4
eye = Vector(camera.read_camera(scene)["position"])
assert (eye - Vector((0, -4006, 0))).length < 0.01, eye
data.type = "PERSP"
for name, value in (("pixel_aspect_x", 2), ("use_border", True)):
    before = getattr(scene.render, name)
    setattr(scene.render, name, value)
    scene.render.use_crop_to_border = name == "use_border"
    assert (Vector(camera.read_camera(scene).pop("position")) - Vector((0, -6, 0))).length < 1e-5
    setattr(scene.render, name, before)
camera_object, scene.camera = scene.camera, None
assert camera.read_camera(scene) == {} and any("no camera" in problem.text for problem in checks.problems(scene))
scene.camera = camera_object

# Worlds that need no picture, and plain colour.
world_picture.BAKED_WIDTH = 64
tree = scene.world.node_tree
tree.nodes["Background"].inputs["Strength"].default_value = 0
assert world.read_world(scene, OUT).settings == {} and "black" in world.read_world(scene, OUT).notes[0]
tree.nodes["Background"].inputs["Strength"].default_value = 2
tree.nodes["Background"].inputs["Color"].default_value = (0.1, 0.2, 0.4, 1)
grey = world.read_world(scene, os.path.join(OUT, "new", "folder"))
assert os.path.exists(grey.settings["env"])
assert grey.settings["env_convention"] == "blender" and grey.settings["up"] == "z"
ramp = tree.nodes.new("ShaderNodeValToRGB")
link = lambda: tree.links.new(ramp.outputs[0], tree.nodes["Background"].inputs["Color"])
recolour = lambda: setattr(ramp.color_ramp.elements[0], "color", (1, 0, 0, 1))
move = lambda: setattr(ramp, "location", (300, 0))
for change, is_other in ((link, True), (recolour, True), (move, False)):  # rendered anew where it shines otherwise
    world.read_world(scene, OUT)
    os.utime(f"{OUT}/world.exr", (0, 0))
    change()
    assert world.read_world(scene, OUT).settings["env"] == f"{OUT}/world.exr"
    assert (os.stat(f"{OUT}/world.exr").st_mtime > 0) == is_other, change
tree.nodes.remove(ramp)
scene.world.cycles_visibility.glossy = False
assert world.read_world(scene, OUT).settings == {}
scene.world.cycles_visibility.glossy = True
no_world, scene.world = scene.world, None
assert world.read_world(scene, OUT).settings == {}
assert any("neither world nor lamps" in problem.text for problem in checks.problems(scene))
scene.world = no_world
assert [s.name for s in bpy.data.scenes] == ["Scene"] and [w.name for w in bpy.data.worlds] == ["world"]

# Lamps: which side shines, spread, portals, nodes.
panel = add("panel", bpy.data.lights.new("panel", "AREA"), (0, 0, 5))
panel.data.shape, panel.data.size, panel.data.size_y, panel.data.energy = "RECTANGLE", 2, 1, 10
bpy.context.view_layer.update()
(light,) = lamps.read_lamps(scene).lights.values()
a, b, c, _ = (Vector(corner) for corner in light["corners"])
assert (b - a).cross(c - b).z < 0 and light["radiance"] == [10 / 8] * 3 and light["type"] == "area", light
panel.data.spread = 1
assert "spread" in lamps.read_lamps(scene).notes[0]
panel.data.use_nodes = True
panel.data.node_tree.nodes["Emission"].inputs["Strength"].default_value = 3
assert lamps.read_lamps(scene).lights["panel"]["radiance"] == [30 / 8] * 3
noise = panel.data.node_tree.nodes.new("ShaderNodeTexNoise")
panel.data.node_tree.links.new(noise.outputs["Fac"], panel.data.node_tree.nodes["Emission"].inputs["Strength"])
assert not lamps.read_lamps(scene).lights and "uneven" in lamps.read_lamps(scene).notes[-1]
panel.data.use_nodes, panel.data.cycles.is_portal = False, True
assert not lamps.read_lamps(scene).lights
panel.data.cycles.is_portal, panel.visible_glossy = False, False
assert not lamps.read_lamps(scene).lights

glow, _ = material("glow")
shader = glow.node_tree.nodes.new("ShaderNodeEmission")
shader.inputs["Color"].default_value, shader.inputs["Strength"].default_value = (1, 0.5, 0.25, 1), 4
glow.node_tree.links.new(shader.outputs[0], glow.node_tree.nodes["Material Output"].inputs["Surface"])
bpy.ops.mesh.primitive_plane_add(size=2, location=(0, 0, 9))
bpy.context.object.name = "window"
bpy.context.object.data.materials.append(glow)
ball("star", glow)
bpy.context.view_layer.update()
lights = lamps.read_lamps(scene).lights
assert list(lights) == ["window"] and lights["window"]["radiance"] == [4, 2, 1] and lights["window"]["two_sided"], lights
assert sorted(lights["window"]["corners"]) == [[-1, -1, 9], [-1, 1, 9], [1, -1, 9], [1, 1, 9]]
mix, side = (glow.node_tree.nodes.new(kind) for kind in ("ShaderNodeMixShader", "ShaderNodeNewGeometry"))
glow.node_tree.links.new(side.outputs["Backfacing"], mix.inputs[0])
glow.node_tree.links.new(shader.outputs[0], mix.inputs[1])
glow.node_tree.links.new(mix.outputs[0], glow.node_tree.nodes["Material Output"].inputs["Surface"])
light = lamps.read_lamps(scene).lights["window"]
a, b, c, _ = (Vector(corner) for corner in light["corners"])
assert not light["two_sided"] and (b - a).cross(c - b).z > 0, "its front is above"
bpy.data.objects.remove(bpy.data.objects["window"])


# Mirrors: planes and slabs, not boxes, rough or hidden things, nor what the camera does not see.
def plane(name, made, location, rotation=(0, 0, 0), size=2.0):
    bpy.ops.mesh.primitive_plane_add(size=size, location=location, rotation=rotation)
    bpy.context.object.name = name
    bpy.context.object.data.materials.append(made)
    return bpy.context.object


shiny, rough = material("shiny", "Glossy", Roughness=0.1)[0], material("rough", "Glossy", Roughness=0.9)[0]
scene.camera.location.z = 2
plane("floor", shiny, (0, 0, 0), size=20)
plane("rough floor", rough, (0, 0, 0.01), size=20)
plane("behind the camera", shiny, (0, -20, 0))
plane("ceiling", shiny, (0, 2, 3))  # from behind
tilted = plane("tilted", shiny, (0, 3, 2), (1.3, 0, 0.2), 3)
plane("hidden", shiny, (0, 3, 2), (1.3, 0, 0)).hide_render = True
ball("ball", shiny)
bpy.ops.mesh.primitive_cube_add(size=2, location=(2, 2, 0.05))
bpy.context.object.name, bpy.context.object.scale = "slab", (1.5, 1.5, 0.05)
bpy.context.object.data.materials.append(shiny)
bpy.ops.mesh.primitive_cube_add(size=2, location=(-2, 2, 1))
bpy.context.object.data.materials.append(shiny)
bpy.context.view_layer.update()
found = mirrors.find_mirrors(scene)
assert [mirror.object_name for mirror in found] == ["floor", "tilted", "slab", "ceiling"], found
assert found[0].area > 0.3 and found[0].material_name == "shiny"
expected = tilted.matrix_world.to_quaternion() @ Vector((0, 0, 1))
assert abs(Vector(found[1].normal).dot(expected) - 1) < 1e-5
assert abs(found[2].point[2] - 0.1) < 1e-5 and Vector(found[2].normal).z > 0.9999
assert Vector(found[3].normal).z < -0.9999


# Problems, each with what to do.
def complaint(level="WARNING"):
    return " ".join(problem.text for problem in checks.problems(scene) if problem.level == level)


passes.prepare(scene, scene.view_layers[0])
assert checks.problems(scene) == [], checks.problems(scene)
scene.view_layers[0].use_pass_glossy_direct = False
assert "Glossy Direct" in complaint() and [p.fix for p in checks.problems(scene)] == ["burnish.prepare"]
scene.view_layers[0].use_pass_position = False
assert "Position" in complaint("ERROR")
passes.prepare(scene, scene.view_layers[0])
if not passes.has_denoiser():
    scene.cycles.use_denoising = True
    assert "OpenImageDenoise" in complaint("ERROR") and checks.problems(scene)[0].fix == "burnish.prepare"
    scene.cycles.use_denoising = False
for owner, name, value, word in ((scene.render, "use_motion_blur", True, "Motion blur"), (data.dof, "use_dof", True, "Depth of field"),
                                 (data, "type", "PANO", "panoramic"), (scene.render, "use_border", True, "region"),
                                 (scene.cycles, "sample_clamp_direct", 1, "clamped"), (scene.cycles, "filter_width", 5, "filter"),
                                 (scene.camera.location, "x", 1e6, "origin")):
    before = getattr(owner, name)
    scene.cycles.pixel_filter_type = "BLACKMAN_HARRIS"
    setattr(owner, name, value)
    bpy.context.view_layer.update()
    assert word in complaint(), (word, complaint())
    setattr(owner, name, before)
    bpy.context.view_layer.update()
    assert word not in complaint()
scene.render.engine = "BLENDER_WORKBENCH"
assert "not Cycles" in complaint("ERROR")
print("CHECKED")
