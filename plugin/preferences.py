# SPDX-License-Identifier: GPL-3.0-or-later
"""Preferences: which burnish is used, or why there is none."""

import bpy

from . import package


def draw_failure(layout):
    """In plain words, what is missing."""
    box = layout.box()
    box.label(text="burnish cannot be loaded", icon="ERROR")
    for line in package.failure():
        box.label(text=line)
    box.label(text="Install the add-on's zip that was built for this Blender, or burnish for its Python.")


class BURNISH_AP_preferences(bpy.types.AddonPreferences):
    """Nothing to set."""

    bl_idname = __package__

    def draw(self, _context):
        """One line, or what went wrong."""
        if package.load():
            self.layout.label(text=package.where(), icon="CHECKMARK")
        else:
            draw_failure(self.layout)


CLASSES = (BURNISH_AP_preferences,)
