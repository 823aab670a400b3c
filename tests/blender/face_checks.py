"""Runs inside Blender: the add-on from its zip, click by click. One line a check: its name, and "ok" or what went wrong.

    blender -b --factory-startup --python face_checks.py -- ZIP FOLDER
"""

import json
import os
import pathlib
import subprocess
import sys
import threading
import traceback

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import bpy  # noqa: E402
import numpy as np  # noqa: E402
import small_scene  # noqa: E402

ZIP, FOLDER = sys.argv[sys.argv.index("--") + 1:]
CHECKS = []


def check(function):
    """Checks run in the order they are written; each goes on from the one before."""
    CHECKS.append(function)
    return function


def pixels(name):
    """An image of burnish's, row 0 on top."""
    image = bpy.data.images[name]
    flat = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(flat)
    return flat.reshape(image.size[1], image.size[0], 4)[::-1]


def traces():
    """What the add-on has registered, by kind."""
    import bpy.app.handlers as handlers

    own = [function for name in dir(handlers) if isinstance(getattr(handlers, name), list) for function in getattr(handlers, name)
           if function.__module__.startswith("burnish_addon")]
    return {"classes": [name for name in dir(bpy.types) if name.startswith("BURNISH_")], "handlers": own,
            "operators": dir(bpy.ops.burnish), "threads": [t.name for t in threading.enumerate() if t.name.startswith("burnish")],
            "properties": [name for name in ("burnish",) if hasattr(bpy.types.Scene, name)],
            "paths": [path for path in sys.path if "burnish_addon" in path]}


def snapshot():
    """Everything of the scene that the add-on may touch."""
    scene, layer = bpy.context.scene, bpy.context.view_layer
    image = scene.render.image_settings
    return {
        "passes": {name: getattr(layer, name) for name in dir(layer) if name.startswith("use_pass_")}, "aovs": list(layer.aovs.keys()),
        "nodes": {m.name: sorted(node.bl_idname for node in m.node_tree.nodes) for m in bpy.data.materials},
        "output": [scene.render.filepath, image.file_format, image.color_mode, image.color_depth, scene.render.use_compositing,
                   scene.render.resolution_x, scene.render.resolution_y, scene.cycles.samples, scene.cycles.pixel_filter_type],
        "compositor": scene.use_nodes, "scenes": list(bpy.data.scenes.keys()), "groups": list(bpy.data.node_groups.keys()),
        "images": [name for name in bpy.data.images.keys() if name.startswith("burnish")], "cameras": list(bpy.data.cameras.keys()),
    }


@check
def it_installs_from_its_zip():
    bpy.ops.preferences.addon_install(filepath=ZIP)
    bpy.ops.preferences.addon_enable(module="burnish_addon")
    import burnish

    assert pathlib.Path(burnish.__file__).is_relative_to(bpy.utils.user_resource("SCRIPTS")), burnish.__file__
    assert len(traces()["classes"]) > 10


@check
def settings_are_those_of_burnish():
    import burnish

    small_scene.build(FOLDER)
    group = bpy.context.scene.burnish.settings
    for setting in burnish.settings():
        if setting["name"] in group.bl_rna.properties:
            declared = group.bl_rna.properties[setting["name"]]
            value = getattr(group, setting["name"])
            assert setting["help"][1:] in declared.description, setting["name"]
            same = np.allclose(value, setting["default"]) if not isinstance(value, str) else value == setting["default"]
            assert same, setting["name"]
            if setting["min"] is not None:
                assert abs(declared.hard_min - setting["min"]) < 1e-6, setting["name"]


@check
def what_is_missing_is_said_first():
    assert not bpy.ops.burnish.composite.poll()
    bpy.ops.burnish.prepare()
    bpy.context.scene.burnish.frame_file = os.path.join(FOLDER, "sky.exr")
    try:
        bpy.ops.burnish.composite()
        raise AssertionError("a sky is no frame")
    except RuntimeError as error:
        line = str(error).strip().removeprefix("Error: ")
        assert "\n" not in line and "sky.exr" in line, line
    bpy.ops.burnish.restore()


@check
def three_clicks_make_the_composite():
    scene = bpy.context.scene
    scene.burnish.folder = FOLDER
    scene["before"] = json.dumps(snapshot())
    before = snapshot()["output"]
    for click in (bpy.ops.burnish.prepare, bpy.ops.burnish.render, bpy.ops.burnish.composite):
        assert click() == {"FINISHED"}
    assert snapshot()["output"] == before
    overlay, composite = pixels("burnish overlay"), pixels("burnish composite")
    assert overlay.shape == (72, 128, 4) and overlay[:, :, :3].max() > 0.5 and overlay[0, 0, 3] == 0 and overlay[36, 64, 3] == 1
    assert np.isfinite(composite).all()
    assert os.path.exists(scene.burnish.frame_file.replace(".exr", "_burnish.exr")), "the EXR beside the frame"


@check
def the_overlay_is_near_cycles_own_reflections():
    assert bpy.ops.burnish.compare() == {"FINISHED"}
    found = json.loads(bpy.context.scene.burnish.compared)
    assert found["frame"] > 35, found
    assert sorted(found["materials"]) == ["plastic", "red", "steel"] and min(found["materials"].values()) > 30, found
    assert 0 < pixels("burnish difference")[:, :, :3].mean() < 0.05


