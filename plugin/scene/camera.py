# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene's camera as burnish takes it, by Blender's own projection matrix: sensor fit, lens shift and all.

burnish needs the eye for every pixel's view direction, and its rays only where a frame has depth instead of positions. So what
has no such rays (a panorama, pixels that are not square, a cropped border) is the eye alone. An orthographic camera is an eye far
behind: directions then differ from parallel by less than a thousandth.
"""

from __future__ import annotations

import math

import bpy

_FAR = 1000.0  # widths of an orthographic picture


def read_camera(scene):
    """Camera JSON of the current frame; empty without a camera."""
    if scene.camera is None or scene.camera.type != "CAMERA":
        return {}
    matrix = scene.camera.matrix_world.normalized()
    eye = matrix.translation
    if scene.camera.data.type == "ORTHO":
        eye = eye + matrix.col[2].xyz * _FAR * scene.camera.data.ortho_scale
    if scene.camera.data.type != "PERSP" or not _fills_its_frame(scene):
        return {"position": list(eye)}
    projection = projection_of(scene)
    width, height = pixels(scene)
    return {"matrix_world": [list(row) for row in matrix], "fov_x_deg": math.degrees(2 * math.atan(1 / projection[0][0])),
            "sensor_fit": "HORIZONTAL", "shift": [projection[0][2] / 2, projection[1][2] / 2 * height / width], "type": "PERSP",
            "clip_start": scene.camera.data.clip_start, "clip_end": scene.camera.data.clip_end}


def pixels(scene):
    """Width and height of the picture."""
    render = scene.render
    return render.resolution_x * render.resolution_percentage // 100, render.resolution_y * render.resolution_percentage // 100


def projection_of(scene):
    """Camera space to the picture's -1..1, as rows."""
    width, height = pixels(scene)
    render = scene.render
    return scene.camera.calc_matrix_camera(bpy.context.evaluated_depsgraph_get(), x=width, y=height, scale_x=render.pixel_aspect_x,
                                           scale_y=render.pixel_aspect_y)


def _fills_its_frame(scene):
    render = scene.render
    cropped = render.use_border and render.use_crop_to_border
    return not cropped and abs(render.pixel_aspect_x / render.pixel_aspect_y - 1) < 1e-4
