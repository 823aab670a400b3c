"""`burnish chart`: fronts and measures, the files, going on after a stop, and the chart of the estimators."""

import csv
import dataclasses
import json
import re
import signal
import struct
import subprocess

import burnish
import numpy as np
import pytest
import scenes
from burnish.charting import bench, benchmark, front, measure, shots, store, table, words
from burnish.charting.setting import Setting
from conftest import PROGRAM

ESTIMATOR_COLUMNS = [field.name for field in dataclasses.fields(table.EstimatorRow)]
BALLS = ("beckmann-0.1", "ggx-0.1")


def chart(*arguments, **options):
    """A run of the command that is expected to end well."""
    done = subprocess.run([PROGRAM, "chart", *map(str, arguments)], capture_output=True, text=True, timeout=120, **options)
    assert done.returncode == 0, done.stderr
    return done


@pytest.fixture(scope="module")
def shot(tmp_path_factory):
    """A shot of a sphere that wears gold on its left and something rough on its right, under a gradient with a lamp."""
    folder = tmp_path_factory.mktemp("shot")
    frame = scenes.sphere(40, 30)
    frame["object_id"] *= 1 + (np.arange(40) >= 20)
    scenes.write_frame(folder / "frame.exr", frame)
    scenes.write_exr(folder / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    shot = {"aovs": "frame.exr", "camera": scenes.CAMERA_JSON, "lights": {"sky": {"type": "environment", "file": "sky.exr", "up": "z"}},
            "materials": {"rough": {"model": "ggx", "m": 0.3}}, "assign": ["gold=index:1", {"material": "rough", "index": 2}]}
    (folder / "shot.json").write_text(json.dumps(shot))
    return folder / "shot.json"


@pytest.fixture(scope="module")
def charted(shot, tmp_path_factory):
    """The folder that a quick chart of it leaves behind, and what it said."""
    folder = tmp_path_factory.mktemp("chart") / "out"
    return folder, chart(shot, "--quick", "-o", folder)


@pytest.fixture(scope="module")
def rows(charted):
    return json.loads((charted[0] / "rows.json").read_text())["rows"]


def test_every_material_and_the_whole_frame_are_charted(charted, rows):
    assert sorted(path.name for path in charted[0].iterdir()) == ["measured", "report.html", "rows.csv", "rows.json"]
    assert list(dict.fromkeys(row["material"] for row in rows)) == ["gold", "rough", "whole frame"]
    pixels = {row["material"]: row["pixels"] for row in rows}
    assert pixels["gold"] + pixels["rough"] == pixels["whole frame"]
    for name in pixels:
        of_material = [row for row in rows if row["material"] == name]
        assert {row["estimator"] for row in of_material} == set(benchmark.LOOKUPS)
        assert {row["density"] for row in of_material} == {"dense", "sparse"} and {"full", "half"} == {row["face"] for row in of_material}
        assert [row["density"] for row in of_material if row["is_default"]] == ["dense"]  # a small frame under distant light


def test_its_figures_make_sense(rows):
    best = {}
    for row in rows:
        assert 10 < row["psnr_db"] <= row["reference_ceiling_db"] and 0 <= row["relative_rms"] < 1
        assert row["frame_s"] == pytest.approx(row["surface_s"] + row["shading_s"] + row["composite_s"])
        assert row["alone_s"] == pytest.approx(row["frame_s"] + row["light_s"] + row["light_tables_s"] + row["tables_s"])
        assert 0 < row["shaded"] <= row["pixels"] and row["lookups"] >= 1 and row["reference_lookups"] >= 2048
        assert row["face_size"] == {"full": 16, "half": 8}[row["face"]]
        best[row["estimator"]] = max(best.get(row["estimator"], 0), row["psnr_db"])
    assert best["fitted"] > 40 and best["fitted"] > best["split_sum"]


def test_the_csv_holds_the_same_rows(charted, rows):
    with open(charted[0] / "rows.csv", newline="") as file:
        lines = list(csv.DictReader(file))
    assert [(line["material"], line["estimator"], int(line["samples"])) for line in lines] == [
        (row["material"], row["estimator"], row["samples"]) for row in rows]
    assert list(lines[0]) == list(rows[0])


def test_the_report_needs_no_other_file(charted):
    page = (charted[0] / "report.html").read_text()
    assert all(link.startswith("data:") for link in re.findall(r"""(?:src|href)=["']?([^"'> ]*)""", page)) and "://" not in page
    assert page.count("data:image/png") >= 1 + 4  # fronts; reference, default, rivals in its time and at 40 dB
    for told in ("regret", "gold", "whole frame", "At 40 dB", "lookups at the most"):
        assert told in page


def test_what_is_measured_is_not_measured_again(shot, charted, rows):
    assert f"{len(rows)} settings, {len(rows)} of them" in charted[1].stdout and "left" in charted[1].stderr
    again = chart(shot, "--quick", "-o", charted[0])
    assert f"{len(rows)} settings, 0 of them" in again.stdout
    assert json.loads((charted[0] / "rows.json").read_text())["rows"] == rows


def test_a_stopped_chart_goes_on(shot, tmp_path):
    words = [PROGRAM, "chart", shot, "--quick", "-o", tmp_path / "out", "--materials", "gold"]
    run = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    run.stderr.readline()  # progress: a setting is measured
    run.send_signal(signal.SIGINT)
    assert "E_CANCELLED" in run.communicate(timeout=60)[1].splitlines()[-1] and run.returncode == 130
    kept = json.loads((tmp_path / "out" / "rows.json").read_text())["rows"]
    told = re.match(r"(\d+) settings, (\d+) of", chart(*words[2:]).stdout)
    assert 0 < len(kept) < int(told[1]) and int(told[2]) == int(told[1]) - len(kept)
    assert json.loads((tmp_path / "out" / "rows.json").read_text())["rows"][: len(kept)] == kept


def test_rows_of_other_settings_are_left_aside(shot, charted, tmp_path):
    (tmp_path / "out" / "measured").mkdir(parents=True)
    (tmp_path / "out" / "measured" / "rows.jsonl").write_bytes((charted[0] / "measured" / "rows.jsonl").read_bytes())
    other = chart(shot, "--quick", "--threads", "1", "--materials", "gold", "-o", tmp_path / "out")
    assert "rows are of another version, other settings or other shots" in other.stderr
    assert {row["threads"] for row in json.loads((tmp_path / "out" / "rows.json").read_text())["rows"]} == {1}


def test_an_exr_with_settings_is_a_shot(shot):
    found = words.settings_of(["--up", "z", "--assign", "gold=index:1", "--assign=copper=index:2", "--env-rotate", "30"])
    assert found == {"up": "z", "assign": ["gold=index:1", "copper=index:2"], "env_rotate": 30}
    picture = {"aovs": str(shot.parent / "frame.exr"), "env": str(shot.parent / "sky.exr"), **found}
    scene = shots.source_of("frame", picture | {"camera": json.dumps(scenes.CAMERA_JSON)}).load()
    assert [part.name for part in scene.parts] == ["gold", "copper", "whole frame"]
    parts = [scene.shade(part, Setting("fitted", 4, "dense"))["overlay"] for part in scene.parts]
    assert np.allclose(parts[0] + parts[1], parts[2], atol=1e-5) and parts[2].max() > 0.1


LAMP = {"lamp": {"type": "area", "corners": [[-1, -1, 3], [-1, 1, 3], [1, 1, 3], [1, -1, 3]], "radiance": 5}}


@pytest.mark.parametrize("settings, density", [
    ({}, "dense"),
    ({"density": "sparse"}, "sparse"),
    ({"estimator": "filtered_importance", "samples": 32}, "sparse"),
    ({"lights": LAMP}, "sparse"),
    ({"lights": LAMP, "estimator": "reference"}, "dense"),
    ({"lights": LAMP, "default_light": "sky"}, "dense"),
    ({"lights": LAMP, "default_light": "sky", "assign": ["gold=index:1@lamp", "copper=index:2"]}, "sparse"),
])
def test_the_default_is_what_burnish_would_shade_with(shot, settings, density):
    frame, sky = str(shot.parent / "frame.exr"), str(shot.parent / "sky.exr")
    job = {"camera": json.dumps(scenes.CAMERA_JSON), "up": "z", "assign": ["gold=index:1", "copper=index:2"], "tolerance": 0.1, **settings}
    assert shots.source_of("frame", {"aovs": frame, "env": sky, **job}).load().own.density == density
    layers = burnish.composite(frame, sky, **job)
    assert (layers["samples"][layers["validity"] == 0] == 0).any() == (density == "sparse")


def test_a_row_cut_off_by_the_end_of_a_run_is_measured_anew(charted, tmp_path):
    (tmp_path / "measured").mkdir()
    lines = (charted[0] / "measured" / "rows.jsonl").read_text().splitlines()
    (tmp_path / "measured" / "rows.jsonl").write_text("\n".join(lines[:3])[:-40])
    kept = store.Store(tmp_path)
    assert len(kept.rows) == 2
    kept.add("digest", next(iter(kept.rows.values())))
    assert len(store.Store(tmp_path).rows) == 3


def row_at(ms, db, default=False):
    named = {field.name: 0 for field in dataclasses.fields(bench.Row)}
    return bench.Row(**named | dict(frame_s=1e-3 * ms, psnr_db=db, is_default=default))


def test_the_front_holds_what_nothing_beats():
    points = [(1, 30), (2, 40), (2, 35), (3, 38), (4, 45), (5, 45)]
    rows = [row_at(*point) for point in points]
    assert [points[rows.index(row)] for row in front.front_of(rows)] == [(1, 30), (2, 40), (4, 45)]
    assert front.cheapest(rows, 39).psnr_db == 40 and front.cheapest(rows, 50) is None
    regret = front.regret_of([*rows, row_at(6, 39, default=True)])
    assert regret.slower == pytest.approx(3) and regret.lost_db == 6


def test_the_display_psnr_is_the_one_of_compare():
    random = np.random.default_rng(3)
    truth, test = random.gamma(1, 2, (2, 40, 50, 3)).astype(np.float32)
    exact = measure.Truth(truth.reshape(-1, 3), np.zeros((2000, 3)))
    assert exact.psnr_db(test.reshape(-1, 3)) == pytest.approx(burnish.compare(test, truth)["psnr_db"], abs=1e-3)
    assert exact.psnr_db(truth.reshape(-1, 3)) == np.inf


def test_the_references_noise_is_taken_out():
    random = np.random.default_rng(4)
    exact = random.uniform(0.1, 1, (100000, 3))
    sigma, error = 0.05 * exact, 0.04
    truth = measure.Truth(exact + sigma * random.standard_normal(exact.shape), sigma)
    estimate = exact * (1 + error * random.standard_normal(exact.shape))
    clean = measure.Truth(exact, 0 * exact)
    assert truth.relative_rms(estimate) == pytest.approx(error, rel=0.03)
    assert truth.psnr_db(estimate) == pytest.approx(clean.psnr_db(estimate), abs=0.3)
    assert truth.psnr_db(exact) > truth.ceiling_db() > truth.psnr_db(estimate)


def test_pixels_are_drawn_one_in_each_block():
    mask = np.zeros((60, 90), bool)
    mask[:, :70] = True
    pixels, edge = measure.jittered(mask, 500)
    y, x = np.divmod(pixels, 90)
    assert edge == 2 and mask[y, x].all() and len(pixels) == pytest.approx(60 * 70 / 4, rel=0.03)
    assert len(set(zip(y // 2, x // 2))) == len(pixels) and abs((x % 2).mean() - 0.5) < 0.05


def test_the_stress_light_spans_its_contrast():
    light = benchmark.stress_light(1)
    assert light.shape == (512, 1024, 3) and light.min() == 1 and 1000 < light.max() <= 3000
    assert np.array_equal(light, benchmark.stress_light(1)) and not np.array_equal(light, benchmark.stress_light(2))


@pytest.fixture(scope="module")
def estimators(tmp_path_factory):
    """The folder that a quick chart of the estimators on two materials leaves behind, and what it printed."""
    folder = tmp_path_factory.mktemp("estimators")
    words = ["--estimators", "--quick", "--materials", *BALLS, "--lights", "stress-1", "-o", folder]
    return folder, chart(*words).stdout


@pytest.fixture
def lines(estimators):
    """The lines of its CSV."""
    with open(estimators[0] / "estimators.csv", newline="") as file:
        reader = csv.DictReader(file)
        assert reader.fieldnames == ESTIMATOR_COLUMNS
        return list(reader)


def test_every_estimator_material_and_light_has_its_line(lines):
    found = [(row["material"], row["estimator"], int(row["samples"])) for row in lines]
    sweep = [(estimator, n) for estimator, counts in benchmark.LOOKUPS.items() for n in counts]
    assert found == [(name, *setting) for name in BALLS for setting in sweep]
    assert {row["light"] for row in lines} == {"stress-1"}


def test_the_figures_of_estimators_make_sense(lines):
    for name in BALLS:
        of_material = [row for row in lines if row["material"] == name]
        error = {(row["estimator"], row["samples"]): float(row["relative_rms"]) for row in of_material}
        assert error["fitted", "4"] < error["regular", "4"] < error["filtered_importance", "4"]
        assert error["fitted", "4"] < error["fitted", "1"] and error["regular", "61"] < error["regular", "4"]
    for row in lines:
        assert 0 < float(row["reference_relative_rms"]) < 0.05 and float(row["reference_lookups"]) >= 2048
        assert 0 < float(row["relative_rms"]) < 1 and 10 < float(row["psnr_db"]) < 60
        assert 1 < float(row["shading_ns_per_pixel"]) < 1e5 and 0 < float(row["tables_s"]) < 10


def test_the_summary_names_every_estimator(estimators):
    assert all(re.search(rf"^{estimator} +\d of 2 ", estimators[1], re.MULTILINE) for estimator in benchmark.LOOKUPS)


def test_the_picture_is_a_png_with_ink_in_every_colour(estimators):
    import matplotlib.colors
    import matplotlib.image
    from burnish.charting import picture

    file = estimators[0] / "estimators.png"
    head = file.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    assert struct.unpack(">II", head[16:]) == (1600, picture.HEAD_PX + 2 * picture.ROW_PX + picture.FOOT_PX)
    pixels = matplotlib.image.imread(file)[..., :3]
    for colour in picture.COLOURS.values():
        assert (abs(pixels - matplotlib.colors.to_rgb(colour)).max(-1) < 0.02).sum() > 100, colour
    assert sorted(path.name for path in estimators[0].iterdir()) == ["estimators.csv", "estimators.png", "measured"]
