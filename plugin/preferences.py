# SPDX-License-Identifier: GPL-3.0-or-later
"""Preferences: which burnish is used, or why there is none."""

import bpy

from . import package


def draws_failure(layout):
    """Whether there is no burnish; if so, draws in plain words what is missing."""
    if package.load():
        return False
    box = layout.box()
    box.label(text="burnish cannot be loaded", icon="ERROR")
    for line in package.failure():
        box.label(text=line)
    box.label(text="Install the add-on's zip that was built for this Blender, or burnish for its Python.")
    return True


class BURNISH_AP_preferences(bpy.types.AddonPreferences):
    """Nothing to set."""

    bl_idname = __package__

    def draw(self, _context):
        """One line, or what went wrong."""
        if not draws_failure(self.layout):
            self.layout.label(text=package.where(), icon="CHECKMARK")


CLASSES = (BURNISH_AP_preferences,)
