# SPDX-License-Identifier: GPL-3.0-or-later
"""burnish in Blender: reflections over a finished Cycles render, live."""

import importlib
import sys

bl_info = {
    "name": "burnish",
    "author": "The burnish authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Render > burnish; Image Editor and Compositor > Sidebar > burnish",
    "description": "Adds reflections to a finished Cycles render and changes them live, without rendering again",
    "category": "Render",
}

# In the order they are registered. Reloading the add-on (F8) reads all of its files again.
MODULES = ("preferences", "properties", "operators", "operators_render", "operators_composite", "operators_bake",
           "panels", "live")
for _own in [name for name in sys.modules if name.startswith(f"{__name__}.")]:
    del sys.modules[_own]
_classes = importlib.import_module(f"{__name__}.classes")
_modules = [importlib.import_module(f"{__name__}.{name}") for name in MODULES]


def register():
    """Classes, properties, handlers; a second time the same."""
    unregister()
    for module in _modules:
        _classes.register(module)


def unregister():
    """Leave nothing behind."""
    for module in reversed(_modules):
        _classes.unregister(module)
