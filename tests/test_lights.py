"""Several lights in one job: who is lit by what, by name and by place, on every face."""

import json

import numpy as np
import pytest

import burnish
import cycles
import room as room_of_cycles
import scenes

LAMPS = {
    "left": {"type": "area", "corners": [[-2, -3, 1], [-2, -3, 3], [-1, -3, 3], [-1, -3, 1]], "radiance": [5, 4, 3], "two_sided": True},
    "right": {"type": "area", "corners": [[1, -3, 1], [1, -3, 2], [2, -3, 2], [2, -3, 1]], "radiance": 7, "two_sided": True},
}
SATIN = {"model": "ggx", "m": 0.3}


@pytest.fixture
def room(tmp_path):
    """Paths of pictures around: a sky, and a room of constant radiance 2."""
    sky = scenes.gradient_sky(128)
    names = ["R", "G", "B"]
    return {"sky": scenes.write_exr(tmp_path / "sky.exr", names, sky),
            "grey": scenes.write_exr(tmp_path / "grey.exr", names, np.full_like(sky, 2))}


def cube(file, centre=(0, 0, 0), **fields):
    return {"type": "cubemap", "file": file, "centre": centre, "convention": "blender", "up": "z", **fields}


def composite(**job):
    settings = {"light": None, "materials": SATIN, "camera": scenes.CAMERA, "up": "z", "density": "dense"} | job
    return burnish.composite(scenes.sphere(), **settings)


def overlay(**job):
    return composite(**job)["overlay"]


def psnr(a, b):
    return burnish.compare(a, b, scenes.sphere()["object_id"])["psnr_db"]


def test_lamps_add():
    one, other = (overlay(lights={name: LAMPS[name]}) for name in LAMPS)
    both = overlay(lights=LAMPS)
    assert one.max() > 0.1 and other.max() > 0.1
    assert np.allclose(both, one + other, rtol=1e-4, atol=1e-6)


def test_what_blocks_hides_what_lies_behind(room):
    lights = {"room": cube(room["grey"])}
    alone, sky = overlay(lights=lights), overlay(light=room["sky"], lights=lights, default_light="sky")
    assert np.array_equal(overlay(light=room["sky"], lights=lights), alone)
    lights["room"]["blocks"] = False
    assert psnr(overlay(light=room["sky"], lights=lights), alone + sky) > 45


def test_a_map_far_away_is_an_environment(room):
    assert psnr(overlay(lights={"room": cube(room["sky"])}), overlay(light=room["sky"])) > 45


def test_scale_and_tint_multiply(room):
    plain = overlay(lights={"room": cube(room["grey"])})
    tinted = overlay(lights={"room": cube(room["grey"], scale=2, tint=[1, 0.5, 0])})
    assert np.allclose(tinted, plain * [2, 1, 0], rtol=1e-5)
    lamp = {"lamp": LAMPS["left"] | {"scale": 2, "tint": 0.25}}
    assert np.allclose(overlay(lights=lamp), 0.5 * overlay(lights={"lamp": LAMPS["left"]}), rtol=1e-5)


def test_an_environment_that_is_alone_keeps_its_bits(room):
    alone = composite(light=room["sky"], density="sparse")
    chosen = composite(light=room["sky"], density="sparse", lights=LAMPS, default_light="sky")
    assert np.array_equal(chosen["overlay"], alone["overlay"])
    assert chosen["report"]["lookups"] == alone["report"]["lookups"]


def test_rules_name_their_lights(room):
    by_rule = overlay(materials={"satin": SATIN}, light=room["sky"], lights=LAMPS, assign=["satin=index:1@left"])
    assert np.array_equal(by_rule, overlay(lights={"left": LAMPS["left"]}))
    masks = scenes.sphere()["object_id"]
    masked = overlay(materials={"satin": SATIN}, assign={"satin": masks}, light=room["sky"], lights=LAMPS, default_light=["left"])
    assert np.array_equal(masked, by_rule)


