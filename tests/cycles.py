"""The scenes that Cycles rendered, as jobs of burnish, and measures over their objects."""

import json

import numpy as np


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


def job_of(folder, name):
    """Arguments of burnish.composite for the frame `name` of a scene's folder."""
    description = json.loads((folder / f"{name}.json").read_text())
    materials, rules = materials_of(description)
    rotation = description["environment"]["mapping_node"]["rotation_z_deg"]
    return dict(aovs=folder / f"{name}.exr", light=folder / "env_courtyard.exr", materials=materials, assign=rules, up="z",
                env_rotate=rotation)


def interior(index, value, margin=2):
    """Pixels whose whole (2 margin + 1)^2 neighbourhood wears the material."""
    inside = np.pad(index == value, margin)
    windows = np.lib.stride_tricks.sliding_window_view(inside, (2 * margin + 1, 2 * margin + 1))
    return windows.all((2, 3))


def displayed(image, scale):
    """Clamped and sRGB-encoded."""
    x = np.clip(np.asarray(image, np.float64) * scale, 0, 1)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)
