"""burnish bandwidth: layers and pyramids of what is predicted of a frame, and a picture of the levels."""

import json

import numpy as np
import OpenImageIO as oiio
import pytest
import scenes

LAYERS = {"bandwidth.X": np.fmax, "level.X": np.fmin, "samples.X": np.fmax, "curvature.X": np.fmax, "nu_a.X": np.fmax}
COLORS = [(255, 255, 255), (255, 230, 51), (255, 140, 26), (217, 38, 26), (191, 38, 153), (115, 38, 179), (38, 64, 204), (20, 26, 102)]


@pytest.fixture
def job(tmp_path):
    """Arguments of a job over a sphere of 64 x 47 pixels, which halve to odd sizes."""
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere(64, 47), {"artist": "somebody"})
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    (tmp_path / "out").mkdir()
    return ["bandwidth", tmp_path / "beauty.exr", "--env", tmp_path / "sky.exr", "--material", "chrome", "--up", "z",
            "--pixel-type", "float", "-o", tmp_path / "out" / "out.exr"]


def parts(path):
    """Name -> channels of every part; not through an ImageBuf, which remembers older files of the same name."""
    result, file = {}, oiio.ImageInput.open(str(path))
    while file.seek_subimage(len(result), 0):
        pixels = file.read_image(oiio.FLOAT)
        result[file.spec().getattribute("oiio:subimagename")] = {
            name: pixels[..., i] for i, name in enumerate(file.spec().channelnames)}
    return result


def write_noisy_sky(folder):
    """As sharp everywhere as its pixels."""
    scenes.write_exr(folder / "sky.exr", ["R", "G", "B"], np.random.default_rng(1).random((256, 512, 1)) * np.ones(3))


def halved(fine, extreme):
    padded = np.pad(fine, [(0, size % 2) for size in fine.shape], constant_values=np.nan)
    rows = extreme(padded[0::2], padded[1::2])
    return extreme(rows[:, 0::2], rows[:, 1::2])


def test_every_level_holds_the_extremes_of_the_one_before(cli, job, tmp_path):
    assert cli(*job).code == 0
    levels = parts(tmp_path / "out" / "out.exr")
    assert list(levels) == [f"level_{k}" for k in range(7)]
    for name, extreme in LAYERS.items():
        expected = levels["level_0"][name]
        assert expected.shape == (47, 64)
        for k in range(1, 7):
            expected = halved(expected, extreme)
            assert np.array_equal(levels[f"level_{k}"][name], expected), (name, k)


def test_layers_say_one_thing(cli, job, tmp_path):
    result = cli(*job, "--json", "--report", tmp_path / "report.json")
    full = parts(tmp_path / "out" / "out.exr")["level_0"]
    hit = scenes.sphere(64, 47)["object_id"] > 0
    bandwidth, level = full["bandwidth.X"], full["level.X"]
    assert bandwidth[hit].min() > 0 and not bandwidth[~hit].any() and (level[~hit] == 5).all()
    assert np.array_equal(level[hit], np.clip(np.floor(-np.log2(2 * bandwidth[hit])), 0, 5))
    assert full["samples.X"][hit].mean() == pytest.approx(1, rel=1e-3)
    assert np.median(full["curvature.X"][hit]) == pytest.approx(1, rel=0.2)
    turn = bandwidth[hit] / full["nu_a.X"][hit]  # 2 c d' / cos and 1, times the pixel's angle
    assert turn.min() == pytest.approx(7 * np.tan(np.radians(22.5)) / 32, rel=0.1)
    assert json.loads((tmp_path / "report.json").read_text()) == json.loads(result.out)
    report, = json.loads(result.out)["frames"]
    assert report["pixels"] == hit.sum() == sum(report["levels"])
    assert report["grid_samples"] == pytest.approx((0.25 ** level[hit]).sum())


def test_a_rougher_lobe_wants_fewer_pixels(cli, job, tmp_path):
    write_noisy_sky(tmp_path)
    means = []
    for m in (0.02, 0.1, 0.4):
        (tmp_path / "m.json").write_text(json.dumps({"lobes": [{"model": "ggx", "m": m}]}))
        assert cli(*job, "--material", tmp_path / "m.json", "--prediction", "correlated").code == 0
        means.append(parts(tmp_path / "out" / "out.exr")["level_0"]["bandwidth.X"].mean())
    assert means[0] > 2 * means[1] > 4 * means[2]


def test_predictions_are_in_order_and_safety_multiplies(cli, job, tmp_path):
    def bandwidth(*more):
        assert cli(*job, *more).code == 0
        return parts(tmp_path / "out" / "out.exr")["level_0"]["bandwidth.X"]

    write_noisy_sky(tmp_path)
    job[5] = "rubber"
    correlated, source = bandwidth("--prediction", "correlated"), bandwidth("--prediction", "source")
    assert (source >= correlated).all() and source.mean() > correlated.mean()
    assert np.allclose(bandwidth("--prediction", "correlated", "--safety", "4"), 2 * correlated, rtol=1e-5)
    assert not np.array_equal(bandwidth("--prediction", "correlated", "--directions", "16"), correlated)
    assert not np.array_equal(bandwidth(), correlated)


