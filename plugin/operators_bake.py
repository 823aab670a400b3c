# SPDX-License-Identifier: GPL-3.0-or-later
"""Light near the objects at a click: a cube map around the active object, the mirrors that the scene has. Cycles renders them."""

import json

import bpy

from . import background, bridge, package
from .scene import bake, mirrors, renders


class _Bake(bpy.types.Operator):
    """What both bakes share: Blender renders in its main thread, so this waits for it, with a bar beside the pointer."""

    @classmethod
    def poll(cls, _context):
        """Nothing else works."""
        return package.load() is not None and not background.is_running()

    def execute(self, context):
        """Bake, and add what was baked to the scene's lights."""
        manager = context.window_manager
        manager.progress_begin(0, 100)
        try:
            for name, light in self.baked(context, lambda _stage, done: manager.progress_update(100 * done)):
                own = context.scene.burnish.lights
                entry = own.get(name) or own.add()
                entry.name, entry.document = name, json.dumps(light)
                self.report({"INFO"}, f"Baked {name}; composite again to see it")
        except (RuntimeError, renders.Cancelled) as error:
            self.report({"ERROR"}, " ".join(str(error).split()))
            return {"CANCELLED"}
        finally:
            manager.progress_end()
        return {"FINISHED"}


class BURNISH_OT_bake_cube(_Bake):
    """Render a cube map around the active object, which reflects it from then on instead of the world alone"""

    bl_idname = "burnish.bake_cube"
    bl_label = "Bake around Active Object"

    def baked(self, context, progress):
        """One cube map."""
        thing, own = context.active_object, context.scene.burnish
        if thing is None:
            raise RuntimeError("No object is active; select the one that reflects")
        folder = bridge.folder(context.scene)
        yield thing.name, bake.bake_cube(context.scene, thing.name, folder, own.bake_size, own.bake_samples, progress)


class BURNISH_OT_bake_mirrors(_Bake):
    """Find flat glossy surfaces, floors above all, and render what each one mirrors"""

    bl_idname = "burnish.bake_mirrors"
    bl_label = "Bake Mirrors"

    def baked(self, context, progress):
        """One picture a mirror."""
        found, own = mirrors.find_mirrors(context.scene), context.scene.burnish
        if not found:
            raise RuntimeError("No flat glossy surface fills a good part of the picture")
        for mirror in found:
            light = bake.bake_mirror(context.scene, mirror, bridge.folder(context.scene), own.bake_samples, progress)
            yield mirror.object_name, light


class BURNISH_OT_forget_light(bpy.types.Operator):
    """Leave a baked light out from now on"""

    bl_idname = "burnish.forget_light"
    bl_label = "Forget Light"
    bl_options = {"REGISTER", "UNDO"}

    name: bpy.props.StringProperty()

    def execute(self, context):
        """Its files stay."""
        own = context.scene.burnish.lights
        if self.name in own:
            own.remove(own.find(self.name))
        return {"FINISHED"}


CLASSES = (BURNISH_OT_bake_cube, BURNISH_OT_bake_mirrors, BURNISH_OT_forget_light)
