# SPDX-License-Identifier: GPL-3.0-or-later
"""The second click: Render, as F12 does, into a multilayer EXR that burnish reads."""

import bpy

from . import background, bridge, package, render
from .scene import renders


class BURNISH_OT_render(bpy.types.Operator):
    """Render the frame with Cycles and keep all of its passes in a multilayer EXR; output settings stay as they are"""

    bl_idname = "burnish.render"
    bl_label = "Render"

    _loan = None  # one render at a time

    @classmethod
    def poll(cls, _context):
        """Nothing else renders."""
        return package.load() is not None and cls._loan is None and not background.is_running()

    def invoke(self, context, _event):
        """With Blender's render window and progress."""
        if bpy.app.background:
            return self.execute(context)
        cls, scene = type(self), context.scene
        file = render.frame_file(scene, bridge.folder(scene))
        try:
            _files[scene.name] = file, _render_fine(scene)
        except RuntimeError as error:
            return self._failed(error)
        cls._loan = render.borrow_output(scene, file, scene.burnish.color_depth)
        bpy.app.handlers.render_complete.append(_completed)
        bpy.app.handlers.render_cancel.append(_cancelled)
        bpy.ops.render.render("INVOKE_DEFAULT", write_still=True)
        return {"FINISHED"}

    def execute(self, context):
        """At once."""
        scene = context.scene
        file = render.frame_file(scene, bridge.folder(scene))
        try:
            fine = _render_fine(scene)
            with render.borrow_output(scene, file, scene.burnish.color_depth):
                renders.write(scene, file)
        except RuntimeError as error:
            return self._failed(error)
        _keep(scene, file, fine)
        self.report({"INFO"}, f"Rendered {file}")
        return {"FINISHED"}

    def _failed(self, error):
        self.report({"ERROR"}, " ".join(str(error).split()))
        return {"CANCELLED"}


_files = {}  # scene name -> the frame that is being rendered, and its fine surfaces


def _render_fine(scene):
    """The file of the fine surfaces, or nothing where none are wanted."""
    factor = int(scene.burnish.fine_factor)
    if not factor or not bridge.is_filtered(scene):
        return ""
    file = render.frame_file(scene, bridge.folder(scene), "fine")
    render.render_fine(scene, file, factor)
    return file


def _keep(scene, file, fine):
    scene.burnish.frame_file = file
    scene.burnish.fine_file = fine


def _completed(scene, *_):
    bpy.app.timers.register(lambda: _give_back(scene.name, True))


def _cancelled(scene, *_):
    bpy.app.timers.register(lambda: _give_back(scene.name, False))


def _give_back(name, is_complete):
    """In Blender's main thread: put the output settings back."""
    _forget_handlers()
    if BURNISH_OT_render._loan:
        BURNISH_OT_render._loan.__exit__()
        BURNISH_OT_render._loan = None
    files = _files.pop(name, None)
    if is_complete and files and name in bpy.data.scenes:
        _keep(bpy.data.scenes[name], *files)


def _forget_handlers():
    for handlers, own in ((bpy.app.handlers.render_complete, _completed), (bpy.app.handlers.render_cancel, _cancelled)):
        if own in handlers:
            handlers.remove(own)


CLASSES = (BURNISH_OT_render,)


def unregister():
    """Give back what is borrowed."""
    _give_back("", False)