def test_every_pixel_takes_the_nearest_map(room):
    half = {"left": cube(room["grey"], (-1, 0, 0)), "right": cube(room["sky"], (1, 0, 0))}
    split = overlay(lights=half)
    left, right = (overlay(lights={name: light}) for name, light in half.items())
    x = scenes.sphere()["position"][..., :1]
    assert np.array_equal(split, np.where(x < 0, left, right))


def test_the_report_speaks_of_rules(room):
    lights = {name: cube(room["grey"], (x, 0, 0)) for name, x in (("left", -1), ("right", 1))}
    report = composite(materials={"satin": SATIN}, assign=["satin=index:1", "satin=index:7"], lights=lights)["report"]
    assert report["materials"]["satin"] == 0 and report["pixels"]["valid"] > 500
    assert report["warnings"] == ["the rule for material 'satin' finds no pixel of its own"]
    assert any(note.startswith("left: ") for note in report["notes"])


def test_threads_do_not_show(room):
    lights = LAMPS | {"near": cube(room["sky"], (0, -1, 0), proxy={"box": {"min": [-4, -4, -4], "max": [4, 4, 4]}})}
    for density in ("dense", "sparse"):
        one, many = (overlay(lights=lights, density=density, threads=threads) for threads in (1, 4))
        assert np.array_equal(one, many)


def test_a_hundred_maps_share_the_materials_tables(room):
    maps = {str(i): cube(room["grey"], (np.sin(i), np.cos(i), 0.02 * i - 1), proxy={"box": {"min": [-9] * 3, "max": [9] * 3}})
            for i in range(100)}
    rules = [f"{m}=index:1" for m in range(10)]
    materials = {str(m): {"model": "ggx", "m": 0.1 + 0.02 * m} for m in range(10)}

    def tables(lights):
        runs = [composite(materials=materials, assign=rules, lights=lights)["report"]["seconds"]["tables"] for _ in range(3)]
        return min(runs)

    assert tables(maps) < 3 * tables({"0": maps["0"]})


def test_mode_difference_knows_them_too(room):
    job = {"materials": {"new": SATIN, "old": SATIN}, "material": "new", "mode": "difference", "lights": LAMPS}
    assert not overlay(**job, old_material={"new": "old"}).any()


def test_pixels_without_light_are_told(tmp_path):
    frame = {k: v for k, v in scenes.plane().items() if k != "object_id"}
    render = scenes.write_frame(tmp_path / "mirror.exr", frame)
    mirror = {"type": "mirror", "file": render, "camera": scenes.CAMERA_JSON, "plane": {"point": [0, 0, 50], "normal": [0, 0, 1]}}
    report = composite(lights={"floor": mirror})["report"]
    assert any("pixels have no light" in warning for warning in report["warnings"])


def test_the_command_line_does_the_same(cli, tmp_path, room):
    scenes.write_frame(tmp_path / "in.exr", scenes.sphere(), {"oiio:ColorSpace": "linear"})
    (tmp_path / "lights.json").write_text(json.dumps(LAMPS["left"]))
    (tmp_path / "shot.json").write_text(json.dumps({
        "aovs": "in.exr", "camera": scenes.CAMERA_JSON, "materials": {"satin": SATIN},
        "assign": [{"material": "satin", "index": 1, "light": ["left", "sky"]}],
        "lights": {"left": "lights.json", "sky": {"type": "environment", "file": "sky.exr", "up": "z"}},
        "quality": {"density": "dense"}, "output": {"file": "out.exr", "pixel_type": "float"}}))
    assert cli("composite", tmp_path / "shot.json").code == 0
    expected = overlay(materials={"satin": SATIN}, assign=["satin@left,sky"], light=room["sky"], lights={"left": LAMPS["left"]})
    names = [f"burnish_spec.{c}" for c in "RGB"]
    assert np.allclose(scenes.stacked(scenes.read_exr(tmp_path / "out.exr"), *names), expected, rtol=1e-5)
    flags = ["--light", f"left={json.dumps(LAMPS['right'])}", "-o", tmp_path / "other.exr"]
    assert cli("composite", tmp_path / "shot.json", *flags).code == 0
    other = scenes.stacked(scenes.read_exr(tmp_path / "other.exr"), *names)
    assert not np.allclose(other, expected, rtol=1e-2)


