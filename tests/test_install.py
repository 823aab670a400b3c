"""pip installs the package: module, library, command line and types in one folder that needs no build tree."""

import os
import subprocess
import sys

import pytest
from conftest import BUILD, SOURCE


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """A folder that pip installed burnish into, from the build under test."""
    folder = tmp_path_factory.mktemp("site")
    words = [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--target", folder, SOURCE]
    environment = {**os.environ, "BURNISH_BUILD": str(BUILD), "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    done = subprocess.run(words, capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


def test_the_package_works_from_where_pip_put_it(site):
    code = "import burnish; print(burnish.__file__, burnish.Lobe({'model': 'ggx', 'm': 0.1}).D([[0, 0, 1]]))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env={"PYTHONPATH": str(site)}, cwd=site)
    assert done.returncode == 0, done.stderr
    assert str(site) in done.stdout
    assert (site / "burnish/py.typed").exists() and (site / "burnish/_core.pyi").exists()


@pytest.mark.parametrize("words", [["bin/burnish"], [sys.executable, "-m", "burnish"]])
def test_the_command_line_comes_with_it(site, words):
    done = subprocess.run([*words, "--version"], capture_output=True, text=True, env={"PYTHONPATH": str(site)}, cwd=site)
    assert done.returncode == 0 and done.stdout.startswith("burnish "), done.stderr


@pytest.mark.parametrize("words", [["bin/burnish", "chart"], [sys.executable, "-m", "burnish", "chart"], ["bin/burnish-chart"]])
def test_the_chart_comes_with_it(site, words):
    done = subprocess.run([*words, "--help"], capture_output=True, text=True, env={"PYTHONPATH": str(site)}, cwd=site)
    assert done.returncode == 0 and "--estimators" in done.stdout, done.stderr


def test_no_library_is_looked_for_in_the_build(site):
    for path in (site / "burnish").rglob("*.so*"):
        headers = subprocess.run(["objdump", "-p", path], capture_output=True, text=True).stdout
        assert str(BUILD) not in headers
