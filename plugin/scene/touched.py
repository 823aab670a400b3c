# SPDX-License-Identifier: GPL-3.0-or-later
"""What was changed in a scene, and back again.

Every scene, view layer and material keeps the values it had in a custom property of its own, as JSON, so that they go with it when
it is renamed, saved and loaded again. Nodes that were added carry a mark. `restore` puts all of it back and leaves no trace.
"""

from __future__ import annotations

import json

import bpy

MEMO = "burnish_before"
MARK = "burnish"


def remember(owner, path):
    """Keep the value of a property by its path from `owner`, such as "cycles.samples", unless an older one is kept already."""
    memo = _memo(owner)
    if path not in memo:
        holder, name = _holder(owner, path)
        memo[path] = {"value": _plain(getattr(holder, name)), "is_set": holder.is_property_set(name)}
        owner[MEMO] = json.dumps(memo)


def change(owner, path, value):
    """Set a property and remember what it was; returns whether it was another value."""
    holder, name = _holder(owner, path)
    if getattr(holder, name) == value:
        return False
    remember(owner, path)
    setattr(holder, name, value)
    return True


def add_aov(view_layer, name, kind):
    """A shader AOV of the view layer; returns whether there was none of this name."""
    if name in view_layer.aovs:
        return False
    aov = view_layer.aovs.add()
    aov.name, aov.type = name, kind
    memo = _memo(view_layer)
    memo.setdefault("aovs", []).append(name)
    view_layer[MEMO] = json.dumps(memo)
    return True


def remove_aov(view_layer, name):
    """Blender 3.4 has an operator for it only."""
    before = view_layer.active_aov_index
    view_layer.active_aov_index = view_layer.aovs.find(name)
    with bpy.context.temp_override(scene=view_layer.id_data, view_layer=view_layer):
        bpy.ops.scene.view_layer_remove_aov()
    view_layer.active_aov_index = min(before, max(len(view_layer.aovs) - 1, 0))


def mark(node, text):
    """Call a node ours; `text` says what it was made for."""
    node[MARK] = text


def marked(tree):
    """The nodes of a tree that are ours."""
    return [node for node in tree.nodes if MARK in node]


def is_touched(scene):
    """Whether there is anything to restore."""
    return any(MEMO in owner for owner in _owners(scene)) or any(marked(tree) for _, tree in _trees())


def restore(scene):
    """Put back every value and take out every AOV and node that was added.

    Returns
    -------
    list of str
        What was put back, in words.
    """
    done = []
    for owner in _owners(scene):
        done += _restore_owner(owner)
    for material, tree in _trees():
        nodes = marked(tree)
        for node in nodes:
            tree.nodes.remove(node)
        if nodes:
            done.append(f"{material.name}: AOVs taken out")
    return done


def _restore_owner(owner):
    memo, done = _memo(owner), []
    if MEMO in owner:
        del owner[MEMO]
    for name in memo.pop("aovs", []):
        if name in owner.aovs:
            remove_aov(owner, name)
            done.append(f"{owner.name}: AOV {name} taken out")
    for path, before in memo.items():
        holder, name = _holder(owner, path)
        if before["is_set"]:
            setattr(holder, name, before["value"])
        else:
            holder.property_unset(name)
        done.append(f"{owner.name}: {holder.bl_rna.properties[name].name} put back")
    return done


def _owners(scene):
    return [scene, *scene.view_layers]


def _trees():
    return [(material, material.node_tree) for material in bpy.data.materials if material.node_tree]


def _memo(owner):
    return json.loads(owner.get(MEMO, "{}"))


def _holder(owner, path):
    *way, name = path.split(".")
    for step in way:
        owner = getattr(owner, step)
    return owner, name


def _plain(value):
    return value if isinstance(value, (bool, int, float, str)) else list(value)
