# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the scene's next render hold all that burnish reads: passes, ids, and AOVs wired into the materials.

Doing it again does nothing, or brings AOVs up to date where materials were changed. `touched.restore` takes all of it back.
"""

from __future__ import annotations

from . import layers, materials, touched, values

PASSES = {name: name.replace("_", " ").title() for name in (
    "position", "normal", "z", "diffuse_direct", "diffuse_indirect", "diffuse_color", "glossy_direct", "glossy_indirect", "glossy_color",
    "transmission_direct", "transmission_indirect", "transmission_color", "object_index", "material_index", "cryptomatte_object",
    "cryptomatte_material")}  # as view layers name them, and as people do


def missing(view_layer):
    """Names of passes that are not switched on yet."""
    return [word for name, word in PASSES.items() if not getattr(view_layer, "use_pass_" + name)]


def prepare(scene, view_layer):
    """Switch on and wire up what burnish needs of the next render.

    Parameters
    ----------
    scene : bpy.types.Scene
    view_layer : bpy.types.ViewLayer

    Returns
    -------
    list of str
        What was changed, in words; empty when everything was there.
    """
    done = [f"pass {word}" for name, word in PASSES.items() if touched.change(view_layer, "use_pass_" + name, True)]
    if not has_denoiser() and touched.change(scene, "cycles.use_denoising", False):
        done.append("denoising off: this Blender was built without OpenImageDenoise")
    for material in materials.worn(scene):
        plan = layers.plan(material)
        wired = _without(_own_aovs(material), plan.layers) if material.library is None else {}
        for kind in plan.layers:
            name = layers.NAMES[kind]
            if touched.add_aov(view_layer, name, layers.TYPES[name]):
                done.append(f"AOV {name}")
        if material.library is None and _wire(material, wired):
            done.append(f"{material.name}: " + ", ".join(layers.NAMES[kind] for kind in wired))
    return done


def _own_aovs(material):
    """Names of AOVs that the user wired: they stay."""
    tree = material.node_tree
    return {_aov_name(node) for node in (tree.nodes if tree else ()) if node.type == "OUTPUT_AOV" and touched.MARK not in node}


def _without(names, wanted):
    return {kind: value for kind, value in wanted.items() if layers.NAMES[kind] not in names}


def _aov_name(node):
    return getattr(node, "aov_name", node.name)  # 3.4 selects the AOV by the node's name


def has_denoiser():
    """Whether this Blender can denoise; Debian's cannot, and its renders fail where denoising is on."""
    import _cycles

    return bool(getattr(_cycles, "with_openimagedenoise", True))


def _wire(material, wanted):
    """Bring the AOVs of a material up to date; returns whether they were not."""
    tree = material.node_tree
    ours = touched.marked(tree) if tree else []
    theirs = {_aov_name(node) for node in (tree.nodes if tree else ()) if node.type == "OUTPUT_AOV" and node not in ours}
    wanted = {kind: value for kind, value in wanted.items() if layers.NAMES[kind] not in theirs}  # two of a name would add up
    text = repr(sorted(wanted.items()))
    if not wanted and not ours or any(node[touched.MARK] == text for node in ours):
        return False
    for node in ours:
        tree.nodes.remove(node)
    if wanted:
        _add_nodes(tree, wanted, text)
    return bool(wanted)


def _add_nodes(tree, wanted, text):
    """AOV outputs with what feeds them, in a frame below the material's output."""
    active = tree.nodes.active
    frame = tree.nodes.new("NodeFrame")
    frame.label = "burnish"
    made = [frame]
    for kind, value in wanted.items():
        output = tree.nodes.new("ShaderNodeOutputAOV")
        setattr(output, _aov_property(output), layers.NAMES[kind])
        made.append(output)
        socket = output.inputs["Color" if layers.TYPES[layers.NAMES[kind]] == "COLOR" else "Value"]
        if kind == "tangent":
            tree.links.new(_tangent(tree, value, made), socket)
        elif values.is_known(value):
            socket.default_value = value
        else:
            tree.links.new(values.node_of(tree, value, made), socket)
    _lay_out(tree, frame, made[1:])
    for node in made:
        touched.mark(node, text)
        node.select = False
    tree.nodes.active = active


def _aov_name(node):
    return getattr(node, _aov_property(node))


def _aov_property(node):
    """Blender 4 calls it otherwise."""
    return "aov_name" if hasattr(node, "aov_name") else "name"


def _tangent(tree, source, made):
    """The socket of the tangent; without one around the object's Z axis, as Cycles takes it then."""
    if source:
        return tree.nodes[source[0]].outputs[source[1]]
    node = tree.nodes.new("ShaderNodeTangent")
    node.direction_type, node.axis = "RADIAL", "Z"
    made.append(node)
    return node.outputs["Tangent"]


def _lay_out(tree, frame, nodes):
    output = tree.get_output_node("CYCLES")
    for row, node in enumerate(nodes):
        node.parent = frame
        node.hide = True
        node.location = (output.location.x, output.location.y - 200 - 60 * row)
