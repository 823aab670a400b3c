# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the scene for burnish's lights, rendered in another scene of the same things: the user's own settings are never touched.

They show what reflections see: objects that glossy rays meet, materials as Light Path nodes make them for glossy rays.
"""

from __future__ import annotations

import contextlib
import dataclasses
import os

import bpy

from . import links, touched
from .materials import rendered_layer

_NOT_COPIED = {"engine", "denoiser", "preview_denoiser"}  # the first is set; the others are no values where Blender cannot denoise


class Cancelled(Exception):
    """The progress callback returned False."""


@dataclasses.dataclass(frozen=True)
class Picture:
    width: int
    height: int
    samples: int
    passes: tuple = ()  # besides the picture itself
    transparent: bool = False  # the world is left out, alpha tells where


@contextlib.contextmanager
def stage(scene, picture):
    """Another scene of the same things that renders such pictures with Cycles, to multilayer EXRs; gone afterwards.

    It is made anew: of objects in a scene that was copied Blender 3.4 goes on counting users.
    """
    twin = bpy.data.scenes.new("burnish")
    try:
        _copy_settings(scene, twin)
        set_up(twin, picture)
        yield twin
    finally:
        bpy.data.scenes.remove(twin)


def _copy_settings(scene, twin):
    """All that the light depends on."""
    for thing in scene.collection.objects:
        twin.collection.objects.link(thing)
    for child in scene.collection.children:
        twin.collection.children.link(child)
    twin.world = scene.world
    twin.render.engine = "CYCLES"
    for part in ("render", "cycles"):
        _copy_values(getattr(scene, part), getattr(twin, part))
    twin.frame_float = scene.frame_float
    twin.view_layers[0].material_override = rendered_layer(scene).material_override
    _copy_layers(rendered_layer(scene).layer_collection, twin.view_layers[0].layer_collection)


def _copy_values(source, target):
    for prop in source.bl_rna.properties:
        if not prop.is_readonly and prop.type in ("BOOLEAN", "INT", "FLOAT", "ENUM") and prop.identifier not in _NOT_COPIED:
            setattr(target, prop.identifier, getattr(source, prop.identifier))


def _copy_layers(source, target):
    """What a view layer leaves out or shows only indirectly."""
    for name in ("exclude", "holdout", "indirect_only"):
        setattr(target, name, getattr(source, name))
    for child in source.children:
        _copy_layers(child, target.children[child.name])


def set_up(scene, picture):
    """Settings of a scene that is ours alone."""
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = picture.width, picture.height, 100
    render.use_border = render.use_motion_blur = render.use_compositing = render.use_sequencer = render.use_multiview = False
    render.film_transparent = picture.transparent
    render.use_file_extension, render.use_overwrite, render.use_single_layer = True, True, False
    settings = render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth, settings.exr_codec = "OPEN_EXR_MULTILAYER", "RGBA", "32", "ZIP"
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = picture.samples, False, False
    cycles.pixel_filter_type, cycles.film_exposure, cycles.time_limit = "BOX", 1.0, 0.0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    for index, view_layer in enumerate(scene.view_layers):
        view_layer.use, view_layer.samples = index == 0, 0
        for name in dir(view_layer):
            if name.startswith("use_pass_"):
                setattr(view_layer, name, name[len("use_pass_"):] in ("combined", *picture.passes))
        for name in view_layer.aovs.keys():
            touched.remove_aov(view_layer, name)


def add_camera(scene, borrowed, matrix, data=None):
    """Make the scene look from there; `data`: the camera's, by default a new one."""
    data = data or bpy.data.cameras.new("burnish")
    thing = bpy.data.objects.new("burnish", data)
    borrowed.later(lambda: bpy.data.cameras.remove(data))
    scene.collection.objects.link(thing)
    thing.matrix_world = matrix
    scene.camera = thing
    return data


def write(scene, file):
    """Render the scene into the EXR."""
    os.makedirs(os.path.dirname(file), exist_ok=True)
    scene.render.filepath = file
    bpy.ops.render.render(write_still=True, scene=scene.name)
    if not os.path.exists(file):
        raise RuntimeError(f"{file} was not rendered; Blender's console says why")


def report(progress, stage_name, done):
    """Tell the callback, if there is one; raises Cancelled where it says no."""
    if progress and progress(stage_name, done) is False:
        raise Cancelled(stage_name)


def show_what_reflections_see(scene, borrowed):
    """Objects and materials as glossy rays find them, for the camera of a bake."""
    for thing in scene.objects:
        if thing.visible_camera != thing.visible_glossy:
            borrowed.set(thing, "visible_camera", thing.visible_glossy)
    for material in bpy.data.materials:
        if material.node_tree and material.library is None:
            fix_light_paths(material.node_tree, borrowed)
    for tree in bpy.data.node_groups:
        if tree.type == "SHADER" and tree.library is None:
            fix_light_paths(tree, borrowed)


def fix_light_paths(tree, borrowed):
    """What Light Path nodes say becomes what they say of glossy rays."""
    told = [(link.to_socket, link.from_socket.name) for link in tree.links if link.from_node.type == "LIGHT_PATH"]
    for socket, question in told:
        if socket.type == "VALUE" and question in (*links.CAMERA, *links.REFLECTED):
            borrowed.plug(tree, socket, float(question in links.REFLECTED))


_SPECULAR_INPUTS = {"BSDF_GLOSSY": ("Color",), "BSDF_ANISOTROPIC": ("Color",), "BSDF_GLASS": ("Color",),
                    "BSDF_PRINCIPLED": ("Specular", "Specular IOR Level", "Metallic", "Clearcoat", "Coat Weight")}


def leave_out_reflections(borrowed):
    """Materials without their glossy lobes."""
    trees = [material.node_tree for material in bpy.data.materials if material.node_tree and material.library is None]
    for tree in [*trees, *(group for group in bpy.data.node_groups if group.type == "SHADER" and group.library is None)]:
        for node in tree.nodes:
            for socket in node.inputs:
                if socket.name in _SPECULAR_INPUTS.get(node.type, ()):
                    borrowed.plug(tree, socket, (0, 0, 0, 1) if socket.type == "RGBA" else 0.0)