def test_bandwidth_is_predicted_under_any_light(cli, tmp_path, room):
    scenes.write_frame(tmp_path / "in.exr", scenes.sphere())
    flags = ["--camera", json.dumps(scenes.CAMERA_JSON), "--material", "chrome", "-o", tmp_path / "bandwidth.exr"]
    lights = ["--light", f"lamp={json.dumps(LAMPS['left'])}", "--light", f"room={json.dumps(cube(str(room['sky'])))}"]
    assert cli("bandwidth", tmp_path / "in.exr", *flags, *lights).code == 0
    layers = scenes.read_exr(tmp_path / "bandwidth.exr")
    shaded = layers["curvature.X"] > 0
    assert shaded.sum() > 500 and (layers["bandwidth.X"][shaded] > 0).all()
    assert (layers["samples.X"][shaded] == 1).all()


@pytest.mark.parametrize("settings, message", [
    ({"lights": LAMPS, "default_light": "lft"}, r"unknown light \"lft\" \(did you mean \"left\""),
    ({"lights": LAMPS, "assign": ["gold@right,sky"], "materials": {}}, r"assign \(material gold\): unknown light \"sky\""),
    ({"lights": {"map": cube("absent.exr")}}, r"lights\.map: absent\.exr"),
    ({"lights": {}}, "no light: name an environment"),
])
def test_what_cannot_be_is_named(settings, message):
    with pytest.raises(burnish.Error, match=message):
        composite(**settings)


def test_a_coupled_diffuse_part_gives_way_to_the_lobes():
    frame = scenes.sphere()
    lobe = {"model": "ggx", "m": 0.3, "r0": 0.1}
    wo = np.asarray(scenes.CAMERA) - frame["position"]
    cosine = (wo * frame["normal"]).sum(-1) / np.linalg.norm(wo, axis=-1)
    local = np.stack([np.sqrt(np.maximum(1 - cosine**2, 0)), 0 * cosine, cosine], -1)
    albedo = burnish.Lobe(lobe).albedo(local.reshape(-1, 3), 4096).reshape(*cosine.shape, 3)
    aovs = {role: frame[role] for role in ("position", "normal")} | {"irradiance": np.full_like(frame["normal"], 2)}
    material = {"kd": 0.6, "kd_coupled": True, "lobes": [lobe]}
    diffuse = burnish.composite(aovs, None, material, lights=LAMPS, camera=scenes.CAMERA)["diffuse"]
    shown = (frame["object_id"] > 0) & (cosine > 0.05)
    assert np.allclose(diffuse[shown], (0.6 * (1 - albedo) * 2 / np.pi)[shown], atol=2e-3)


def test_a_room_is_lit_by_place(data):
    folder = data("cycles/room")
    lights = {name: light for name, light in room_of_cycles.lights_of(folder).items() if name in ("mirror", "depth")}
    job = room_of_cycles.job_of(folder, []) | {"lights": lights, "default_light": "auto"}
    result = burnish.composite(**job)
    channels = room_of_cycles.layers(folder)
    truth, index = room_of_cycles.glossy(channels), channels["ViewLayer.IndexMA.X"]
    floor, vase = (burnish.compare(result["overlay"], truth, cycles.interior(index, i, 1))["psnr_db"] for i in (1, 2))
    assert floor > 27 and vase > 32
    assert set(result["report"]["materials"]) == {"floor", "vase"}
