# SPDX-License-Identifier: GPL-3.0-or-later
"""The first click, Prepare, and what is done in a moment: restore, sliders from the nodes, shot file, compositor group."""

import json
import os

import bpy

from . import bridge, images, live, node_group, package
from .scene import passes, touched


class BURNISH_OT_prepare(bpy.types.Operator):
    """Switch on the passes that burnish reads and wire AOVs into the materials; Restore takes all of it back"""

    bl_idname = "burnish.prepare"
    bl_label = "Prepare"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        """There is a burnish."""
        return package.load() is not None

    def execute(self, context):
        """Say what was changed."""
        scene = context.scene
        done = passes.prepare(scene, context.view_layer)
        settings = scene.burnish.settings
        if not settings.is_property_set("mode"):
            settings.mode = "replace"  # a render shows its own reflections already
        bridge.sync(scene, everything=False)
        self.report({"INFO"}, "Prepared: " + ", ".join(done) if done else "Everything was prepared already")
        return {"FINISHED"}


class BURNISH_OT_restore(bpy.types.Operator):
    """Put back everything that burnish changed in the scene, its materials and its compositor, and remove burnish's images"""

    bl_idname = "burnish.restore"
    bl_label = "Restore"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        """Say what was put back."""
        scene = context.scene
        live.end(scene)
        done = ["compositor group taken out"] if node_group.unlink(scene) else []
        done += touched.restore(scene)
        scene.property_unset("burnish")
        images.remove()
        self.report({"INFO"}, "Restored: " + ", ".join(done) if done else "Nothing was changed")
        return {"FINISHED"}


class BURNISH_OT_sync(bpy.types.Operator):
    """Set the sliders to what the materials' nodes say"""

    bl_idname = "burnish.sync"
    bl_label = "Sliders from Nodes"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        """All sliders at once, and one picture."""
        bridge.sync(context.scene)
        live.moved(context.scene)
        return {"FINISHED"}


class BURNISH_OT_shot(bpy.types.Operator):
    """Write shot.json for pipelines: "burnish composite shot.json" makes the same picture"""

    bl_idname = "burnish.shot"
    bl_label = "Write Shot File"

    filepath: bpy.props.StringProperty(subtype="FILE_PATH")

    @classmethod
    def poll(cls, context):
        """There is a frame."""
        return package.load() is not None and bool(context.scene.burnish.frame_file)

    def invoke(self, context, _event):
        """Ask where."""
        self.filepath = self.filepath or os.path.join(bridge.folder(context.scene), "shot.json")
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        """Write it beside itself first, so that nothing half-written is left."""
        scene = context.scene
        target = os.path.abspath(self.filepath or os.path.join(bridge.folder(scene), "shot.json"))
        try:
            document = bridge.shot(scene, os.path.dirname(target), bpy.path.abspath(scene.burnish.frame_file))
            with open(target + ".part", "w", encoding="utf-8") as file:
                json.dump(document, file, indent=2)
            os.replace(target + ".part", target)
        except (OSError, RuntimeError) as error:
            self.report({"ERROR"}, " ".join(str(error).split()))
            return {"CANCELLED"}
        self.report({"INFO"}, f"{package.program()} composite {target}")
        return {"FINISHED"}


class BURNISH_OT_link(bpy.types.Operator):
    """Put the node group "burnish" into the compositor, between the render and its output"""

    bl_idname = "burnish.link"
    bl_label = "Link into Compositor"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, _context):
        """There is an overlay."""
        return images.OVERLAY in bpy.data.images

    def execute(self, context):
        """Replace or add, as the composite does."""
        node_group.link(context.scene, context.scene.burnish.settings.mode == "replace")
        return {"FINISHED"}


CLASSES = (BURNISH_OT_prepare, BURNISH_OT_restore, BURNISH_OT_sync, BURNISH_OT_shot, BURNISH_OT_link)
