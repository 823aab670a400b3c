"""burnish bake: pictures of a room against its geometry and against Cycles, a shot that runs, and errors in one line."""

import json
import signal
import subprocess

import cycles
import numpy as np
import pytest
import scenes
from conftest import PROGRAM

SIZE = (64, 48)
HALF, HEIGHT = 2.0, 2.5
EYE, LOOK = np.array([0.3, -1.7, 1.2]), np.array([0, 0.5, 0.7])
CAMERA = {"position": EYE.tolist(), "look_at": LOOK.tolist(), "up": [0, 0, 1], "fov_x_deg": 70}
BLOCK = [(-0.3, 0.2, 0.0), (0.3, 0.8, 0.5)]

MTL = "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl red\nKd 0.7 0.1 0.1\nnewmtl lamp\nKd 0 0 0\nKe 9 9 9\n"


def quads_of_box(low, high, inside):
    (x0, y0, z0), (x1, y1, z1) = low, high
    sides = {
        "bottom": [(x0, y0, z0), (x0, y1, z0), (x1, y1, z0), (x1, y0, z0)],
        "top": [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)],
        "front": [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)],
        "back": [(x0, y1, z0), (x0, y1, z1), (x1, y1, z1), (x1, y1, z0)],
        "left": [(x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)],
        "right": [(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)],
    }
    return {name: quad[::-1] if inside else quad for name, quad in sides.items()}


@pytest.fixture
def scene(tmp_path):
    """A box of a room with a lamp and a block, as OBJ with Z up, and its camera."""
    walls = quads_of_box((-HALF, -HALF, 0), (HALF, HALF, HEIGHT), True)
    parts = [("floor", "grey", [walls.pop("bottom")]), ("walls", "grey", list(walls.values())),
             ("block", "red", list(quads_of_box(*BLOCK, False).values())),
             ("lamp", "lamp", [[(-0.5, -0.5, 2.4), (-0.5, 0.5, 2.4), (0.5, 0.5, 2.4), (0.5, -0.5, 2.4)]])]
    text, count = "mtllib room.mtl\n", 0
    for name, material, quads in parts:
        text += f"o {name}\nusemtl {material}\n"
        for quad in quads:
            text += "".join(f"v {x} {y} {z}\n" for x, y, z in quad)
            text += "f " + " ".join(str(count + i) for i in (1, 2, 3, 4)) + "\n"
            count += 4
    (tmp_path / "room.obj").write_text(text)
    (tmp_path / "room.mtl").write_text(MTL)
    (tmp_path / "cam.json").write_text(json.dumps(CAMERA))
    return tmp_path / "room.obj"


def arguments(scene, out, *more):
    return ["bake", scene, "--up", "z", "--camera", scene.parent / "cam.json", "--size", "%dx%d" % SIZE, "--cube", "block",
            "--mirror", "floor", "--bake-light-maps", "--light-map-size", 128, "--cube-size", 32, "-o", out, *more]


def names(folder):
    return sorted(path.name for path in folder.iterdir()) if folder.exists() else []


def rays():
    """Directions of the camera's pixels, planar depth 1."""
    forward = (LOOK - EYE) / np.linalg.norm(LOOK - EYE)
    right = np.cross(forward, [0, 0, 1])
    right /= np.linalg.norm(right)
    up, half = np.cross(right, forward), np.tan(np.radians(35))
    x = (2 * (np.arange(SIZE[0]) + 0.5) / SIZE[0] - 1) * half
    y = (1 - 2 * (np.arange(SIZE[1]) + 0.5) / SIZE[1]) * half * SIZE[1] / SIZE[0]
    return forward + x[None, :, None] * right + y[:, None, None] * up


def to_wall(origin, d):
    """Where rays from inside the room meet its walls, and whether they pass the block and the lamp by."""
    with np.errstate(divide="ignore", invalid="ignore"):
        limits = np.where(d > 0, np.array([HALF, HALF, HEIGHT]), np.array([-HALF, -HALF, 0]))
        s = np.where(d != 0, (limits - origin) / d, np.inf).min(-1, keepdims=True)
        near, far = (np.array(BLOCK[0]) - 0.02 - origin) / d, (np.array(BLOCK[1]) + 0.02 - origin) / d
        entry, leaving = np.minimum(near, far).max(-1), np.maximum(near, far).min(-1)
        lamp = origin + d * ((2.4 - origin[..., 2:]) / d[..., 2:])
    free = (entry > leaving) & ~((np.abs(lamp[..., :2]) < 0.55).all(-1) & (d[..., 2] > 0))
    return origin + s * d, free


