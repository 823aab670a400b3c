# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scene keeps of burnish: its settings, a slider group for each material, where frames are, what was found."""

import bpy

from . import bridge, live, package, settings


def _moved(group, _context):
    live.moved(group.id_data)


def _moved_by_hand(material, context):
    if not bridge.is_syncing():
        material.is_moved = True
        _moved(material, context)


def _slider(name, limits, default):
    """A number that burnish's layers of the same role hold, too."""
    return bpy.props.FloatProperty(name=name.capitalize(), description=_help(name), default=default, min=limits[0], max=limits[1],
                                   update=_moved_by_hand)


def _help(role):
    text = package.load().roles()[role]["help"] if package.load() else role
    return text[:1].upper() + text[1:]


def _material_group():
    """The sliders of a material."""
    tint = bpy.props.FloatVectorProperty(name="Tint", description=_help("tint"), subtype="COLOR", size=3,
                                         default=(1.0, 1.0, 1.0), min=0.0, soft_max=1.0, update=_moved_by_hand)
    gain = bpy.props.FloatProperty(name="Gain", description=_help("weight"), default=1.0, min=0.0, soft_max=4.0,
                                   update=_moved_by_hand)
    return type("BURNISH_PG_material", (bpy.types.PropertyGroup,), {"__annotations__": {
        "roughness": _slider("roughness", (0.01, 1.0), 0.5), "anisotropy": _slider("anisotropy", (-0.99, 0.99), 0.0),
        "rotation": _slider("rotation", (0.0, 1.0), 0.0), "gain": gain, "tint": tint,
        "is_moved": bpy.props.BoolProperty(description="Whether a slider was moved by hand"),
        "textured": bpy.props.StringProperty(description="Numbers that come from the frame's layers, pixel by pixel"),
    }})


def _settings_group():
    return type("BURNISH_PG_settings", (bpy.types.PropertyGroup,), {"__annotations__": settings.properties(_moved)})


class BURNISH_PG_light(bpy.types.PropertyGroup):
    """A baked light, as the shot file spells it."""

    document: bpy.props.StringProperty()


def _chosen(own, _context):
    own.fine_file = ""  # which belongs to another frame


_FILES = {
    "folder": bpy.props.StringProperty(
        name="Folder", subtype="DIR_PATH",
        description="Where frames, baked light and results go; empty: burnish beside the .blend, or a temporary folder"),
    "frame_file": bpy.props.StringProperty(
        name="Frame", subtype="FILE_PATH", update=_chosen,
        description="The rendered multilayer EXR; rendering sets it, and any other may be chosen"),
    "fine_file": bpy.props.StringProperty(
        name="Fine File", subtype="FILE_PATH",
        description="The surfaces of the same frame at a multiple of its size, for clean edges; rendering sets it"),
    "color_depth": bpy.props.EnumProperty(
        name="Colours", items=[("16", "Half", "16 bits a channel; data passes have 32 all the same"), ("32", "Float", "32 bits")],
        description="How exactly the frame's colours are saved"),
    "fine_factor": bpy.props.EnumProperty(
        name="Fine Surfaces", items=[("0", "Off", ""), ("2", "2 x", ""), ("4", "4 x", "")], default="2",
        description="Clean edges over anti-aliased frames: renders the surfaces again, so many times as large, one sample each"),
    "writes_exr": bpy.props.BoolProperty(
        name="Write EXR", default=True, description="Writes composite and overlay beside the frame, too"),
}
_BAKING = {
    "bake_size": bpy.props.IntProperty(
        name="Size", default=256, min=16, max=4096, description="Pixels along an edge of a baked cube map"),
    "bake_samples": bpy.props.IntProperty(name="Samples", default=64, min=1, max=65536, description="Samples a pixel of baked light"),
}


def _scene_group(settings_group, material_group):
    """Everything, hung on the scene."""
    collection = bpy.props.CollectionProperty
    return type("BURNISH_PG_scene", (bpy.types.PropertyGroup,), {"__annotations__": {
        "settings": bpy.props.PointerProperty(type=settings_group),
        "materials": collection(type=material_group),
        "material": bpy.props.IntProperty(name="Material"),
        "lights": collection(type=BURNISH_PG_light),
        "compared": bpy.props.StringProperty(description="How near the overlay comes to Cycles' own reflections"),
        **_FILES, **_BAKING,
    }})


_SETTINGS, _MATERIAL = _settings_group(), _material_group()
CLASSES = (_SETTINGS, _MATERIAL, BURNISH_PG_light, _scene_group(_SETTINGS, _MATERIAL))


def register():
    """`Scene.burnish`."""
    bpy.types.Scene.burnish = bpy.props.PointerProperty(type=CLASSES[-1])


def unregister():
    """Scenes keep their values as plain data; nothing else is left."""
    if hasattr(bpy.types.Scene, "burnish"):
        del bpy.types.Scene.burnish
