# SPDX-License-Identifier: GPL-3.0-or-later
"""From a Blender scene to burnish's documents: the only file that knows both.

Blender's world is Z up and right-handed, and so are P, N, camera and light of the frames that Cycles renders of it: nothing is
turned here. Angles are degrees, pictures linear.
"""

import json
import os
import tempfile

import bpy

from . import package, settings
from .look import Look, folded, sliders_of, textured
from .scene import camera, lamps, materials, world
from .session import AS_RENDERED

_FILTERS = {"BOX": "box", "GAUSSIAN": "gaussian", "BLACKMAN_HARRIS": "blackman_harris"}
_POINT = 0.1  # filters narrower than this, in pixels, are points

_syncing = False


def folder(scene):
    """Where the scene's frames and results go, as an absolute path; made if need be."""
    own = scene.burnish.folder
    if own:
        path = bpy.path.abspath(own)
    elif bpy.data.filepath:
        path = os.path.join(os.path.dirname(bpy.data.filepath), "burnish")
    else:
        path = os.path.join(bpy.app.tempdir or tempfile.gettempdir(), "burnish")
    path = os.path.join(os.path.realpath(path), bpy.path.clean_name(scene.name))
    os.makedirs(path, exist_ok=True)
    return path


def as_rendered(scene, frame_file):
    """Settings by name: materials, light, camera as the scene has them, without the live sliders; and what that leaves out."""
    wardrobe, lights = materials.read_materials(scene), lamps.read_lamps(scene)
    sky = world.read_world(scene, folder(scene))
    shot = {"aovs": frame_file, "camera": camera.read_camera(scene), "materials": dict(wardrobe.materials), "assign": wardrobe.assign,
            **sky.settings, **_antialiasing(scene), **settings.values(scene.burnish.settings, live=False)}
    near = {**lights.lights, **{light.name: json.loads(light.document) for light in scene.burnish.lights}}
    if near:
        shot["lights"] = near
    if shot.get("mode") == "difference":
        shot["old_material"] = {name: name + AS_RENDERED for name in wardrobe.materials}
        shot["materials"].update({name + AS_RENDERED: own for name, own in wardrobe.materials.items()})
    return shot, [*wardrobe.notes, *sky.notes, *lights.notes]


def look(scene):
    """Where the live sliders are."""
    own, live = scene.burnish, settings.live_values(scene.burnish.settings)
    sliders = {each.name: {**{name: getattr(each, name) for name in ("roughness", "anisotropy", "rotation", "gain")},
                           "tint": tuple(each.tint)} for each in own.materials}
    weight = tuple(live["gain"] * channel for channel in live["tint"])
    return Look(sliders, {name: live[name] for name in ("env_rotate", "env_scale", "env_tint")}, weight)


def sync(scene, everything=True):
    """Set the sliders to what the materials' nodes say; without `everything`, only those that nobody moved."""
    global _syncing
    found = materials.read_materials(scene).materials
    own = scene.burnish.materials
    _syncing = True
    try:
        for index in reversed([i for i, each in enumerate(own) if each.name not in found]):
            own.remove(index)
        for name, material in found.items():
            slider = own.get(name) or own.add()
            if slider.name == name and slider.is_moved and not everything:
                continue
            slider.name, slider.is_moved, slider.textured = name, False, " ".join(textured(material))
            for key, value in sliders_of(material).items():
                setattr(slider, key, value)
    finally:
        _syncing = False
    scene.burnish.material = min(scene.burnish.material, max(len(own) - 1, 0))


def is_syncing():
    """Whether sliders move because of `sync`, not by hand."""
    return _syncing


def shot(scene, folder, frame_file):
    """The shot document of the scene with its sliders; files inside `folder` are relative to it, where shot.json goes."""
    return document(scene, as_rendered(scene, frame_file)[0], folder)


def document(scene, rendered, folder=None):
    """What `as_rendered` found, with the scene's sliders, as a shot document; paths are absolute without `folder`."""
    live = settings.values(scene.burnish.settings, live=True)
    weight = {name: live[name] for name in ("gain", "tint") if name in live}
    return _document({**folded(rendered, look(scene)), **weight, "output": output_of(rendered["aovs"])}, folder)


def output_of(frame_file):
    """Where the composite of a frame goes."""
    stem, end = os.path.splitext(frame_file)
    return f"{stem}_burnish{end}"


def is_filtered(scene):
    """Whether the scene's pixels are wider than a point."""
    return _filter_width(scene) >= _POINT


def _filter_width(scene):
    return 1.0 if scene.cycles.pixel_filter_type == "BOX" else scene.cycles.filter_width


def _antialiasing(scene):
    """Pixel filter and fine surfaces, where there are any."""
    fine = bpy.path.abspath(scene.burnish.fine_file)
    if not is_filtered(scene) or not fine or not os.path.exists(fine):
        return {}
    return {"fine_aovs": fine, "filter": _FILTERS[scene.cycles.pixel_filter_type], "filter_width": _filter_width(scene)}


def _document(values, folder):
    """Settings by name as the shot file nests them."""
    document, light = {}, {}
    for setting in package.load().settings():
        name = setting["name"]
        if name not in values:
            continue
        value = _relative(values[name], folder) if name in ("aovs", "fine_aovs", "env", "output") else values[name]
        if setting["section"] == "lights":
            light[setting["key"]] = value
        else:
            holder = document.setdefault(setting["section"], {}) if setting["section"] else document
            holder[setting["key"]] = value
    near = {name: {**own, **({"file": _relative(own["file"], folder)} if "file" in own else {})}
            for name, own in values.get("lights", {}).items()}
    sky = {"world": {"type": "environment", **light}} if "file" in light else {}
    return {**document, **({"lights": {**sky, **near}} if sky or near else {})}


def _relative(path, folder):
    if folder is None:
        return path
    inside = os.path.relpath(path, folder)
    return path if inside.startswith("..") else inside
