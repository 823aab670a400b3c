"""Prepare and restore: one step there, nothing the second time, and back to exactly what there was."""

import os

import bpy
from addon import OUT, add, ball, blotches, differences, empty_scene, everything, material

from burnish_addon.scene import bake, checks, mirrors, passes, renders, touched


def build():
    scene = empty_scene()
    paint, shader = material("paint", "Principled", Anisotropic=0.5)
    paint.node_tree.links.new(blotches(paint.node_tree, 0.1, 0.5), shader.inputs["Roughness"])
    paint.node_tree.links.new(blotches(paint.node_tree, (0.8, 0.1, 0.1), (0.1, 0.1, 0.8)), shader.inputs["Base Color"])
    shader.inputs["Metallic"].default_value = 0.5
    ball("painted", paint)
    ball("plain", material("chalk", "Diffuse")[0])
    ball("bare")
    mine = material("mine", "Glossy")[0]
    output = mine.node_tree.nodes.new("ShaderNodeOutputAOV")
    output.name = "Roughness"
    ball("with its own", mine)
    scene.view_layers[0].use_pass_normal = True  # has one already
    scene.view_layers[0].aovs.add().name = "Mine"
    scene.cycles.use_denoising = True
    return scene


def saved_and_loaded(name):
    bpy.ops.wm.save_as_mainfile(filepath=f"{OUT}/{name}.blend")
    bpy.ops.wm.open_mainfile(filepath=f"{OUT}/{name}.blend")
    bpy.context.view_layer.update()
    return bpy.context.scene


build()
scene = saved_and_loaded("before")
before = everything()
assert any(path.endswith("use_pass_position") for path in before) and any("default_value" in path for path in before)
assert not touched.is_touched(scene) and touched.restore(scene) == []

done = passes.prepare(scene, scene.view_layers[0])
assert "pass Position" in done and "pass Normal" not in done and "AOV Roughness" in done, done
assert any(line.startswith("paint: ") for line in done) and not any("chalk" in line or "mine" in line for line in done), done
assert touched.is_touched(scene)
assert not [problem for problem in checks.problems(scene) if problem.fix], checks.problems(scene)
prepared = everything()
assert passes.prepare(scene, scene.view_layers[0]) == []
assert differences(prepared, everything()) == []

# What was changed by hand since is taken up, and what was there before all of it still known.
tree = bpy.data.materials["paint"].node_tree
tree.nodes["Principled BSDF"].inputs["Anisotropic"].default_value = 0.0
assert [line.split(":")[0] for line in passes.prepare(scene, scene.view_layers[0])] == ["paint"]
tree.nodes["Principled BSDF"].inputs["Anisotropic"].default_value = 0.5
passes.prepare(scene, scene.view_layers[0])

bpy.data.materials["paint"].name = "renamed"
scene = saved_and_loaded("prepared")
bpy.data.materials["renamed"].name = "paint"
assert touched.is_touched(scene)
lines = touched.restore(scene)
assert "paint: AOVs taken out" in lines and any("AOV Roughness" in line for line in lines), lines
assert differences(before, everything()) == [], "\n".join(differences(before, everything()))
assert touched.restore(scene) == []

# Bakes: whole, stopped, and failed half way.
floor = add("floor", bpy.data.meshes.new("floor"), (0, 0, -1))
floor.data.from_pydata([(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [], [(0, 1, 2, 3)])
floor.data.materials.append(material("polish", "Glossy", Roughness=0.1)[0])
scene.camera.rotation_euler.x -= 0.3
scene.render.resolution_x, scene.render.resolution_y = 16, 9
bpy.context.view_layer.update()
(mirror,) = mirrors.find_mirrors(scene)
before = everything()
light = bake.bake_cube(scene, "painted", f"{OUT}/baked", size=8, samples=1, reflections=False)
assert all(os.path.exists(light["file"] % face) for face in bake.FACES)
light = bake.bake_mirror(scene, mirror, f"{OUT}/baked", samples=1)
assert os.path.exists(light["file"])
assert differences(before, everything()) == [], "\n".join(differences(before, everything()))
stages = []
try:
    bake.bake_cube(scene, "painted", f"{OUT}/stopped", size=8, samples=1, progress=lambda stage, done: stages.append(done) or done < 0.3)
    raise AssertionError("not stopped")
except renders.Cancelled:
    assert stages == [0, 1 / 6, 2 / 6]
try:
    bake.bake_mirror(scene, mirror, "/proc/no/such/folder", samples=1)
    raise AssertionError("not failed")
except OSError:
    pass
assert differences(before, everything()) == [], "\n".join(differences(before, everything()))
print("CHECKED")
