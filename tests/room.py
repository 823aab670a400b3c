"""The room that Cycles rendered, as a job of burnish, with each way to represent the light in it."""

import gzip
import json

import numpy as np

import scenes

BOX = {"min": [-3, -4, 0], "max": [3, 4, 3]}
FLOOR = {"point": [0, 0, 0], "normal": [0, 0, 1]}
CEILING = {"point": [0, 0, 3], "normal": [0, 0, 1]}
GLOSSY = ("floor", "vase")


def _cube(folder, proxy):
    centre = json.loads((folder / "cube_px.json").read_text())["cube_face"]["center"]
    return {"type": "cubemap", "file": str(folder / "cube_%s.exr"), "centre": centre, "convention": "blender", "up": "z",
            "proxy": proxy}


def lights_of(folder):
    """All lights of the room by name, as a shot file spells them."""
    return {
        "infinite": _cube(folder, "infinite"),
        "planes": _cube(folder, {"planes": [FLOOR, CEILING]}),
        "box": _cube(folder, {"box": BOX}),
        "depth": _cube(folder, "depth"),
        "mesh": _cube(folder, {"mesh": str(folder / "room_lightmapped.glb")}),
        "mirror": {"type": "mirror", "file": str(folder / "mirror.exr"), "camera": str(folder / "mirror.json"), "plane": FLOOR},
        "one_step": {"type": "mirror", "file": str(folder / "mirror.exr"), "camera": str(folder / "mirror.json"), "plane": FLOOR,
                     "second_step": False},
        "traced": {"type": "traced", "scene": str(folder / "room_lightmapped.glb"), "up": "z",
                   "radiance": str(folder / "lightmap_radiance_reflected.exr")},
    }


def job_of(folder, chain):
    """Arguments of burnish.composite for the room's frame under the named lights, one behind the other."""
    described = json.loads((folder / "room.json").read_text())["materials"]
    lights = lights_of(folder)
    materials = {name: {"model": "ggx", "m": described[name]["alpha"], "tint": described[name]["glossy_color"]} for name in GLOSSY}
    rules = [{"material": name, "material_index": described[name]["pass_index"]} for name in GLOSSY]
    return dict(aovs=folder / "room.exr", light=None, materials=materials, assign=rules, camera=folder / "room.json",
                lights={name: lights[name] for name in chain}, default_light=list(chain))


def layers(folder):
    """Channels of the frame, by their whole names."""
    return scenes.read_exr(folder / "room.exr")


def _rgb(channels, name):
    return np.stack([channels[f"ViewLayer.{name}.{c}"] for c in "RGB"], axis=2)


def glossy(channels):
    """What Cycles reflects: GlossCol * (GlossDir + GlossInd)."""
    return _rgb(channels, "GlossCol") * (_rgb(channels, "GlossDir") + _rgb(channels, "GlossInd"))


def _xyz(channels, name):
    return np.stack([channels[f"ViewLayer.{name}.{c}"] for c in "XYZ"], axis=2).astype(np.float64)


def _boxes(folder):
    """Bounding boxes of what stands on the floor, by the geometry file: (lowest, highest) corners."""
    corners = {}
    with gzip.open(folder / "room.obj.gz", "rt") as lines:
        for line in lines:
            words = line.split()
            if words and words[0] == "o":
                name = words[1]
            elif words and words[0] == "v":
                corners.setdefault(name, []).append([float(word) for word in words[1:4]])
    return [(np.min(points, axis=0), np.max(points, axis=0)) for name, points in corners.items()
            if name.startswith(("box", "pedestal"))]


def _meets(p, d, box):
    """Whether rays from p along d meet a box."""
    with np.errstate(divide="ignore", invalid="ignore"):
        near, far = (box[0] - p) / d, (box[1] - p) / d
    return np.minimum(near, far).max(2) < np.maximum(near, far).min(2).clip(0)


def sees_floor(folder, channels):
    """Pixels whose mirror ray ends on the floor."""
    eye = np.array(json.loads((folder / "room.json").read_text())["camera"]["matrix_world"])[:3, 3]
    p, n = _xyz(channels, "Position"), _xyz(channels, "Normal")
    view = p - eye
    view /= np.linalg.norm(view, axis=2, keepdims=True)
    d = view - 2 * n * (n * view).sum(2, keepdims=True)
    with np.errstate(divide="ignore", invalid="ignore"):
        hit = p - d * (p[..., 2:] / d[..., 2:])
    free = ~np.logical_or.reduce([_meets(p, d, box) for box in _boxes(folder)])
    return (d[..., 2] < 0) & (np.abs(hit[..., 0]) < 3) & (np.abs(hit[..., 1]) < 4) & free
