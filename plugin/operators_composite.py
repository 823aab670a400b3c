# SPDX-License-Identifier: GPL-3.0-or-later
"""The third click: Composite; and Compare, with Cycles' own reflections."""

import json
import os

import bpy

from . import background, bridge, compare, images, live, package
from .session import Session


def _frame_file(context):
    own = context.scene.burnish.frame_file if package.load() else ""
    return bpy.path.abspath(own) if own else ""


class BURNISH_OT_composite(background.Background, bpy.types.Operator):
    """Add the reflections to the rendered frame; the image "burnish composite" shows it, and sliders move it"""

    bl_idname = "burnish.composite"
    bl_label = "Composite"

    @classmethod
    def poll(cls, context):
        """There is a frame, and nothing else works."""
        if not os.path.exists(_frame_file(context)):
            cls.poll_message_set("Render first, or choose a multilayer EXR")
            return False
        return not background.is_running()

    def task(self, context):
        """Read the scene here, and the frame in the thread."""
        scene = context.scene
        live.end(scene)
        bridge.sync(scene, everything=False)
        rendered, self._notes = bridge.as_rendered(scene, _frame_file(context))
        if not rendered["assign"]:
            raise RuntimeError("Nothing in the scene reflects: no glossy material was found")
        look, document = bridge.look(scene), bridge.document(scene, rendered)
        is_written, is_filtered = scene.burnish.writes_exr, bridge.is_filtered(scene)

        def composite(progress):
            session = Session(rendered, look, is_filtered, progress)
            if is_written:
                package.load().run(document, progress)
            return session

        return composite

    def finish(self, context, session):
        """Show it, and let sliders move it."""
        overlay, composite = session.pictures()
        images.show(images.OVERLAY, overlay, session.covered)
        images.show(images.COMPOSITE, composite)
        images.open_in(context, images.COMPOSITE)
        live.begin(context.scene, session)
        for warning in [*self._notes, *session.report["warnings"]]:
            self.report({"WARNING"}, warning)
        return f"Composited {len(session.materials)} materials in {sum(session.report['seconds'].values()):.2f} s"


class BURNISH_OT_compare(background.Background, bpy.types.Operator):
    """Measure how near the overlay comes to Cycles' own glossy passes; "burnish difference" shows where it is off"""

    bl_idname = "burnish.compare"
    bl_label = "Compare with Cycles"

    @classmethod
    def poll(cls, context):
        """There is something to compare."""
        if live.session(context.scene) is None:
            cls.poll_message_set("Composite first")
            return False
        return not background.is_running()

    def task(self, context):
        """Measure in the thread, when the sliders rest."""
        live.settle(context.scene)
        session = live.session(context.scene)
        return lambda progress: compare.measured(session, progress)

    def finish(self, context, found):
        """Show the difference and the numbers."""
        images.show(images.DIFFERENCE, found.difference)
        context.scene.burnish.compared = json.dumps({"frame": found.psnr_db, "materials": found.materials})
        return f"{found.psnr_db:.1f} dB to Cycles' own reflections"


CLASSES = (BURNISH_OT_composite, BURNISH_OT_compare)


def unregister():
    """Stop what works."""
    background.stop_all()
