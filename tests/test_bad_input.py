"""Bad input of every kind: one clear line that names file, field and remedy, a documented exit code, nothing half-written.

Only the command line is used, so that the same tests run on the build with sanitizers.
"""

import json
import os
import resource

import numpy as np
import pytest
import scenes

GIGABYTE = 1 << 30


@pytest.fixture
def work(tmp_path):
    """A folder with good inputs, and an empty `out` in it."""
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    (tmp_path / "out").mkdir()
    return tmp_path


@pytest.fixture
def composite(cli, work):
    """Run a job whose good parts are replaced by keyword; returns the result after looking for leftovers."""

    def run(*words, aovs="beauty.exr", env="sky.exr", material="chrome", output="out/out.exr", **options):
        arguments = ["composite", aovs, "--env", env, "--material", material, "-o", output, *words]
        result = cli(*arguments, cwd=work, **options)
        if result.code:
            assert list((work / "out").iterdir()) == [], "something half-written was left behind"
        return result

    return run


def expect(result, code, name, *parts):
    assert result.code == code, result.err
    found, message = result.error
    assert found == name, message
    for part in parts:
        assert part in message, message


def test_the_good_job_is_good(composite):
    assert composite().code == 0


def test_an_absent_frame(composite):
    expect(composite(aovs="absent.exr"), 1, "E_READ_FAILED", "absent.exr")


def test_a_pattern_without_frames(composite):
    expect(composite(aovs="absent.####.exr", output="out/o.####.exr"), 1, "E_READ_FAILED", "absent.####.exr")


@pytest.mark.parametrize("share", [0.0, 0.02, 0.3, 0.9])
def test_a_truncated_exr(composite, work, share):
    whole = (work / "beauty.exr").read_bytes()
    (work / "beauty.exr").write_bytes(whole[: int(len(whole) * share)])
    expect(composite(), 1, "E_READ_FAILED", "beauty.exr")


@pytest.mark.parametrize("role", ["position", "normal"])
def test_a_missing_channel_tells_how_to_name_one(composite, work, role):
    frame = scenes.sphere()
    del frame[role]
    scenes.write_frame(work / "beauty.exr", frame)
    expect(composite("--camera", json.dumps(scenes.CAMERA_JSON)), 1, "E_MISSING_CHANNEL", "beauty.exr", role, f"--channel {role}=")


def test_a_channel_that_is_not_there(composite):
    expect(composite("--channel", "normal=Nope"), 1, "E_MISSING_CHANNEL", "beauty.exr", "Nope", "normal")


def test_ids_that_are_not_there(composite, work):
    frame = scenes.sphere()
    del frame["object_id"]
    scenes.write_frame(work / "beauty.exr", frame)
    expect(composite("--assign", "gold=index:1"), 1, "E_MISSING_CHANNEL", "gold")
    expect(composite("--assign", "gold=crypto:ball*"), 1, "E_MISSING_CHANNEL", "gold")


def test_replacing_a_specular_that_was_not_rendered(composite):
    expect(composite("--mode", "replace"), 1, "E_MISSING_CHANNEL", "specular_direct", "--mode add")


def test_a_difference_without_the_old_material(composite):
    expect(composite("--mode", "difference"), 2, "E_BAD_ARGUMENT", "--old-material chrome=")


def test_a_flat_frame_cannot_tell_its_camera(composite, work):
    scenes.write_frame(work / "beauty.exr", scenes.plane())
    result = composite()
    assert result.code == 1 and "--camera" in result.err.splitlines()[-1]


def test_broken_pixels_are_left_as_they_are(composite, work):
    frame = scenes.sphere()
    frame["normal"][24, 32] = np.nan
    frame["position"][20, 30] = np.inf
    scenes.write_frame(work / "beauty.exr", frame)
    result = composite("--pixel-type", "float")
    assert result.code == 0
    layers = scenes.read_exr(work / "out/out.exr")
    assert all(np.isfinite(channel).all() for channel in layers.values())
    assert layers["burnish_spec.R"][24, 32] == layers["burnish_spec.R"][20, 30] == 0


def test_zero_normals_shade_nothing_and_say_so(composite, work):
    frame = scenes.sphere()
    frame["normal"][:] = 0
    scenes.write_frame(work / "beauty.exr", frame)
    result = composite("--camera", json.dumps(scenes.CAMERA_JSON))
    if result.code == 0:
        assert "warning" in result.err and scenes.read_exr(work / "out/out.exr")["burnish_spec.R"].max() == 0
    else:
        expect(result, 1, "E_MISSING_CHANNEL", "normal")


def test_an_absent_light(composite):
    expect(composite(env="absent.hdr"), 1, "E_READ_FAILED", "absent.hdr")


def test_no_light_no_material_no_output(cli, work):
    words = {"--env": work / "sky.exr", "--material": "chrome", "-o": work / "out/out.exr"}
    for missing in words:
        arguments = [word for flag, value in words.items() if flag != missing for word in (flag, value)]
        expect(cli("composite", work / "beauty.exr", *arguments), 2, "E_BAD_ARGUMENT", missing)


