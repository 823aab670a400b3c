# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels: three clicks in the Render properties, live sliders in the sidebars of Image Editor and Compositor."""

import json
import os

import bpy

from . import images, live, package, preferences, settings
from .scene import checks, touched


class BURNISH_PT_render(bpy.types.Panel):
    """What stands in the way, and the three clicks."""

    bl_label = "burnish"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"

    def draw(self, context):
        """From top to bottom as one works."""
        layout, scene = self.layout, context.scene
        if preferences.draws_failure(layout):
            return
        for problem in checks.problems(scene):
            row = layout.row()
            row.label(text=problem.text, icon="ERROR" if problem.level == "ERROR" else "INFO")
            if problem.fix:
                row.operator(problem.fix)
        column = layout.column(align=True)
        column.scale_y = 1.3
        column.operator("burnish.prepare", icon="CHECKMARK" if touched.is_touched(scene) else "PRESET")
        column.operator("burnish.render", icon="RENDER_STILL")
        column.operator("burnish.composite", icon="NODE_COMPOSITING")
        _draw_outcome(layout, scene)
        row = layout.row(align=True)
        row.operator("burnish.shot", icon="FILE_TEXT")
        row.operator("burnish.link", icon="NODETREE")
        layout.operator("burnish.restore", icon="LOOP_BACK")


class _RenderChild:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"
    bl_parent_id = "BURNISH_PT_render"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, _context):
        """There is a burnish."""
        return package.load() is not None


class BURNISH_PT_frame(_RenderChild, bpy.types.Panel):
    """Which frame, and how it is rendered."""

    bl_label = "Frame"

    def draw(self, context):
        """Properties, one a line."""
        layout, own = _split(self.layout), context.scene.burnish
        for name in ("frame_file", "fine_file", "fine_factor", "color_depth", "folder", "writes_exr"):
            layout.prop(own, name)


class BURNISH_PT_quality(_RenderChild, bpy.types.Panel):
    """burnish's own settings that are not live."""

    bl_label = "Quality"

    def draw(self, context):
        """A target turns the knobs off."""
        layout, group = _split(self.layout), context.scene.burnish.settings
        for name in (name for name in settings.OFFERED if name not in settings.LIVE):
            row = layout.row()
            row.active = group.psnr == 0 or name not in ("estimator", "samples", "density", "safety")
            row.prop(group, name)


class BURNISH_PT_light(_RenderChild, bpy.types.Panel):
    """Lights near the objects."""

    bl_label = "Baked Light"

    def draw(self, context):
        """Buttons, and what was baked."""
        layout, own = self.layout, context.scene.burnish
        row = layout.row(align=True)
        row.prop(own, "bake_size")
        row.prop(own, "bake_samples")
        layout.operator("burnish.bake_cube", icon="CUBE")
        layout.operator("burnish.bake_mirrors", icon="MOD_MIRROR")
        for light in own.lights:
            row = layout.row()
            row.label(text=f"{light.name}: {json.loads(light.document)['type']}", icon="LIGHT")
            row.operator("burnish.forget_light", text="", icon="X").name = light.name


class BURNISH_UL_materials(bpy.types.UIList):
    """Names of materials, and how near each comes to Cycles."""

    def draw_item(self, context, layout, _data, item, _icon, _active, _property):
        """One line."""
        row = layout.row()
        material = bpy.data.materials.get(item.name)
        row.label(text=item.name, icon_value=layout.icon(material) if material else 0)
        decibels = _compared(context.scene).get("materials", {}).get(item.name)
        if decibels is not None:
            row.label(text=f"{decibels:.1f} dB")


class _Live:
    """Sliders that change the pictures as they move."""

    bl_label = "burnish"
    bl_region_type = "UI"
    bl_category = "burnish"

    def draw(self, context):
        """Light, material, whole overlay, comparison."""
        layout, scene = self.layout, context.scene
        if preferences.draws_failure(layout):
            return
        own, group = scene.burnish, scene.burnish.settings
        row = layout.row(align=True)
        row.operator("burnish.composite", icon="NODE_COMPOSITING")
        row.operator("burnish.compare", text="Compare", icon="VIEWZOOM")
        column = _split(layout.column(align=True))
        for name in settings.LIVE:
            column.prop(group, name, slider=name == "gain")
        layout.template_list("BURNISH_UL_materials", "", own, "materials", own, "material", rows=4)
        if own.material < len(own.materials):
            _draw_sliders(layout, own.materials[own.material])
        layout.operator("burnish.sync", icon="FILE_REFRESH")
        _draw_outcome(layout, scene)


class BURNISH_PT_image(_Live, bpy.types.Panel):
    """Beside the picture."""

    bl_space_type = "IMAGE_EDITOR"


class BURNISH_PT_nodes(_Live, bpy.types.Panel):
    """Beside the compositor's nodes."""

    bl_space_type = "NODE_EDITOR"

    @classmethod
    def poll(cls, context):
        """Not beside shaders."""
        return context.space_data.tree_type == "CompositorNodeTree"


def _draw_sliders(layout, material):
    column = _split(layout.column(align=True))
    for name in ("roughness", "anisotropy", "rotation", "gain", "tint"):
        row = column.row()
        row.enabled = name not in material.textured.split()
        row.prop(material, name, slider=name != "tint", text="From a texture" if not row.enabled else None)


def _draw_outcome(layout, scene):
    """How quick and how exact it is, or what went wrong."""
    if (error := live.error(scene)) is not None:
        layout.label(text=" ".join(str(error).split()), icon="ERROR")
    elif (seconds := live.latency(scene)) is not None:
        layout.label(text=f"A move takes {1000 * seconds:.0f} ms", icon="TIME")
    if (decibels := _compared(scene).get("frame")) is not None:
        layout.label(text=f"{decibels:.1f} dB to Cycles' own reflections", icon="CHECKMARK")
    if scene.burnish.frame_file and images.COMPOSITE not in bpy.data.images:
        layout.label(text=f"Rendered: {os.path.basename(scene.burnish.frame_file)}", icon="IMAGE_DATA")


def _compared(scene):
    return json.loads(scene.burnish.compared or "{}")


def _split(layout):
    layout.use_property_split, layout.use_property_decorate = True, False
    return layout


CLASSES = (BURNISH_PT_render, BURNISH_PT_frame, BURNISH_PT_quality, BURNISH_PT_light, BURNISH_UL_materials, BURNISH_PT_image,
           BURNISH_PT_nodes)
