# SPDX-License-Identifier: GPL-3.0-or-later
"""What would spoil the result, found before a render is spent on it. Cheap: a panel may ask whenever it is drawn."""

from __future__ import annotations

import dataclasses

from . import passes

_PREPARE = "burnish.prepare"
_FAR_AWAY = 1e4  # scene units: single precision leaves a thousandth there


@dataclasses.dataclass(frozen=True)
class Problem:
    """`level` "ERROR" (it cannot work) or "WARNING"; `text` says what and what to do; `fix`: operator that does it, or ""."""

    level: str
    text: str
    fix: str = ""


def problems(scene):
    """What stands in the way of a good composite, the worst first.

    Returns
    -------
    list of Problem
    """
    found = [*_render(scene), *_camera(scene), *_light(scene), *_picture(scene), *_passes(scene)]
    return sorted(found, key=lambda problem: problem.level != "ERROR")


def _render(scene):
    if scene.render.engine != "CYCLES":
        yield Problem("ERROR", "The render engine is not Cycles, whose passes burnish reads; choose Cycles in the Render properties")
    if scene.cycles.use_denoising and any(layer.cycles.use_denoising for layer in scene.view_layers):
        if not passes.has_denoiser():
            yield Problem("ERROR", "Denoising is on, but this Blender was built without OpenImageDenoise: renders fail; prepare the scene",
                          _PREPARE)
        else:
            yield Problem("WARNING", "Denoising smooths the picture but not its passes: replacing the rendered reflections leaves their "
                                     "noise; switch it off, or take more samples")
    if scene.cycles.sample_clamp_direct > 0 or 0 < scene.cycles.sample_clamp_indirect < 10:
        yield Problem("WARNING", "Samples are clamped: rendered highlights are darker than those burnish makes; set Clamping to 0")


def _camera(scene):
    camera = scene.camera
    if camera is None or camera.type != "CAMERA":
        yield Problem("ERROR", "The scene has no camera; add one")
        return
    if camera.data.type == "PANO":
        yield Problem("WARNING", "The camera is panoramic: no mirrors can be rendered for it")
    if camera.data.dof.use_dof:
        yield Problem("WARNING", "Depth of field is on: reflections stay sharp where the frame is blurred; switch it off, or blur "
                                 "afterwards")
    if max(abs(part) for part in camera.matrix_world.translation) > _FAR_AWAY:
        yield Problem("WARNING", "The scene is far from the world's origin: positions are inexact there; move it nearer")


def _light(scene):
    if scene.world is None and not any(thing.type == "LIGHT" and not thing.hide_render for thing in scene.objects):
        yield Problem("ERROR", "The scene has neither world nor lamps: nothing shines; add a world, or bake the light around the objects")


def _picture(scene):
    render = scene.render
    if render.use_motion_blur:
        yield Problem("WARNING", "Motion blur is on: reflections are made of one moment; switch it off, or blur afterwards")
    if scene.cycles.pixel_filter_type != "BOX" and scene.cycles.filter_width > 3:
        yield Problem("WARNING", "The pixel filter is wide: normals of neighbouring surfaces mix; take a width of 1.5")
    if render.film_transparent and scene.cycles.film_transparent_glass:
        yield Problem("WARNING", "Glass is transparent in the film: what it reflects is added over what lies behind; switch "
                                 "Transparent Glass off")
    if render.use_border:
        yield Problem("WARNING", "Only a region of the picture is rendered" + (", and cropped" if render.use_crop_to_border else ""))


def _passes(scene):
    for view_layer in scene.view_layers:
        lacking = passes.missing(view_layer) if view_layer.use else []
        if {"Position", "Normal"} & set(lacking):
            yield Problem("ERROR", f"{view_layer.name} lacks passes: {', '.join(lacking)}; prepare the scene", _PREPARE)
        elif lacking:
            yield Problem("WARNING", f"{view_layer.name} lacks passes: {', '.join(lacking)}; prepare the scene", _PREPARE)