def test_a_light_with_broken_texels_is_scrubbed_with_a_warning(composite, work):
    sky = scenes.gradient_sky()
    sky[3, 5], sky[10, 7], sky[11, 8] = np.nan, np.inf, -5
    scenes.write_exr(work / "sky.exr", ["R", "G", "B"], sky)
    result = composite()
    assert result.code == 0 and result.err.count("warning") == 3 and "sky.exr" in result.err
    assert all(np.isfinite(channel).all() for channel in scenes.read_exr(work / "out/out.exr").values())


@pytest.mark.parametrize("content", [b"", b"\x00" * 100, b"#?RADIANCE\n\n-Y 99999 +X 99999\n", b"P6 1 1 255 abc"])
def test_a_light_that_is_no_picture(composite, work, content):
    (work / "sky.hdr").write_bytes(content)
    expect(composite(env="sky.hdr"), 1, "E_READ_FAILED", "sky.hdr")


@pytest.mark.parametrize("text, parts", [
    ("{", ["line 1"]),
    ('{"aovs": "beauty.exr",}', ["line 1"]),
    ("[]", ["an object"]),
    ('{"aov": "beauty.exr"}', ['did you mean "aovs"']),
    ('{"quality": {"sampels": 7}}', ["quality", 'did you mean "samples"']),
    ('{"quality": {"samples": 7.5}}', ["quality.samples", "whole number", "7.5"]),
    ('{"quality": {"samples": "7"}}', ["quality.samples", '"7"']),
    ('{"quality": {"decibels": 45}}', ["quality", "decibels"]),
    ('{"quality": 3}', ["quality", "an object"]),
    ('{"lights": {"a": {"file": "sky.exr"}, "b": {"file": "sky.exr"}}}', ["lights.b", "one environment"]),
    ('{"lights": {"sky": {"type": "miror"}}}', ["lights.sky.type", "mirror"]),
        ('{"lights": {"floor": {"type": "mirror"}}}', ["lights.floor", "file"]),
    ('{"materials": {"brass": {"model": "ggxx", "m": 0.1}}}', ["materials.brass.model", 'did you mean "ggx"']),
    ('{"materials": {"brass": {"model": "ggx", "m": 7}}}', ["materials.brass.m", "7"]),
    ('{"assign": [{"materiel": "brass"}]}', ["assign[0]", 'did you mean "material"']),
    ('{"assign": [{"index": 3}]}', ["assign[0].material"]),
    ('{"channels": {"normals": "N"}}', ["channels", 'did you mean "normal"']),
    ('{"camera": {"position": [0, 0]}, "aovs": "beauty.exr"}', ["camera"]),
    ('{"composite": {"gain": 1e999}}', ["64-bit"]),
    ('{"aovs": ' + "[" * 100000 + "]" * 100000 + "}", ["64 levels"]),
    ('{"output": {"file": "a\\u0000.exr"}}', ["output.file"]),
], ids=lambda value: value[:30] if isinstance(value, str) else "")
def test_a_typo_in_the_shot_file_is_named_with_its_path(composite, work, text, parts):
    (work / "shot.json").write_text(text)
    expect(composite(aovs="shot.json"), 2, "E_BAD_ARGUMENT", *parts, *(["shot.json"] if "camera" not in parts else []))


def test_a_material_file_that_nests_without_end(composite, work):
    (work / "deep.json").write_text("[" * 200000)
    expect(composite(material="deep.json"), 2, "E_BAD_ARGUMENT", "deep.json", "64 levels")


def test_a_material_that_creates_energy_is_warned_about(composite, work):
    (work / "hot.json").write_text('{"model": "ggx", "m": 0.1, "ks": 1.5}')
    result = composite(material="hot.json")
    assert result.code == 0 and "hot.json" in result.err and "creates energy" in result.err


@pytest.mark.parametrize("output, part", [
    ("beauty.exr", "the frame itself"), ("out/out.tif", ".exr"), ("out", ".exr")])
def test_an_output_that_cannot_be_meant(composite, output, part):
    expect(composite(output=output), 2, "E_BAD_ARGUMENT", part)


def test_an_output_folder_that_is_a_file(composite, work):
    expect(composite(output="sky.exr/out.exr"), 1, "E_WRITE_FAILED", "sky.exr/out.exr")


def test_an_output_that_is_a_folder(composite, work):
    (work / "folder.exr").mkdir()
    expect(composite(output="folder.exr"), 1, "E_WRITE_FAILED", "folder.exr")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_an_output_folder_without_permission(composite, work):
    (work / "locked").mkdir(mode=0o500)
    expect(composite(output="locked/out.exr"), 1, "E_WRITE_FAILED", "locked/out.exr")


def test_a_full_device(composite):
    expect(composite("--report", "/dev/full", output="out2/out.exr"), 1, "E_WRITE_FAILED", "/dev/full")


def test_a_failed_run_tells_its_own_error_not_the_reports(composite):
    expect(composite("--report", "/dev/full", env="absent.hdr"), 1, "E_READ_FAILED", "absent.hdr")