def test_bake_writes_what_it_names_and_a_shot_that_runs(cli, scene, tmp_path):
    out = tmp_path / "baked"
    told = json.loads(cli(*arguments(scene, out, "--json")).out)
    expected = ["irradiance.exr", "scene.glb", "cube_block.exr", "mirror_floor.exr", "shot.exr", "shot.json"]
    assert told["files"] == [str(out / name) for name in expected] and names(out) == sorted(expected)
    assert {"light map", "cube maps", "mirrors", "frame", "writing", "total"} <= told["seconds"].keys()
    shot = json.loads((out / "shot.json").read_text())
    assert list(shot["lights"]) == ["mirror_floor", "cube_block", "room"]
    assert np.allclose(shot["lights"]["cube_block"]["centre"], np.mean(BLOCK, 0))
    result = cli("composite", out / "shot.json", "--assign", "chrome=crypto:block@cube_block")
    assert result.code == 0, result.err
    layers = scenes.read_exr(out / "out.exr")
    block = scenes.read_exr(out / "shot.exr")["ViewLayer.IndexOB.X"] == 3
    assert block.sum() > 100
    assert layers["burnish_spec.R"][block].mean() > 0.05 and layers["burnish_spec.R"][~block].mean() < 1e-3


def test_a_mirror_holds_what_its_pixels_reflect(cli, scene, tmp_path):
    assert cli(*arguments(scene, tmp_path / "baked")).code == 0
    frame, mirror = (scenes.read_exr(tmp_path / "baked" / f"{name}.exr") for name in ("shot", "mirror_floor"))
    on_floor = frame["ViewLayer.IndexOB.X"] == 1
    d = rays()
    place = EYE + d * (-EYE[2] / d[..., 2:])
    seen, free = to_wall(place, d * [1, 1, -1])
    position = scenes.stacked(mirror, *(f"ViewLayer.Position.{c}" for c in "XYZ"))[:, ::-1]
    compared = on_floor & free
    assert compared.sum() > 300
    assert np.abs(position - seen)[compared].max() < 2e-3
    assert (mirror["ViewLayer.IndexOB.X"] != 1).all()


def test_distances_of_a_cube_map_are_those_to_the_walls(cli, scene, tmp_path):
    centre = np.array([-0.8, -0.4, 1.1])
    more = ["--cube", "floor=" + ",".join(map(str, centre))]
    assert cli(*arguments(scene, tmp_path / "baked", *more)).code == 0
    cube = scenes.read_exr(tmp_path / "baked" / "cube_floor.exr")
    along = (2 * np.arange(32) + 1) / 32 - 1
    right, down = np.meshgrid(along, along)
    one = np.ones_like(right)
    faces = [(one, -down, right), (-one, -down, -right), (right, one, -down), (right, -one, down), (-right, -down, one),
             (right, -down, -one)]  # OpenEXR's, Y up
    d = np.concatenate([np.stack(face, -1) for face in faces])
    d = np.stack([d[..., 0], -d[..., 2], d[..., 1]], -1) / np.linalg.norm(d, axis=-1, keepdims=True)
    seen, free = to_wall(centre, d)
    free &= seen[..., 2] > 1e-6  # the floor is what the map is made for
    assert free.sum() > 3000
    assert np.abs(cube["Z"] - np.linalg.norm(seen - centre, axis=-1))[free].max() < 2e-3
    above = free & (seen[..., 2] > 0.2)
    assert (cube["A"][above] == 1).all() and (cube["R"][above] > 0.01).all()


def test_threads_do_not_change_a_byte(cli, scene, tmp_path):
    for threads in (1, 4):
        assert cli(*arguments(scene, tmp_path / str(threads), "--behind", "block", "--threads", threads)).code == 0
    for name in names(tmp_path / "1"):
        assert (tmp_path / "1" / name).read_bytes() == (tmp_path / "4" / name).read_bytes(), name


def test_a_description_says_what_flags_say(cli, scene, tmp_path):
    assert cli(*arguments(scene, tmp_path / "flags", "--samples", 2)).code == 0
    document = {"scene": "room.obj", "up": "z", "camera": CAMERA, "size": SIZE, "cubes": [{"object": "block"}],
                "mirrors": [{"object": "floor"}], "light_maps": {"bake": True, "size": 128}, "cube_size": 32, "output": "file"}
    (tmp_path / "room_bake.json").write_text(json.dumps(document))
    result = cli("bake", tmp_path / "room_bake.json", "--samples", 2)
    assert result.code == 0, result.err
    assert names(tmp_path / "file") == names(tmp_path / "flags")
    for name in names(tmp_path / "flags"):
        assert (tmp_path / "file" / name).read_bytes() == (tmp_path / "flags" / name).read_bytes(), name


