# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of burnish as Blender images: linear, float, RGBA; Blender's rows go from the bottom up."""

import bpy
import numpy as np

OVERLAY, COMPOSITE, DIFFERENCE = "burnish overlay", "burnish composite", "burnish difference"
NAMES = (OVERLAY, COMPOSITE, DIFFERENCE)


def show(name, picture, alpha=None):
    """Put a picture of shape (height, width, 3 or 4), row 0 on top, into the image of that name; returns it."""
    height, width = picture.shape[:2]
    image = _image(name, width, height)
    pixels = np.ones((height, width, 4), np.float32)
    pixels[:, :, : picture.shape[2]] = picture[::-1]
    if alpha is not None:
        pixels[:, :, 3] = alpha[::-1]
    image.pixels.foreach_set(pixels.ravel())
    image.update()
    return image


def remove():
    """All of them, from the file."""
    for name in NAMES:
        if (image := bpy.data.images.get(name)) is not None:
            bpy.data.images.remove(image)


def redraw():
    """Show what changed wherever an image or a compositor is open."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in ("IMAGE_EDITOR", "NODE_EDITOR", "PROPERTIES"):
                area.tag_redraw()


def _image(name, width, height):
    image = bpy.data.images.get(name)
    if image is not None and tuple(image.size) != (width, height):
        image.scale(width, height)
    if image is None:
        image = bpy.data.images.new(name, width, height, alpha=True, float_buffer=True)
        image.alpha_mode = "PREMUL"
        image.use_fake_user = False
    return image


def open_in(context, name):
    """Show an image in every Image Editor that shows another of ours, a render or nothing."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            space = area.spaces.active
            if area.type == "IMAGE_EDITOR" and (space.image is None or space.image.name in (*NAMES, "Render Result")):
                space.image = bpy.data.images[name]
