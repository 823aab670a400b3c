# SPDX-License-Identifier: GPL-3.0-or-later
"""Light near the objects, rendered by Cycles: cube maps around them and what mirrors show, as lights of a shot file.

A cube map is the scene from the middle of an object's bounding box. The object itself is not seen but still throws shadows. The
world is left out and shows through by its own map, and so are lamps that are lights of their own (lamps.py). A mirror's picture
is the scene from the camera mirrored at its plane, lamps included, as it hides every other light. In both, other objects are seen
with their reflections, unless these are asked to be left out.
"""

from __future__ import annotations

import math
import os
import re

import bpy
from mathutils import Matrix, Vector

from . import camera, lamps, renders
from .borrowed import Borrowed

FACES = {"px": ((1, 0, 0), (0, 0, 1)), "nx": ((-1, 0, 0), (0, 0, 1)), "py": ((0, 1, 0), (0, 0, 1)), "ny": ((0, -1, 0), (0, 0, 1)),
         "pz": ((0, 0, 1), (0, -1, 0)), "nz": ((0, 0, -1), (0, 1, 0))}  # what each looks at, and up


def bake_cube(scene, object_name, folder, size=256, samples=64, progress=None, reflections=True):
    """Render the six faces of a cube map around an object.

    Parameters
    ----------
    scene : bpy.types.Scene
    object_name : str
        The object that will reflect it.
    folder : str
        Where ``cube_NAME_px.exr`` and the others go; made if need be.
    size : int
        Pixels along an edge.
    samples : int
        Of Cycles, per pixel.
    progress : callable, optional
        ``progress(stage, done)``, done in [0, 1]; returning False cancels.
    reflections : bool
        Whether other objects show what they reflect.

    Returns
    -------
    dict
        The light, as a shot file spells it.

    Raises
    ------
    renders.Cancelled
        `progress` returned False. Scene and objects are as before, as after every error.
    """
    thing = bpy.data.objects[object_name]
    centre = centre_of(thing)
    pattern = os.path.join(folder, f"cube_{file_name(object_name)}_%s.exr")
    with Borrowed() as borrowed, renders.stage(scene, renders.Picture(size, size, samples, ("z",), transparent=True)) as copy:
        _show(copy, borrowed, reflections)
        borrowed.set(thing, "visible_camera", False)
        for name in lamps.read_lamps(scene).lights:
            borrowed.set(copy.objects[name], "visible_camera", False)
        data = renders.add_camera(copy, borrowed, Matrix())
        data.angle, data.sensor_fit = math.pi / 2, "HORIZONTAL"
        data.clip_start, data.clip_end = 1e-3, 1e6
        for index, (name, (look, up)) in enumerate(FACES.items()):
            renders.report(progress, f"cube map around {object_name}", index / len(FACES))
            copy.camera.matrix_world = _looking(centre, Vector(look), Vector(up))
            renders.write(copy, pattern % name)
    return {"type": "cubemap", "file": pattern, "centre": list(centre), "convention": "blender", "up": "z", "proxy": "depth"}


def bake_mirror(scene, mirror, folder, samples=64, progress=None, reflections=True):
    """Render what a mirror shows in the current frame: radiance, position and normal.

    Parameters
    ----------
    scene : bpy.types.Scene
    mirror : mirrors.Mirror
    folder : str
        Where ``mirror_NAME.exr`` goes; made if need be.
    samples, progress, reflections
        As for `bake_cube`.

    Returns
    -------
    dict
        The light, as a shot file spells it.
    """
    width, height = camera.pixels(scene)
    file = os.path.join(folder, f"mirror_{file_name(mirror.object_name)}.exr")
    with Borrowed() as borrowed, renders.stage(scene, renders.Picture(width, height, samples, ("z", "position", "normal"))) as copy:
        renders.report(progress, f"mirror {mirror.object_name}", 0.0)
        _show(copy, borrowed, reflections)
        borrowed.set(bpy.data.objects[mirror.object_name], "visible_camera", False)
        for thing in _behind(scene, mirror):
            borrowed.set(thing, "visible_camera", False)
        data = scene.camera.data.copy()
        data.shift_x, data.dof.use_dof = -data.shift_x, False
        matrix = reflection(mirror) @ scene.camera.matrix_world.normalized() @ Matrix.Diagonal((-1, 1, 1, 1))
        renders.add_camera(copy, borrowed, matrix, data)
        renders.write(copy, file)
        seen_from = camera.read_camera(copy)
    light = {"type": "mirror", "file": file, "plane": {"point": list(mirror.point), "normal": list(mirror.normal)}}
    return {**light, "camera": seen_from} if "matrix_world" in seen_from else light


def file_name(name):
    """A name with nothing that file systems or burnish's patterns mind."""
    return re.sub(r"[^\w.-]|%", "_", name)


def centre_of(thing):
    """Middle of an object's bounding box, modifiers included; world space."""
    evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    corners = corners_of(evaluated)
    low, high = (Vector(pick(corner[axis] for corner in corners) for axis in range(3)) for pick in (min, max))
    return (low + high) / 2


def corners_of(thing):
    return [thing.matrix_world @ Vector(corner) for corner in thing.bound_box]


def reflection(mirror):
    """The mirror image of world space at its plane."""
    normal = Vector(mirror.normal).normalized()
    flip = Matrix(tuple(tuple((row == column) - 2 * normal[row] * normal[column] for column in range(3)) for row in range(3))).to_4x4()
    flip.translation = 2 * normal.dot(Vector(mirror.point)) * normal
    return flip


def _looking(centre, look, up):
    matrix = Matrix((look.cross(up), up, -look)).transposed().to_4x4()
    matrix.translation = centre
    return matrix


def _behind(scene, mirror):
    """Objects that lie wholly behind the plane, as seen from the scene's camera: they would stand before the mirrored one."""
    normal, point = Vector(mirror.normal), Vector(mirror.point)
    side = normal.dot(scene.camera.matrix_world.translation - point)
    for thing in scene.objects:
        reach = [normal.dot(corner - point) * (1 if side > 0 else -1) for corner in corners_of(thing)]
        if max(reach) <= 1e-4 * (max(reach) - min(reach)):
            yield thing


def _show(scene, borrowed, reflections):
    renders.show_what_reflections_see(scene, borrowed)
    if not reflections:
        renders.leave_out_reflections(borrowed)