def test_a_disk_that_fills_up_leaves_the_old_file(composite, work):
    (work / "kept").mkdir()
    assert composite(output="kept/out.exr").code == 0
    before = (work / "kept/out.exr").read_bytes()

    def small_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (2000, 2000))

    result = composite(output="kept/out.exr", preexec_fn=small_files)
    assert result.code != 0
    assert (work / "kept/out.exr").read_bytes() == before and [p.name for p in (work / "kept").iterdir()] == ["out.exr"]


def test_an_unknown_colour_space(composite):
    expect(composite("--env-space", "ACEScgg"), 1, "E_COLOR_SPACE", "ACEScgg")
    expect(composite("--beauty-space", "sRGB"), 1, "E_COLOR_SPACE", "sRGB", "linear")
    expect(composite("--ocio-config", "absent.ocio"), 1, "E_COLOR_SPACE", "absent.ocio")


def bad_files():
    from conftest import DATA

    folder = DATA / "public/exr_bad"
    return sorted(path for path in folder.iterdir()) if folder.exists() else []


@pytest.mark.skipif(not bad_files(), reason="REAL DATA MISSING: public/exr_bad; set BURNISH_DATA")
@pytest.mark.parametrize("path", bad_files(), ids=lambda path: path.name[:40])
@pytest.mark.parametrize("use", ["frame", "light", "info"])
def test_files_that_broke_other_readers(cli, work, path, use):
    words = {
        "frame": ["composite", path, "--env", work / "sky.exr", "--material", "chrome", "-o", work / "out/out.exr"],
        "light": ["composite", work / "beauty.exr", "--env", path, "--material", "chrome", "-o", work / "out/out.exr"],
        "info": ["info", path],
    }[use]
    result = cli(*words, timeout=60)
    assert result.code in (0, 1), result.err
    if result.code == 1:
        assert result.error[0] in ("E_READ_FAILED", "E_MISSING_CHANNEL") and path.name in result.error[1]
        assert list((work / "out").iterdir()) == []


GONIO = "# burnish gonio 1\n# surface isotropic\n# values brdf\n# columns theta_i phi_i theta_o phi_o value\n"


@pytest.mark.parametrize("name, content, part", [
    ("a.binary", b"", "expected 34992012 bytes"),
    ("a.binary", b"\x5a\0\0\0" * 300, "Was it copied whole?"),
    ("a.brdf", b"1000000000\n400\n", "number of wavelengths"),
    ("a.brdf", b"31\n" + b"\xff" * 1000, "expected a number"),
    ("a.brdf", b"\0" * 100000, "expected a number"),
    ("a.alta", b"#DIM 1000000 3\n", "#PARAM_IN"),
    ("a.dat", b"#DIM 3 1\n#PARAM_IN RUSIN_TH_TD_PD\n#PARAM_OUT INV_STERADIAN\n1 nan 0 1\n", "finite number"),
    ("a.gonio", GONIO.encode() + b"10 0 20 0 inf\n", "finite number"),
    ("a.gonio", GONIO.encode() + b"91 0 20 0 1\n", "theta_i"),
    ("a.gonio", GONIO.encode(), "no row"),
], ids=range(10))
def test_measurements_that_are_none(composite, cli, work, name, content, part):
    (work / name).write_bytes(content)
    expect(composite(material=name), 1, "E_READ_FAILED", name, part)
    expect(cli("info", work / name), 1, "E_READ_FAILED", name, part)


def test_a_measurement_that_is_too_large(composite, work):
    with open(work / "big.gonio", "wb") as file:
        file.truncate(100 * GIGABYTE)
    expect(composite(material="big.gonio"), 1, "E_READ_FAILED", "big.gonio")


def test_a_measurement_with_every_value_alike(composite, work):
    rows = "".join(f"10 0 20 {phi} 1e9\n" for phi in [0] * 5000)
    (work / "same.gonio").write_text(GONIO + rows)
    assert composite(material="same.gonio").code == 0


@pytest.mark.parametrize("name, content, code, part", [
    ("a.glb", b"glTF\2\0\0\0" + b"\xff" * 12, "E_READ_FAILED", "cut short"),
    ("a.gltf", b'{"asset": {"version": "2.0"}, "materials": [{"extensions": 7}]}', "E_BAD_ARGUMENT", "materials[0].extensions"),
    ("a.mtlx", b"<materialx>" * 50000, "E_READ_FAILED", "XML"),
], ids=["glb", "gltf", "mtlx"])
def test_materials_of_other_programs_that_are_none(composite, work, name, content, code, part):
    (work / name).write_bytes(content)
    expect(composite(material=name), 1 if code == "E_READ_FAILED" else 2, code, name, part)


def test_a_material_without_its_table(composite, work):
    (work / "m.json").write_text(json.dumps({"model": "table", "table": "absent.binary"}))
    expect(composite(material="m.json"), 1, "E_READ_FAILED", "absent.binary")
    (work / "m.json").write_text(json.dumps({"model": "table"}))
    expect(composite(material="m.json"), 2, "E_BAD_ARGUMENT", "m.json.table")
