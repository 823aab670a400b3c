"""One job through every face gives the same pixels, and every face speaks of the same settings."""

import json
import re

import burnish
import numpy as np
import pytest
import scenes
from conftest import BUILD

SPEC = ("burnish_spec.R", "burnish_spec.G", "burnish_spec.B")


@pytest.fixture
def shot(tmp_path):
    """A folder with a sphere's frame, a sky and a shot file; returns the shot as a dict."""
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    job = {
        "aovs": "beauty.exr",
        "camera": {"position": list(scenes.CAMERA)},
        "lights": {"sky": {"type": "environment", "file": "sky.exr", "up": "z", "rotate": 30}},
        "materials": {"brass": {"model": "ggx", "mx": 0.1, "my": 0.2, "r0": [0.9, 0.7, 0.3]}},
        "assign": [{"material": "brass", "index": 1}],
        "quality": {"samples": 7},
        "output": {"file": "out.exr", "pixel_type": "float", "diagnostics": True},
    }
    (tmp_path / "shot.json").write_text(json.dumps(job))
    return job


def test_command_line_and_python_write_the_same_bytes(shot, tmp_path, cli):
    assert cli("composite", tmp_path / "shot.json").code == 0
    burnish.run(tmp_path / "shot.json", output=tmp_path / "python.exr")
    assert (tmp_path / "out.exr").read_bytes() == (tmp_path / "python.exr").read_bytes()


def without_hash(file):
    """A file's bytes but for the hash of the job, in which a material has its name."""
    return re.sub(rb"[0-9a-f]{64}", b"", file.read_bytes(), count=1)


def test_flags_and_shot_file_are_the_same_job(shot, tmp_path, cli):
    assert cli("composite", tmp_path / "shot.json").code == 0
    material = tmp_path / "brass.json"
    material.write_text(json.dumps(shot["materials"]["brass"]))
    flags = ["--camera", json.dumps(shot["camera"]), "--env", tmp_path / "sky.exr", "--up", "z", "--env-rotate", "30",
             "--assign", f"{material}=index:1", "--samples", "7", "--pixel-type", "float", "--diagnostics"]
    assert cli("composite", tmp_path / "beauty.exr", *flags, "-o", tmp_path / "flags.exr").code == 0
    assert without_hash(tmp_path / "out.exr") == without_hash(tmp_path / "flags.exr")


def test_flags_add_to_the_rules_of_a_shot_file(shot, tmp_path, cli):
    result = cli("composite", tmp_path / "shot.json", "--assign", "gold=index:7", "--gain", "2", "--json")
    job = json.loads(result.out)["job"]
    assert job["assign"] == [{"index": 1, "material": "brass"}, {"index": 7, "material": "gold"}]
    assert job["composite"] == {"gain": 2} and job["quality"] == {"samples": 7}


def test_arrays_give_the_pixels_of_files(shot, tmp_path):
    burnish.run(tmp_path / "shot.json")
    written = scenes.read_exr(tmp_path / "out.exr")
    layers = burnish.composite(scenes.sphere(), scenes.gradient_sky(), shot["materials"], assign=shot["assign"],
                               camera=scenes.CAMERA, up="z", env_rotate=30, samples=7)
    assert np.array_equal(layers["beauty"], scenes.stacked(written, "R", "G", "B", "A"))
    assert np.array_equal(layers["overlay"], scenes.stacked(written, *SPEC))
    assert np.array_equal(layers["validity"], written["burnish_validity.X"])
    assert np.array_equal(layers["samples"], written["burnish_samples.X"])


def test_a_mask_does_what_an_index_does(shot):
    frame = scenes.sphere()
    common = dict(camera=scenes.CAMERA, up="z", samples=7)
    by_rule = burnish.composite(frame, scenes.gradient_sky(), shot["materials"], assign=shot["assign"], **common)
    by_mask = burnish.composite(frame, scenes.gradient_sky(), shot["materials"], assign={"brass": frame["object_id"]}, **common)
    assert by_rule["overlay"].max() > 0
    assert np.array_equal(by_rule["overlay"], by_mask["overlay"])


