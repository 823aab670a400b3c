"""burnish factor: maps that shade like the material they were made of, in files, shaders and Python."""

import json
import subprocess

import burnish
import numpy as np
import OpenImageIO as oiio
import pytest
import scenes
from conftest import PROGRAM

SKY = scenes.gradient_sky()
GOLD = {"lobes": [{"model": "ggx", "m": 0.2, "metal": "gold"}]}


def unit(v):
    return (v / np.linalg.norm(v, axis=1, keepdims=True)).astype(np.float32)


def seen_pairs(count, seed=1):
    """Normals all around, and views in front of them."""
    rng = np.random.default_rng(seed)
    n, wo = unit(rng.normal(size=(count, 3))), unit(rng.normal(size=(count, 3)))
    return n, np.where((n * wo).sum(1, keepdims=True) < 0, -wo, wo)


def above_surface(count, seed=1):
    """Pairs of directions with z > 0."""
    rng = np.random.default_rng(seed)
    return tuple(unit(rng.normal(size=(count, 3)) * [1, 1, 0] + [0, 0, 0.05] + abs(rng.normal(size=(count, 3))) * [0, 0, 1])
                 for _ in range(2))


@pytest.fixture(scope="module")
def gold():
    return burnish.factor(GOLD, SKY, quality="preview")


def test_the_maps_shade_like_the_material(gold):
    frame = scenes.sphere(32, 24)
    exact = burnish.composite(frame, SKY, GOLD, camera=scenes.CAMERA, estimator="reference")["overlay"]
    on_it = frame["object_id"] > 0
    n, p = frame["normal"][on_it], frame["position"][on_it]
    shaded = gold["factors"].evaluate(n, unit(np.array(scenes.CAMERA) - p))
    assert np.median(np.abs(shaded - exact[on_it]) / exact[on_it]) < 0.06
    assert gold["error"]["average_relative"] < 0.06 and gold["display_psnr_db"] > 26


def test_a_file_gives_the_maps_back(gold, tmp_path):
    gold["factors"].write(tmp_path / "gold.exr")
    again = burnish.read_factors(tmp_path / "gold.exr")
    assert again.maps == gold["factors"].maps == ["normal", "reflection", "elevation"]
    assert again.info == gold["factors"].info
    n, wo = seen_pairs(500)
    assert np.allclose(again.evaluate(n, wo), gold["factors"].evaluate(n, wo), rtol=3e-3)  # halves
    assert again.map("reflection").shape == (16, 32, 3)
    with pytest.raises(burnish.BadArgument, match="the maps are normal, reflection, elevation"):
        again.map("view")


def test_a_turned_and_brighter_light_has_the_same_maps(gold):
    turned = burnish.factor(GOLD, SKY, quality="preview", env_rotate=90, env_scale=3)["factors"]
    for name in turned.maps:
        assert np.array_equal(turned.map(name), gold["factors"].map(name))
    n, wo = seen_pairs(100)
    axes = np.array(turned.info["world_to_map"]) @ np.array(gold["factors"].info["world_to_map"]).T
    assert np.allclose(turned.evaluate(n, wo), 3 * gold["factors"].evaluate(unit(n @ axes), unit(wo @ axes)), rtol=1e-3)


def test_one_thread_gives_the_same_bits(gold):
    alone = burnish.factor(GOLD, SKY, quality="preview", threads=1)["factors"]
    assert all(np.array_equal(alone.map(name), gold["factors"].map(name)) for name in alone.maps)


def test_pictures_of_8_bits_keep_the_error(gold, tmp_path):
    report = burnish.factor(GOLD, SKY, tmp_path / "gold.exr", quality="preview", png=tmp_path / "maps", glsl=tmp_path / "gold.glsl")
    assert report["eight_bit_error"]["average_relative"] < report["error"]["average_relative"] + 0.01
    assert report["eight_bit_error"]["rms"] < 1.2 * report["error"]["rms"]
    assert sorted(path.name for path in (tmp_path / "maps").iterdir()) == [
        "gold.glsl", "gold.json", "gold_elevation.png", "gold_normal.png", "gold_reflection.png"]
    beside = json.loads((tmp_path / "maps" / "gold.json").read_text())
    assert beside["eight_bit"] == report["eight_bit"] and beside["parametrization"] == "nre"
    picture = oiio.ImageBuf(str(tmp_path / "maps" / "gold_normal.png"))
    assert picture.spec().nchannels == 4 and str(picture.spec().format) == "uint8"
    opaque = burnish.factor(GOLD, SKY, quality="preview", png=tmp_path / "opaque", alpha=False, prescale=[1, 1, 1, 1])
    assert report["eight_bit_error"]["average_relative"] < opaque["eight_bit_error"]["average_relative"]
    assert [term["prescale"] for term in opaque["eight_bit"]["terms"]] == [[1, 1, 1, 1]]


