# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender classes, registered and unregistered any number of times."""

import bpy


def register(classes):
    """In their order."""
    for each in classes:
        bpy.utils.register_class(each)


def unregister(classes):
    """In reverse, those that are registered."""
    for each in reversed(classes):
        if each.is_registered:
            bpy.utils.unregister_class(each)
