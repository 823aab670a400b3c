"""Scenes that Cycles rendered, as jobs of burnish: settings by name. tests/cycles.py measures them against Cycles itself."""

from __future__ import annotations

import json

FLOOR = {"point": [0, 0, 0], "normal": [0, 0, 1]}
ROOM_BOX = {"min": [-3, -4, 0], "max": [3, 4, 3]}


def jobs(folder):
    """Scene -> settings, of those that are in the folder."""
    found = {}
    if (folder / "spheres/spheres.exr").exists():
        found["cycles spheres"] = spheres(folder / "spheres", "spheres")
    if (folder / "room/room.exr").exists():
        found["cycles room"] = room(folder / "room")
    return found


def materials_of(description):
    """Materials by name and the rules that assign them, as burnish spells what Cycles rendered."""
    materials, rules = {}, []
    for name, m in description["materials"].items():
        lobe = {"model": "ggx" if m["distribution"] == "GGX" else "beckmann", "tint": m["color"]}
        if m["anisotropy"]:
            lobe.update(mx=m["alpha_x"], my=m["alpha_y"], rotation_deg=360 * m["rotation"])
        else:
            lobe.update(m=m["alpha"])
        materials[name] = lobe
        rules.append({"material": name, "material_index": m["pass_index"]})
    return materials, rules


def spheres(folder, name):
    """The frame `name` of objects under a distant light."""
    description = json.loads((folder / f"{name}.json").read_text())
    materials, rules = materials_of(description)
    rotation = description["environment"]["mapping_node"]["rotation_z_deg"]
    return {"aovs": str(folder / f"{name}.exr"), "env": str(folder / "env_courtyard.exr"), "materials": materials, "assign": rules,
            "up": "z", "env_rotate": rotation}


def room(folder):
    """A closed room: a mirror in its floor, a cube map of what else there is."""
    described = json.loads((folder / "room.json").read_text())["materials"]
    centre = json.loads((folder / "cube_px.json").read_text())["cube_face"]["center"]
    materials = {name: {"model": "ggx", "m": described[name]["alpha"], "tint": described[name]["glossy_color"]}
                 for name in ("floor", "vase")}
    lights = {
        "mirror": {"type": "mirror", "file": str(folder / "mirror.exr"), "camera": str(folder / "mirror.json"), "plane": FLOOR},
        "box": {"type": "cubemap", "file": str(folder / "cube_%s.exr"), "centre": centre, "convention": "blender", "up": "z",
                "proxy": {"box": ROOM_BOX}},
    }
    rules = [{"material": name, "material_index": described[name]["pass_index"]} for name in materials]
    return {"aovs": str(folder / "room.exr"), "camera": str(folder / "room.json"), "materials": materials, "assign": rules,
            "lights": lights, "default_light": ["mirror", "box"]}
