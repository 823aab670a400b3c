# SPDX-License-Identifier: GPL-3.0-or-later
"""What a module gives Blender: its `CLASSES`, and what its own `register` and `unregister` do besides. Any number of times."""

import bpy


def register(module):
    """Its classes in their order, and the rest after them."""
    for each in module.CLASSES:
        bpy.utils.register_class(each)
    if hasattr(module, "register"):
        module.register()


def unregister(module):
    """All that in reverse, as far as it is there."""
    if hasattr(module, "unregister"):
        module.unregister()
    for each in reversed(module.CLASSES):
        if each.is_registered:
            bpy.utils.unregister_class(each)
