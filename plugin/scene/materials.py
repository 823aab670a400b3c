# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene's materials as burnish's: JSON for the shot file, and rules that say which pixels wear them."""

from __future__ import annotations

import dataclasses

from . import layers, values


@dataclasses.dataclass
class Wardrobe:
    """Materials by name, rules of `assign` by cryptomatte name or material index, and what could not be represented."""

    materials: dict
    assign: list
    notes: list


def read_materials(scene):
    """What the scene's objects wear, of what shines.

    Parameters
    ----------
    scene : bpy.types.Scene

    Returns
    -------
    Wardrobe
        Numbers that textures drive are marked per_pixel; they are there in frames rendered after `passes.prepare`.
    """
    view_layer = rendered_layer(scene)
    wardrobe = Wardrobe({}, [], [])
    for material in worn(scene):
        plan = layers.plan(material)
        wardrobe.notes += [f"{material.name}: {note}" for note in plan.notes]
        if not plan.lobes:
            continue
        wardrobe.materials[material.name] = {"lobes": [_lobe_json(lobe, kinds) for lobe, kinds in plan.lobes]}
        rule = _rule(material, view_layer)
        if rule is None:
            wardrobe.notes.append(f"{material.name}: neither a cryptomatte of materials nor a pass index tells its pixels; "
                                  "prepare the scene")
        else:
            wardrobe.assign.append({"material": material.name, **rule})
    return wardrobe


def rendered_layer(scene):
    """The view layer that burnish reads: the first that renders."""
    return next((layer for layer in scene.view_layers if layer.use), scene.view_layers[0])


def worn(scene):
    """Materials of the objects that render, by name; instances and overrides included."""
    override = rendered_layer(scene).material_override
    if override:
        return [override]
    found = {}
    for thing in _rendered(scene.objects, set()):
        own = [slot.material for slot in thing.material_slots]
        for modifier in thing.modifiers:
            if modifier.type == "NODES" and modifier.node_group:
                own += _set_by_nodes(modifier.node_group, set())
        found.update((material.name_full, material) for material in own if material)
    return [found[name] for name in sorted(found)]


def _rendered(objects, seen):
    for thing in objects:
        if thing.hide_render or thing in seen:
            continue
        seen.add(thing)
        yield thing
        if thing.instance_type == "COLLECTION" and thing.instance_collection:
            yield from _rendered(thing.instance_collection.all_objects, seen)


def _set_by_nodes(tree, seen):
    """Materials that geometry nodes give."""
    seen.add(tree)
    for node in tree.nodes:
        for socket in node.inputs:
            if socket.type == "MATERIAL" and socket.default_value:
                yield socket.default_value
        if node.type == "GROUP" and node.node_tree and node.node_tree not in seen:
            yield from _set_by_nodes(node.node_tree, seen)


def _rule(material, view_layer):
    if view_layer.use_pass_cryptomatte_material:
        return {"cryptomatte": "CryptoMaterial:" + "".join("\\" + c if c in "\\*?," else c for c in material.name)}
    if view_layer.use_pass_material_index and material.pass_index > 0:
        return {"material_index": material.pass_index}
    return None


def _lobe_json(lobe, kinds):
    """A lobe as a shot file spells it; what comes from layers has neutral numbers."""
    lobe_json = {"model": lobe.model, **lobe.fresnel, **lobe.extra}
    if not lobe.extra:
        lobe_json["roughness"] = _within(values.typical(lobe.roughness), 0, 1)
    if lobe.is_stretched:
        lobe_json["anisotropy"] = _within(values.typical(lobe.anisotropy), -0.999, 0.999)
        lobe_json["rotation_deg"] = 360 * (values.typical(lobe.rotation) % 1.0)
    scale = values.factors(lobe.scale)[0] if kinds & {"tint", "weight"} else values.typical(lobe.scale)
    if isinstance(scale, tuple):
        lobe_json["tint"] = [_within(part, 0, 1000) for part in scale]
    elif scale != 1:
        lobe_json["ks"] = _within(scale, 0, 1000)
    if kinds:
        lobe_json["per_pixel"] = sorted(kinds)
    return lobe_json


def _within(value, low, high):
    return min(max(float(value), low), high)
