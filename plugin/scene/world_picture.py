# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture of a world: the file that it shows, or one that Cycles renders of it, all around, as glossy rays see it."""

from __future__ import annotations

import math
import os

import bpy
from mathutils import Euler

from . import fingerprint, renders
from .borrowed import Borrowed

_LINEAR = {"Linear", "Linear Rec.709", "Linear Rec.709 (sRGB)", "Non-Color", "Raw"}
BAKED_WIDTH, _LARGEST_WIDTH, _EVEN_WIDTH, _SAMPLES = 1024, 4096, 64, 16


def file_of(image, folder):
    """A file that burnish reads as Cycles does; None where there is none."""
    if image.source != "FILE" or image.is_dirty or image.colorspace_settings.name not in _LINEAR:
        return None
    name = os.path.basename(bpy.path.abspath(image.filepath, library=image.library).replace("\\", "/"))
    if os.path.splitext(name)[1].lower() not in (".exr", ".hdr"):
        return None
    if image.packed_file is None:
        file = bpy.path.abspath(image.filepath, library=image.library)
        return os.path.realpath(file) if os.path.exists(file) else None
    os.makedirs(folder, exist_ok=True)
    file = os.path.join(folder, name)
    with open(file, "wb") as out:
        out.write(image.packed_file.data)
    return file


def bake(scene, folder, is_even):
    """Render the scene's world alone; returns the EXR. One that shows the same world is there to stay."""
    world = scene.world
    file, note = os.path.join(folder, "world.exr"), os.path.join(folder, "world.txt")
    shown = fingerprint.of_world(world, scene.frame_current)
    if os.path.exists(file) and os.path.exists(note):
        with open(note) as text:
            if text.read() == shown:
                return file
    _render(scene, world, file, _EVEN_WIDTH if is_even else _width_of(world))
    with open(note, "w") as text:
        text.write(shown)
    return file


def _render(scene, world, file, width):
    alone = bpy.data.scenes.new("burnish")
    with Borrowed() as borrowed:
        borrowed.later(lambda: bpy.data.scenes.remove(alone))
        alone.world = world.copy()
        copy = alone.world
        borrowed.later(lambda: bpy.data.worlds.remove(copy))
        if copy.node_tree:
            renders.fix_light_paths(copy.node_tree, borrowed)
        copy.cycles_visibility.camera = True
        alone.frame_current = scene.frame_current
        renders.set_up(alone, renders.Picture(width, width // 2, _SAMPLES))
        data = renders.add_camera(alone, borrowed, Euler((math.pi / 2, 0, -math.pi / 2)).to_matrix().to_4x4())
        data.type = "PANO"
        (data.cycles if hasattr(data.cycles, "panorama_type") else data).panorama_type = "EQUIRECTANGULAR"
        renders.write(alone, file)


def _width_of(world):
    """As wide as its widest picture, within bounds."""
    nodes = world.node_tree.nodes if world.node_tree else []
    widths = [node.image.size[0] for node in nodes if node.type == "TEX_ENVIRONMENT" and node.image]
    return min(max([BAKED_WIDTH, *widths]), _LARGEST_WIDTH)