def test_the_preview_shows_levels_in_their_colours(cli, job, tmp_path):
    preview = tmp_path / "out" / "levels.png"
    assert cli(*job, "--preview", preview).code == 0
    picture = oiio.ImageBuf(str(preview)).get_pixels(oiio.UINT8)
    level = parts(tmp_path / "out" / "out.exr")["level_0"]["level.X"]
    hit = scenes.sphere(64, 47)["object_id"] > 0
    assert picture.shape == (59, 64, 3) and not picture[:47][~hit].any()
    assert np.array_equal(picture[:47][hit], np.array(COLORS)[level[hit].astype(int)])
    assert np.array_equal(picture[55, 4::8], COLORS)
    words = cli("bandwidth", "--help").out
    assert "0 white, 1 yellow, 2 orange, 3 red, 4 magenta, 5 purple, 6 blue, 7+ dark blue; not shaded black" in words


def test_metadata_is_kept_and_bits_do_not_depend_on_threads(cli, job, tmp_path):
    out = tmp_path / "out" / "out.exr"
    assert cli(*job, "--threads", "1").code == 0
    one = out.read_bytes()
    assert cli(*job).code == 0
    assert out.read_bytes() == one
    spec = oiio.ImageBuf(str(out)).spec()
    assert spec.getattribute("artist") == "somebody" or spec.getattribute("Artist") == "somebody"
    assert "beauty.exr" in spec.getattribute("burnish/history")


def test_frames_progress_and_bad_frames(cli, job, tmp_path):
    for frame in (1, 3):
        (tmp_path / f"beauty.{frame:04d}.exr").write_bytes((tmp_path / "beauty.exr").read_bytes())
    words = [str(word).replace("beauty.exr", "beauty.####.exr").replace("out.exr", "out.####.exr") for word in job]
    result = cli(*words, "--frames", "1-3", "--bad-frames", "skip", "--progress", "text")
    assert result.code == 3 and "skipped: E_READ_FAILED" in result.out and "100 %" in result.err
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["out.0001.exr", "out.0003.exr"]
    stopped = cli(*words, "--frames", "2", "-q")
    assert stopped.code == 1 and stopped.error[1].startswith("frame=2 ")


@pytest.mark.parametrize("words, named", [
    (["--prediction", "guess"], "prediction"),
    (["--safety=-1"], "safety"),
    (["--directions", "many"], "directions"),
    (["--preview", "levels.jpg"], ".png"),
    (["--env", "nowhere.hdr"], "nowhere.hdr"),
])
def test_wrong_values_leave_nothing_behind(cli, job, tmp_path, words, named):
    result = cli(*job, *words)
    assert result.code in (1, 2) and named in result.error[1]
    assert list((tmp_path / "out").iterdir()) == []


def test_twelve_objects_of_cycles(cli, data, tmp_path):
    """Smooth objects want more pixels than rough ones of the same shape; nothing is predicted off the objects."""
    folder = data("cycles/spheres")
    rules = json.loads((folder / "spheres.json").read_text())
    rotation = rules["environment"]["mapping_node"]["rotation_z_deg"]
    medians = {}
    (tmp_path / "shot.json").write_text(json.dumps({
        "aovs": str(folder / "spheres.exr"),
        "lights": {"sky": {"type": "environment", "file": str(folder / "env_courtyard.exr"), "up": "z", "rotate": rotation}},
        "materials": {name: {"lobes": [{"model": "ggx", "m": m["alpha"]}]} for name, m in rules["materials"].items() if not m["anisotropy"]},
        "assign": [{"material": name, "material_index": m["pass_index"]} for name, m in rules["materials"].items() if not m["anisotropy"]],
        "output": {"file": str(tmp_path / "out.exr"), "pixel_type": "float"}}))
    result = cli("bandwidth", tmp_path / "shot.json", "--prediction", "correlated")
    assert result.code == 0, result.err
    full = parts(tmp_path / "out.exr")["level_0"]
    index = next(c for n, c in scenes.read_exr(folder / "spheres.exr").items() if n.endswith("IndexMA.X"))
    for name, m in rules["materials"].items():
        if not m["anisotropy"]:
            medians[name] = (m["alpha"], np.median(full["bandwidth.X"][index == m["pass_index"]]))
    smooth = [b for alpha, b in medians.values() if alpha <= 0.01]
    rough = [b for alpha, b in medians.values() if alpha >= 0.3]
    assert min(smooth) > 3 * max(rough)
    assert not full["bandwidth.X"][index == 0].any()