def test_the_reports_job_runs_again(shot, tmp_path):
    report = burnish.run(tmp_path / "shot.json")
    first = (tmp_path / "out.exr").read_bytes()
    burnish.run(report["job"])
    assert (tmp_path / "out.exr").read_bytes() == first


@pytest.mark.parametrize("density", ["dense", "sparse"])
@pytest.mark.parametrize("threads", [1, 2, 5])
def test_the_same_bits_for_any_thread_count(shot, tmp_path, threads, density):
    burnish.run(tmp_path / "shot.json", density=density)
    burnish.run(tmp_path / "shot.json", density=density, threads=threads, output=tmp_path / "threads.exr")
    assert (tmp_path / "out.exr").read_bytes() == (tmp_path / "threads.exr").read_bytes()


def test_zero_gain_gives_the_beauty_back_bit_for_bit():
    frame = scenes.sphere()
    layers = burnish.composite(frame, scenes.gradient_sky(), "chrome", camera=scenes.CAMERA, gain=0)
    assert np.array_equal(layers["beauty"], frame["beauty"])


def test_under_constant_light_the_overlay_is_the_albedo():
    frame = scenes.plane(16, 12)
    sky = np.full((32, 64, 3), 2.0, np.float32)
    material = {"model": "ggx", "m": 0.2, "tint": [1, 0.5, 0.25]}
    layers = burnish.composite(frame, sky, material, camera=scenes.CAMERA, estimator="reference", max_samples=4096)
    wo = np.asarray(scenes.CAMERA) - frame["position"]
    cosine = (wo * frame["normal"]).sum(-1) / np.linalg.norm(wo, axis=-1)
    local = np.stack([np.sqrt(1 - cosine**2), 0 * cosine, cosine], -1).reshape(-1, 3)
    expected = 2 * burnish.Lobe(material).albedo(local, 16384).reshape(12, 16, 3)
    assert np.allclose(layers["overlay"], expected, rtol=0.02)


def test_the_schema_that_ships_is_the_settings_table(cli):
    shipped = json.loads((BUILD / "share/burnish/shot.schema.json").read_text())
    assert shipped == burnish.shot_schema() == json.loads(cli("composite", "--schema").out)


def test_every_setting_shows_up_on_every_face(cli):
    text = cli("composite", "--help").out
    schema = burnish.shot_schema()["properties"]
    for setting in burnish.settings():
        name, section, key = setting["name"], setting["section"], setting["key"]
        if name not in ("aovs", "materials"):  # the positional argument; no text form
            assert re.search(rf"--{name.replace('_', '-')}\b", text), name
        assert setting["help"] in text or name in ("aovs", "materials"), name
        assert f"\n{name}" in burnish.run.__doc__ and f"\n{name}" in burnish.composite.__doc__, name
        owner = schema if not section else schema[section].get("properties") or schema[section]["additionalProperties"]["anyOf"][0]["properties"]
        assert owner[key]["default"] == setting["default"], name


@pytest.mark.parametrize("setting", burnish.settings(), ids=lambda s: s["name"])
def test_every_setting_refuses_what_it_cannot_hold(setting):
    wrong = {"no": "such value"} if setting["name"] not in ("channel", "factors", "materials", "old_material", "camera", "lights") else [1]
    with pytest.raises(burnish.BadArgument, match=setting["name"]):
        burnish.run({}, **{setting["name"]: wrong})


@pytest.mark.parametrize("setting", [s for s in burnish.settings() if s["min"] is not None and isinstance(s["default"], (int, float))
                                     and not isinstance(s["default"], bool)], ids=lambda s: s["name"])
def test_numbers_out_of_range_are_refused(setting):
    for value in (setting["min"] - 1, float("nan")) + ((setting["max"] * 2 + 1,) if setting["max"] else ()):
        with pytest.raises(burnish.BadArgument, match=setting["name"]):
            burnish.run({}, **{setting["name"]: value})