@pytest.fixture(scope="module")
def screen():
    """Where shaders run."""
    try:
        from offscreen import Offscreen

        return Offscreen()
    except OSError as error:
        pytest.skip(f"OPENGL MISSING: {error}; install libegl1 and libgl1-mesa-dri")


def textures(factors):
    return {f"burnish_{name}": factors.map(name) for name in factors.maps}


@pytest.mark.parametrize("parametrization", ["re", "nre", "nrhd"])
@pytest.mark.parametrize("mapping", ["double_parabolic", "cube"])
def test_the_shader_computes_what_the_maps_say(screen, parametrization, mapping):
    factors = burnish.factor(GOLD, SKY, quality="preview", parametrization=parametrization, mapping=mapping, terms=2, env_rotate=40,
                             env_tint=[1, 2, 3], grid=6)["factors"]
    n, wo = seen_pairs(2000)
    shaded, expected = screen.shade(factors.glsl(), textures(factors), n, wo), factors.evaluate(n, wo)
    off = np.abs(shaded - expected).max(1) / expected.mean()
    assert np.quantile(off, 0.98) < 2e-3 and off.max() < 0.2  # cube corners, where OpenGL blends three texels


def test_the_shader_of_8_bits_is_near(screen, tmp_path):
    report = burnish.factor(GOLD, SKY, tmp_path / "gold.exr", quality="preview", png=tmp_path)
    pictures = {f"burnish_{name}": texels(tmp_path / f"gold_{name}.png") for name in report["factors"].maps}
    n, wo = seen_pairs(2000)
    shaded, expected = screen.shade((tmp_path / "gold.glsl").read_text(), pictures, n, wo), report["factors"].evaluate(n, wo)
    assert np.median(np.abs(shaded - expected) / expected) < 0.01


def texels(file):
    """The bytes of a picture, which OpenImageIO would multiply by alpha."""
    config = oiio.ImageSpec()
    config.attribute("oiio:UnassociatedAlpha", 1)
    return oiio.ImageInput.open(str(file), config).read_image(format="uint8")


def told(*words, code=2):
    done = subprocess.run([PROGRAM, "factor", *map(str, words)], capture_output=True, text=True, timeout=60)
    assert done.returncode == code, done.stdout + done.stderr
    return done.stderr + done.stdout


def test_what_cannot_be_factored_is_told(tmp_path):
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], SKY)
    out = ["-o", tmp_path / "x.exr", "--quality", "preview"]
    brushed, layered = tmp_path / "brushed.json", tmp_path / "layered.json"
    brushed.write_text('{"model": "ggx", "mx": 0.1, "my": 0.3}')
    layered.write_text('{"model": "ggx", "m": 0.1, "per_pixel": ["roughness"]}')
    light = ["--env", tmp_path / "sky.exr"]
    for words, reason in ((["--material", brushed, *light], "anisotropic"),
                          (["--material", layered, *light], "roughness from a layer"),
                          (["--material", "gold", *light, "--parametrization", "pqp"], "leave out env"),
                          (["--material", "gold", "--parametrization", "nr"], "name an environment"),
                          (["--material", "gold", *light, "--png", tmp_path, "--parametrization", "nr", "--terms", "2"], "below zero"),
                          (["--material", "gold", *light, "--size", "3"], "4 to 1024"),
                          (["--material", "gold", *light, "--parametrization", "nrx"], "nrx")):
        assert reason in told(*words, *out)
    assert not list(tmp_path.glob("*x.exr"))
    with pytest.raises(burnish.BadArgument, match="did you mean \"parametrization\""):
        burnish.factor("gold", SKY, parametrisation_="nr")
    with pytest.raises(burnish.Cancelled):
        burnish.factor(GOLD, SKY, progress=lambda stage, done: False)


def test_the_command_line_reports(tmp_path):
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], SKY)
    report = json.loads(told("--material", "gold", "--env", tmp_path / "sky.exr", "-o", tmp_path / "gold.exr", "--quality", "preview",
                             "--json", code=0))
    assert report["files"] == [str(tmp_path / "gold.exr")] and report["samples"] > 1000
    assert set(report["seconds"]) == {"light", "sample", "factor", "check", "write"}
    assert burnish.read_factors(tmp_path / "gold.exr").info["made_of"]["material_name"] == "gold"