@check
def the_shot_file_makes_the_same_picture_on_the_command_line():
    import OpenImageIO
    from burnish_addon import package

    assert bpy.ops.burnish.shot() == {"FINISHED"}
    file = os.path.join(os.path.dirname(bpy.context.scene.burnish.frame_file), "shot.json")
    document = json.loads(pathlib.Path(file).read_text())
    assert document["aovs"] == "frame_0001.exr", document["aovs"]
    target = os.path.join(FOLDER, "cli.exr")
    subprocess.run([package.program(), "composite", file, "-o", target, "--pixel-type", "float"], check=True, capture_output=True)
    ours, theirs = pixels("burnish composite"), OpenImageIO.ImageBuf(target).get_pixels(OpenImageIO.FLOAT)
    assert np.abs(ours[:, :, :3] - theirs[:, :, :3]).max() < 1e-4 * ours.max(), np.abs(ours[:, :, :3] - theirs[:, :, :3]).max()


@check
def a_slider_changes_its_material_alone_and_meets_a_fresh_composite():
    from burnish_addon import live

    scene = bpy.context.scene
    before = pixels("burnish overlay")
    scene.burnish.materials["steel"].roughness = 0.15
    moved = pixels("burnish overlay")
    change = np.abs(moved - before)[:, :, :3].max(axis=2)
    assert change[:, 50:78].max() > 0.1 and change[:, :38].max() < 0.05 > change[:, 90:].max()
    assert 0 < live.latency(scene) < 5 and live.error(scene) is None
    scene.burnish.settings.gain = 0.5
    assert np.allclose(pixels("burnish overlay")[:, :, :3], 0.5 * moved[:, :, :3], atol=1e-5)
    scene.burnish.settings.gain = 1.0
    scene.burnish.materials["steel"].tint = (1, 0, 0)
    assert pixels("burnish overlay")[36, 64, 1] == 0
    scene.burnish.materials["steel"].tint = (1, 1, 1)
    scene.burnish.settings.env_rotate = 90
    turned = pixels("burnish overlay")
    assert np.abs(turned - moved)[:, :38, :3].max() > 0.1, "light turns on every material"
    bpy.ops.burnish.composite()
    assert np.abs(pixels("burnish overlay") - turned)[:, :, :3].mean() < 0.01, "live and fresh differ"


@check
def sliders_go_back_to_the_nodes():
    scene = bpy.context.scene
    bpy.ops.burnish.sync()
    assert abs(scene.burnish.materials["steel"].roughness - 0.4) < 1e-5
    scene.burnish.settings.env_rotate = 0
    bpy.data.materials["steel"].node_tree.nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.5
    bpy.ops.burnish.composite()
    assert abs(scene.burnish.materials["steel"].roughness - 0.5) < 1e-5, "sliders that nobody moved follow the nodes"


@check
def differences_are_zero_until_a_slider_moves():
    scene = bpy.context.scene
    scene.burnish.settings.mode = "difference"
    bpy.ops.burnish.composite()
    assert np.abs(pixels("burnish overlay")[:, :, :3]).max() < 1e-6
    scene.burnish.materials["red"].roughness = 0.6
    overlay = pixels("burnish overlay")[:, :, :3]
    assert np.abs(overlay[:, :38]).max() > 0.05 and np.abs(overlay[:, 50:]).max() < 1e-6
    scene.burnish.settings.mode = "replace"
    bpy.ops.burnish.sync()
    bpy.ops.burnish.composite()


@check
def the_compositor_group_makes_the_composite():
    import burnish

    scene = bpy.context.scene
    bpy.ops.burnish.link()
    bpy.ops.burnish.link()
    assert sum(node.type == "GROUP" for node in scene.node_tree.nodes) == 1
    image = scene.render.image_settings
    image.file_format, image.color_depth = "OPEN_EXR", "32"
    kept, scene.render.filepath = scene.render.filepath, os.path.join(FOLDER, "grouped.exr")
    bpy.ops.render.render(write_still=True)
    scene.render.filepath, image.file_format, image.color_depth = kept, "PNG", "8"
    grouped = bpy.data.images.load(os.path.join(FOLDER, "grouped.exr"))
    found, wanted = pixels(grouped.name)[:, :, :3], pixels("burnish composite")[:, :, :3]
    assert burnish.compare(found, wanted)["psnr_db"] > 40, burnish.compare(found, wanted)
    bpy.data.images.remove(grouped)


@check
def light_is_baked_and_forgotten():
    scene = bpy.context.scene
    scene.burnish.bake_size, scene.burnish.bake_samples = 16, 2
    bpy.context.view_layer.objects.active = bpy.data.objects["steel"]
    assert bpy.ops.burnish.bake_cube() == {"FINISHED"}
    assert scene.burnish.lights.keys() == ["steel"]
    assert bpy.ops.burnish.composite() == {"FINISHED"}
    bpy.ops.burnish.forget_light(name="steel")
    assert not scene.burnish.lights


@check
def restore_puts_everything_back():
    scene = bpy.context.scene
    bpy.ops.burnish.restore()
    before = json.loads(scene["before"])
    after = json.loads(json.dumps(snapshot()))
    assert after == before, {name: (before[name], after[name]) for name in before if before[name] != after[name]}


@check
def it_registers_twice_and_reloads():
    import burnish_addon

    burnish_addon.register()
    classes = traces()["classes"]
    bpy.ops.script.reload()
    assert traces()["classes"] == classes and len(traces()["handlers"]) == 1, traces()
    assert bpy.ops.burnish.prepare() == {"FINISHED"}


@check
def nothing_is_left_when_it_goes():
    bpy.ops.preferences.addon_disable(module="burnish_addon")
    assert not any(traces().values()), traces()


for function in CHECKS:
    try:
        function()
        print(f"CHECK {function.__name__}: ok", flush=True)
    except Exception:
        print(f"CHECK {function.__name__}: " + repr(traceback.format_exc()), flush=True)
