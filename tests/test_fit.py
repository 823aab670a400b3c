"""Tables and fits from the command line and Python: known materials are tabulated, fitted, and found again."""

import json
import subprocess

import burnish
import numpy as np
import pytest
from conftest import PROGRAM

KURT = {"kd": 0.2, "lobes": [{"model": "kurt", "ks": 0.6, "m": 0.12, "r0": 0.3, "alpha": 0.4}]}
SHEET = {"kd": 0.4, "lobes": [{"model": "kurt", "ks": 0.5, "m": 0.15, "r0": 0.1, "alpha": 0.4},
                              {"model": "kurt", "kt": 0.4, "m": 0.25, "r0": 0.1, "alpha": 0.4}]}


def run(*words, code=0):
    """What the program prints; its exit code must be `code`."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, timeout=300)
    assert done.returncode == code, done.stderr
    return done.stdout + done.stderr


def tabulated(folder, name, material):
    """A material as a table."""
    (folder / "known.json").write_text(json.dumps(material))
    run("tabulate", folder / "known.json", "-o", folder / name)
    return folder / name


@pytest.fixture(scope="module")
def kurt(tmp_path_factory):
    """The known lobe as a text of pairs, and the folder of its fit."""
    folder = tmp_path_factory.mktemp("kurt")
    table = tabulated(folder, "kurt.gonio", KURT)
    run("fit", table, "-o", folder / "fit.json", "--model", "kurt", "--report", folder / "report.json")
    return folder


def test_a_known_lobe_is_found_again(kurt):
    found = json.loads((kurt / "fit.json").read_text())
    (lobe,) = found["lobes"]
    assert lobe["mx"] == pytest.approx(0.12, rel=0.02) and lobe["alpha"] == pytest.approx(0.4, abs=0.02)
    assert lobe["ks"] * lobe["r0"] == pytest.approx(0.18, rel=0.02)
    assert np.allclose(found["kd"], 0.2, rtol=0.02)


def test_the_fit_is_a_material_that_renders(kurt):
    image = burnish.preview(str(kurt / "fit.json"), size=48)
    assert image.shape[:2] == (48, 48) and np.isfinite(image).all() and image.max() > 0


def test_the_report_holds_data_and_fit_side_by_side(kurt):
    report = json.loads((kurt / "report.json").read_text())
    pairs = [curve for curve in report["curves"] if curve["kind"] == "pairs"]
    assert pairs and all(len(c["data"]) == len(c["fit"]) == len(c["data_deg"]) for c in pairs)
    assert np.allclose(pairs[0]["data"], pairs[0]["fit"], rtol=0.1, atol=0.01)
    assert all(max(residual["relative"]) < 0.02 for residual in report["residuals"])
    assert report["errors"]["lobes"] == 1 and report["errors"]["seconds"] > 0


def test_plots_are_pictures(kurt):
    folder = kurt / "plots"
    told = run("fit", kurt / "kurt.gonio", "-o", kurt / "again.json", "--model", "kurt", "--plots", folder)
    for name in ("slices", "lobes", "balls"):
        assert str(folder / f"{name}.png") in told
        assert (folder / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    assert json.loads((folder / "report.json").read_text())["material"]


def test_python_fits_as_the_command_line_does(kurt):
    stages = []
    report = burnish.fit(kurt / "kurt.gonio", "kurt", progress=lambda stage, done: stages.append(done) or True)
    assert report["material"] == json.loads((kurt / "fit.json").read_text())
    assert stages == sorted(stages) and stages[-1] <= 1
    with pytest.raises(burnish.Cancelled):
        burnish.fit(kurt / "kurt.gonio", "kurt", progress=lambda stage, done: False)


def test_bounds_are_kept(kurt):
    fixed = burnish.fit(kurt / "kurt.gonio", "kurt", bounds={"alpha": 0, "m": (0.13, 0.5)})["material"]["lobes"][0]
    assert fixed["alpha"] == 0 and fixed["mx"] >= 0.13
    told = run("fit", kurt / "kurt.gonio", "-o", kurt / "x.json", "--model", "kurt", "--fix", "breadth=1", code=2)
    assert "breadth" in told and not (kurt / "x.json").exists()


def test_transmission_is_fitted_too(tmp_path):
    table = tabulated(tmp_path, "sheet.gonio", SHEET)
    lobes = burnish.fit(table, "kurt")["material"]["lobes"]
    (through,) = [lobe for lobe in lobes if "kt" in lobe]
    assert through["mx"] == pytest.approx(0.25, rel=0.05) and len(lobes) == 2


def test_a_library_table_is_fitted_by_its_own_model(tmp_path):
    run("tabulate", "merl:gold-paint", "-o", tmp_path / "gold.binary")
    told = run("fit", tmp_path / "gold.binary", "-o", tmp_path / "gold.json", "--plots", tmp_path)
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["errors"]["model"] == "sgd" and report["errors"]["normalised_l2"] < 1e-3
    assert len(report["tried"]) > 1 and "<- taken" in told
    assert {curve["kind"] for curve in report["curves"]} == {"half", "difference", "lobe"}


def test_a_merl_table_refuses_what_it_cannot_hold(tmp_path):
    told = run("tabulate", "brushed-steel", "-o", tmp_path / "x.binary", code=2)
    assert "anisotropic" in told and ".gonio" in told


@pytest.mark.parametrize("words, complaint", [
    (["--bound", "m=1"], "NAME=MIN:MAX"), (["--bound", "m=2:1"], "smaller"), (["--fix", "m=wide"], "expected a number"),
    (["--lobes", "9"], "lobes"), (["--model", "kurd"], "kurd")])
def test_wrong_words_are_told(kurt, words, complaint):
    assert complaint in run("fit", kurt / "kurt.gonio", "-o", kurt / "x.json", *words, code=2)


def test_what_is_no_report_is_refused(tmp_path):
    (tmp_path / "no.json").write_text("{}")
    assert "expected a report" in run("fit-plots", tmp_path / "no.json", "-o", tmp_path, code=2)


@pytest.mark.parametrize("file, told", [
    ("cayman.brdf", None), ("garnet_red.brdf", None), ("mystique.brdf", "colour changes with the angle"),
    ("retro-3M-jaune.dat", "reflects back towards the light; no model here does that")])
def test_what_no_model_shows_is_said(data, file, told):
    """Real lacquers, one of them with interference pigments, and a retro-reflective tape."""
    notes = " ".join(burnish.fit(data(f"public/brdf_measured/{file}"))["notes"])
    assert (told or "lobes") in notes
    assert told is not None or "no model here" not in notes


def test_lobes_that_gain_little_are_left_out(data):
    """A second lobe on the tape gains more than its noise, but not what its numbers are worth."""
    report = burnish.fit(data("public/brdf_measured/retro-3M-jaune.dat"))
    assert report["errors"]["lobes"] == 1 and "which does not pay" in " ".join(report["notes"])
