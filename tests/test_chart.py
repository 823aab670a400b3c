"""`burnish chart`: the measures, the files, the errors, and that all layouts of an installation find it."""

import csv
import os
import re
import shlex
import signal
import struct
import subprocess
import sys

import burnish
import numpy as np
import pytest
from burnish.charting import benchmark, measure
from conftest import BUILD, PROGRAM, SOURCE

COLUMNS = ["light", "material", "kind", "estimator", "samples", "lookups", "relative_rms", "relative_rms_beyond_75_deg",
           "psnr_db", "reference_relative_rms", "reference_lookups", "shading_ns_per_pixel", "tables_s"]
MATERIALS = ("beckmann-0.1", "ggx-0.1")


@pytest.fixture(scope="module")
def chart(tmp_path_factory):
    """The folder that a quick run on two materials leaves behind, and what it printed."""
    folder = tmp_path_factory.mktemp("chart")
    words = ["chart", "--estimators", "--quick", "--materials", *MATERIALS, "--lights", "stress-1", "-o", folder]
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return folder, done.stdout


@pytest.fixture
def rows(chart):
    """The lines of its CSV."""
    with open(chart[0] / "estimators.csv", newline="") as file:
        reader = csv.DictReader(file)
        assert reader.fieldnames == COLUMNS
        return list(reader)


def test_every_estimator_material_and_light_has_its_line(rows):
    found = [(row["material"], row["estimator"], int(row["samples"])) for row in rows]
    sweep = [(estimator, n) for estimator, counts in benchmark.LOOKUPS.items() for n in counts]
    assert found == [(name, *setting) for name in MATERIALS for setting in sweep]
    assert {row["light"] for row in rows} == {"stress-1"}


def test_the_figures_make_sense(rows):
    for name in MATERIALS:
        of_material = [row for row in rows if row["material"] == name]
        error = {(row["estimator"], row["samples"]): float(row["relative_rms"]) for row in of_material}
        assert error["fitted", "4"] < error["regular", "4"] < error["filtered_importance", "4"]
        assert error["fitted", "4"] < error["fitted", "1"] and error["regular", "61"] < error["regular", "4"]
    for row in rows:
        assert 0 < float(row["reference_relative_rms"]) < 0.05 and float(row["reference_lookups"]) >= 2048
        assert 0 < float(row["relative_rms"]) < 1 and 10 < float(row["psnr_db"]) < 60
        assert 1 < float(row["shading_ns_per_pixel"]) < 1e5 and 0 < float(row["tables_s"]) < 10


def test_the_summary_names_every_estimator(chart):
    assert all(re.search(rf"^{estimator} +\d of 2 ", chart[1], re.MULTILINE) for estimator in benchmark.LOOKUPS)


def test_the_picture_is_a_png_with_ink_in_every_colour(chart):
    import matplotlib.colors
    import matplotlib.image
    from burnish.charting import picture

    file = chart[0] / "estimators.png"
    head = file.read_bytes()[:24]
    assert head[:8] == b"\x89PNG\r\n\x1a\n"
    assert struct.unpack(">II", head[16:]) == (1600, picture.HEAD_PX + 2 * picture.ROW_PX + picture.FOOT_PX)
    pixels = matplotlib.image.imread(file)[..., :3]
    for colour in picture.COLOURS.values():
        assert (abs(pixels - matplotlib.colors.to_rgb(colour)).max(-1) < 0.02).sum() > 100, colour
    assert sorted(path.name for path in chart[0].iterdir()) == ["estimators.csv", "estimators.png"]


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


def test_the_stress_light_spans_its_contrast():
    light = benchmark.stress_light(1)
    assert light.shape == (512, 1024, 3) and light.min() == 1 and 1000 < light.max() <= 3000
    assert np.array_equal(light, benchmark.stress_light(1)) and not np.array_equal(light, benchmark.stress_light(2))


@pytest.mark.parametrize("words, code, name, part", [
    ([], 2, "E_USAGE", "--estimators"),
    (["--estimators", "--size", "many"], 2, "E_USAGE", "--size"),
    (["--estimators", "--size", "4"], 2, "E_BAD_ARGUMENT", "[8, 1024], found 4"),
    (["--estimators", "--threads", "-1"], 2, "E_BAD_ARGUMENT", "--threads"),
    (["--estimators", "--materials", "ggx-0.3"], 2, "E_BAD_ARGUMENT", "there are beckmann-0.02"),
    (["--estimators", "--materials", "beckman-0.1"], 2, "E_BAD_ARGUMENT", "did you mean beckmann-0.1"),
    (["--estimators", "--lights", "stress-3"], 2, "E_BAD_ARGUMENT", "stress-2"),
    (["--estimators", "--env", "stress-1.hdr"], 2, "E_BAD_ARGUMENT", "two lights are called stress-1"),
    (["--estimators", "--env", "absent.hdr"], 1, "E_READ_FAILED", "absent.hdr"),
])
def test_what_cannot_be_used_is_one_line(cli, tmp_path, words, code, name, part):
    result = cli("chart", "-o", tmp_path / "out", *words)
    assert (result.code, result.error[0]) == (code, name) and part in result.error[1]
    assert not (tmp_path / "out").exists()


def test_a_folder_that_is_a_file_is_refused_before_measuring(cli, tmp_path):
    (tmp_path / "out").write_text("mine")
    result = cli("chart", "--estimators", "-o", tmp_path / "out" / "deeper")
    assert result.code == 1 and result.error[0] == "E_WRITE_FAILED" and "is a file" in result.error[1]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_stopped_run_leaves_nothing(tmp_path, number):
    words = [PROGRAM, "chart", "--estimators", "-o", tmp_path / "out"]
    run = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    run.stderr.read(1)  # progress: it is measuring
    run.send_signal(number)
    assert "E_CANCELLED" in run.communicate(timeout=30)[1].splitlines()[-1]
    assert run.returncode == 128 + number and list(tmp_path.iterdir()) == []


def test_help_says_what_the_figures_are_in(cli):
    text = cli("chart", "--help").out
    assert all(unit in text for unit in ("dB", "nanoseconds", "pixel", "seconds", "threads"))


def test_the_command_of_the_readme_runs(tmp_path):
    command = re.search(r"^burnish (chart .*)$", (SOURCE / "README.md").read_text(), re.MULTILINE).group(1)
    done = subprocess.run([PROGRAM, *shlex.split(command)], capture_output=True, text=True, cwd=tmp_path, timeout=120)
    assert done.returncode == 0, done.stderr
    assert len(list(tmp_path.rglob("estimators.*"))) == 2


def test_an_installed_burnish_finds_it(tmp_path):
    install = ["cmake", "--install", BUILD, "--component", "core", "--prefix", tmp_path]
    assert subprocess.run(install, capture_output=True).returncode == 0
    program = [tmp_path / "bin" / "burnish", "chart", "--estimators", "-o", tmp_path / "o", "--size", "4"]
    done = subprocess.run(program, capture_output=True, text=True, env={"PATH": os.defpath}, cwd=tmp_path)
    assert "E_BAD_ARGUMENT --size" in done.stderr


def test_the_module_runs_it_too(tmp_path):
    words = [sys.executable, "-m", "burnish.chart", "--estimators", "-o", tmp_path, "--size", "4"]
    environment = {**os.environ, "PYTHONPATH": str(BUILD / "python")}
    done = subprocess.run(words, capture_output=True, text=True, env=environment)
    assert done.returncode == 2 and "E_BAD_ARGUMENT --size" in done.stderr
