# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames that Cycles renders for burnish: the scene as it is into a multilayer EXR, and its surfaces again, finely.

The output settings are borrowed for the time of a render; the fine surfaces are rendered in a copy of the scene.
"""

import os

import bpy

from .scene import borrowed, camera, renders

_OUTPUT = {"file_format": "OPEN_EXR_MULTILAYER", "color_mode": "RGBA", "color_depth": "16", "exr_codec": "ZIP"}


def frame_file(scene, folder, kind="frame"):
    """Where the scene's current frame goes."""
    return os.path.join(folder, f"{kind}_{scene.frame_current:04d}.exr")


def borrow_output(scene, file, color_depth):
    """Let the scene's next render go into a multilayer EXR; `__exit__` of what is returned gives its settings back."""
    loan = borrowed.Borrowed()
    settings = scene.render.image_settings
    before = {name: getattr(settings, name) for name in _OUTPUT}

    def give_back():
        for name, value in before.items():  # the format first: it tells which depths there are
            setattr(settings, name, value)

    loan.later(give_back)
    for name, value in {**_OUTPUT, "color_depth": color_depth}.items():
        setattr(settings, name, value)
    for name, value in (("filepath", file), ("use_compositing", False), ("use_sequencer", False), ("use_file_extension", True),
                        ("use_overwrite", True), ("use_placeholder", False)):
        loan.set(scene.render, name, value)
    return loan


def render_fine(scene, file, factor):
    """Render the surfaces of the frame at `factor` times its size, one sample through the middle of each pixel."""
    copy = scene.copy()
    try:
        width, height = camera.pixels(scene)
        render, cycles = copy.render, copy.cycles
        render.resolution_x, render.resolution_y, render.resolution_percentage = width * factor, height * factor, 100
        cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising, cycles.max_bounces = 1, False, False, 0
        cycles.pixel_filter_type, cycles.filter_width = "GAUSSIAN", 0.01
        for view_layer in copy.view_layers:
            view_layer.samples = 0
        borrow_output(copy, file, "32")
        renders.write(copy, file)
    finally:
        bpy.data.scenes.remove(copy)
