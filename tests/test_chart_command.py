"""`burnish chart` as a command: what cannot be used, the stability suite, every layout of an installation."""

import json
import os
import subprocess
import sys

import burnish.chart
import numpy as np
import pytest
from burnish.stability.case import CASES, Outcome, case
from conftest import BUILD


@pytest.mark.parametrize("arguments, code, name, part", [
    (["--estimators", "--size", "many"], 2, "E_USAGE", "--size"),
    (["--estimators", "--stability"], 2, "E_USAGE", "not both"),
    (["--estimators", "--size", "4"], 2, "E_BAD_ARGUMENT", "[8, 1024], found 4"),
    (["--estimators", "--threads", "-1"], 2, "E_BAD_ARGUMENT", "--threads"),
    (["--estimators", "--materials", "ggx-0.3"], 2, "E_BAD_ARGUMENT", "there are beckmann-0.02"),
    (["--estimators", "--materials", "beckman-0.1"], 2, "E_BAD_ARGUMENT", "did you mean beckmann-0.1"),
    (["--estimators", "--lights", "stress-3"], 2, "E_BAD_ARGUMENT", "stress-2"),
    (["--estimators", "--env", "stress-1.hdr"], 2, "E_BAD_ARGUMENT", "two lights are called stress-1"),
    (["--estimators", "--env", "absent.hdr"], 1, "E_READ_FAILED", "absent.hdr"),
    (["--stability", "--cases", "no-such-case"], 2, "E_BAD_ARGUMENT", "no 'no-such-case'"),
    (["--fast"], 2, "E_BAD_ARGUMENT", "--fast: no such option"),
    (["absent.json"], 1, "E_READ_FAILED", "absent.json"),
    (["absent.json", "other.json", "--env-rotate", "3"], 2, "E_BAD_ARGUMENT", "go with one EXR"),
    (["absent.exr", "--materal", "gold"], 2, "E_BAD_ARGUMENT", "did you mean --material"),
    (["absent.exr", "--env", "sky.exr", "--material", "gold"], 1, "E_READ_FAILED", "absent.exr"),
    (["--data", "no/such/folder"], 1, "E_READ_FAILED", "name the folder"),
])
def test_what_cannot_be_used_is_one_line(cli, tmp_path, arguments, code, name, part):
    result = cli("chart", "-q", "-o", tmp_path / "out", *arguments)
    assert (result.code, result.error[0]) == (code, name) and part in result.error[1]
    assert not list(tmp_path.rglob("*.*"))


def test_a_folder_that_is_a_file_is_refused_before_measuring(cli, tmp_path):
    (tmp_path / "out").write_text("mine")
    result = cli("chart", "--estimators", "-o", tmp_path / "out" / "deeper")
    assert result.code == 1 and result.error[0] == "E_WRITE_FAILED" and "is a file" in result.error[1]


def test_help_says_what_the_figures_are_in(cli):
    text = cli("chart", "--help").out
    assert all(unit in text for unit in ("dB", "nanoseconds", "pixel", "seconds", "threads"))


@pytest.fixture
def two_cases():
    """A case that holds and one that does not."""
    def outcome(figure):
        return lambda: Outcome(figure, np.full((8, 8, 3), 0.5), "a <grey> square", (("half of it", np.float32(figure / 2)),))

    case("test-holds", "Whether grey is grey.", "dB", "because", at_least=30)(outcome(40.0))
    case("test-fails", "Whether 3 is 2.", "%", "it is not", at_most=2)(outcome(3.0))
    yield ["test-holds", "test-fails"]
    for name in ("test-holds", "test-fails"):
        del CASES[name]


def test_a_case_that_does_not_hold_is_shown_and_fails_the_run(two_cases, tmp_path, capsys):
    assert burnish.chart.main(["--stability", "--cases", *two_cases, "-o", str(tmp_path)]) == 1
    said = capsys.readouterr()
    assert "1 of 2 cases hold; these do not: test-fails" in said.out and "  1 of 2  test-holds" in said.err
    cases = json.loads((tmp_path / "stability.json").read_text())["cases"]
    assert [(entry["case"], entry["figure"], entry["holds"]) for entry in cases] == [("test-holds", 40, True), ("test-fails", 3, False)]
    assert cases[0]["details"] == [["half of it", 20]]
    page = (tmp_path / "stability.html").read_text()
    assert page.count("data:image/png") == 2 and "at most 2" in page and "a &lt;grey&gt; square" in page and "Whether 3 is 2." in page
    assert burnish.chart.main(["--stability", "-q", "--cases", "test-holds", "-o", str(tmp_path)]) == 0


def test_an_installed_burnish_finds_it(tmp_path):
    install = ["cmake", "--install", BUILD, "--component", "core", "--prefix", tmp_path]
    assert subprocess.run(install, capture_output=True).returncode == 0
    program = [tmp_path / "bin" / "burnish", "chart", "--estimators", "-o", tmp_path / "o", "--size", "4"]
    done = subprocess.run(program, capture_output=True, text=True, env={"PATH": os.defpath}, cwd=tmp_path)
    assert "E_BAD_ARGUMENT --size" in done.stderr


def test_the_module_runs_it_too(tmp_path):
    command = [sys.executable, "-m", "burnish.chart", "--estimators", "-o", tmp_path, "--size", "4"]
    environment = {**os.environ, "PYTHONPATH": str(BUILD / "python")}
    done = subprocess.run(command, capture_output=True, text=True, env=environment)
    assert done.returncode == 2 and "E_BAD_ARGUMENT --size" in done.stderr