def test_a_signal_stops_the_bake_with_whole_files_only(scene, tmp_path):
    words = list(map(str, [PROGRAM, *arguments(scene, tmp_path / "out", "--samples", 4096, "--progress", "text")]))
    process = subprocess.Popen(words, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    while "cube map" not in process.stderr.readline():
        assert process.poll() is None
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert err.splitlines()[-1].startswith("burnish: error: E_CANCELLED ")
    assert names(tmp_path / "out") == ["irradiance.exr", "scene.glb"]


@pytest.mark.parametrize("flags, name, part", [
    (["--cube", "blok"], "E_BAD_ARGUMENT", 'did you mean "block"'),
    (["--cube", "block"], "E_BAD_ARGUMENT", "two pictures"),
    (["--mirror", "lamb"], "E_BAD_ARGUMENT", 'did you mean "lamp"'),
    (["--mirror", "floor=1,2"], "E_USAGE", "expected 6 numbers"),
    (["--cube", "block=1,x,2"], "E_USAGE", "expected numbers"),
    (["--size", "64"], "E_USAGE", "WIDTHxHEIGHT"),
    (["--samples", "0"], "E_BAD_ARGUMENT", "samples"),
    (["--panes", "glass*"], "E_BAD_ARGUMENT", "no object"),
    (["--irradiance", "map.exr"], "E_BAD_ARGUMENT", "light_maps"),
    (["--camera", "missing.json"], "E_READ_FAILED", "missing.json"),
    (["-o", "/proc/none"], "E_WRITE_FAILED", "/proc/none"),
])
def test_wrong_input_is_told_in_one_line(cli, scene, tmp_path, flags, name, part):
    given = [word for word in arguments(scene, tmp_path / "out")]
    if flags[0] in ("-o", "--size", "--camera"):
        at = given.index(flags[0])
        del given[at:at + 2]
    result = cli(*given, *flags)
    assert result.code in (1, 2)
    assert result.error[0] == name and part in result.error[1]


def test_mirrors_need_a_camera_and_scenes_a_light(cli, scene, tmp_path):
    name, message = cli("bake", scene, "--mirror", "floor", "-o", tmp_path / "out").error
    assert name == "E_BAD_ARGUMENT" and "camera" in message
    (tmp_path / "room.mtl").write_text(MTL.replace("Ke 9 9 9\n", ""))
    name, message = cli("bake", scene, "--bake-light-maps", "--cube", "block", "-o", tmp_path / "out").error
    assert name == "E_BAD_ARGUMENT" and "nothing in the scene emits" in message


def psnr(image, reference, mask):
    """As displayed, over the mask, dB."""
    scale = 0.18 / reference[mask].mean()
    error = cycles.displayed(image, scale) - cycles.displayed(reference, scale)
    return -10 * np.log10(np.mean(error[mask] ** 2))


def away_from_edges(luminance):
    """Pixels like all of their neighbours: Cycles took one point of each pixel, and the bake its mean."""
    windows = np.lib.stride_tricks.sliding_window_view(np.pad(luminance, 1, mode="edge"), (3, 3))
    return windows.max((2, 3)) < 1.3 * windows.min((2, 3))


def rgb(path, prefix):
    return scenes.stacked(scenes.read_exr(path), *(prefix + c for c in "RGB"))


def bake_cycles_room(cli, folder, out, *more):
    result = cli("bake", folder / "room_lightmapped.glb", "--up", "z", "--light-map", folder / "lightmap_radiance.exr",
                 "--camera", folder / "room.json", "--size", "640x360", "-o", out, *more)
    assert result.code == 0, result.err


def test_a_cube_map_of_the_cycles_room_is_what_cycles_renders(cli, data, tmp_path):
    folder = data("cycles/room")
    bake_cycles_room(cli, folder, tmp_path, "--cube", "vase", "--cube-size", 512, "--samples", 8)
    shot = json.loads((tmp_path / "shot.json").read_text())
    centre = json.loads((folder / "cube_px.json").read_text())["cube_face"]["center"]
    assert np.allclose(shot["lights"]["cube_vase"]["centre"], centre, atol=1e-5)
    baked = rgb(tmp_path / "cube_vase.exr", "").reshape(6, 512, 512, 3)
    rendered = [rgb(folder / f"cube_{face}.exr", "ViewLayer.Combined.") for face in ("px", "nx", "pz", "nz", "ny", "py")]
    rendered = np.stack(rendered)
    quality = psnr(baked, rendered, np.ones(baked.shape[:3], bool))
    assert quality > 38, quality


def test_a_mirror_of_the_cycles_room_is_what_cycles_renders(cli, data, tmp_path):
    folder = data("cycles/room")
    bake_cycles_room(cli, folder, tmp_path, "--mirror", "floor")
    baked, rendered = (scenes.read_exr(path) for path in (tmp_path / "mirror_floor.exr", folder / "mirror.exr"))
    same = baked["ViewLayer.IndexMA.X"] == rendered["ViewLayer.IndexMA.X"]
    assert same.mean() > 0.99
    place = [scenes.stacked(file, *(f"ViewLayer.Position.{c}" for c in "XYZ")) for file in (baked, rendered)]
    assert np.median(np.abs(place[0] - place[1])[same]) < 1e-4
    light = [scenes.stacked(file, *(f"ViewLayer.Combined.{c}" for c in "RGB")) for file in (baked, rendered)]
    quality = psnr(*light, same & away_from_edges(light[1].mean(2)))
    assert quality > 40, quality
