"""The Blender add-on, installed from its zip into a real Blender: every check of face_checks.py, in one run."""

import os
import pathlib
import re
import shutil
import subprocess

import pytest

HERE = pathlib.Path(__file__).resolve().parent
BUILD = pathlib.Path(os.environ.get("BURNISH_BUILD", HERE.parent.parent / "build" / "release")).resolve()
CHECKS = re.findall(r"@check\ndef (\w+)", (HERE / "face_checks.py").read_text())


def in_blender(command, script, folder, *arguments):
    """Run a script in a Blender that knows no other add-ons; returns what it printed."""
    if missing := [program for program in ("blender", command[0]) if not shutil.which(program)]:
        pytest.skip(f"{missing[0].upper()} MISSING: apt install blender xvfb xauth")
    user = {"HOME": folder, "BLENDER_USER_SCRIPTS": folder / "scripts", "BLENDER_USER_CONFIG": folder / "config"}
    for path in user.values():
        path.mkdir(exist_ok=True)
    (archive,) = (BUILD / "plugin").glob("burnish_addon-*.zip")
    run = subprocess.run([*command, "--factory-startup", "--python", HERE / script, "--", archive, folder, *arguments], text=True, timeout=300,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env={**os.environ, **{name: str(path) for name, path in user.items()}})
    return run.stdout


@pytest.fixture(scope="module")
def outcome(tmp_path_factory):
    """Check -> "ok" or what went wrong."""
    said = in_blender(["blender", "-b"], "face_checks.py", tmp_path_factory.mktemp("addon"))
    found = dict(re.findall(r"^CHECK (\w+): (.*)$", said, re.MULTILINE))
    assert found, said
    return found


@pytest.mark.parametrize("name", CHECKS)
def test_in_blender(outcome, name):
    assert outcome.get(name) == "ok", outcome.get(name, "did not run").encode().decode("unicode_escape")


def test_three_clicks_and_a_slider_in_a_window(tmp_path):
    screen = ["xvfb-run", "-a", "-s", "-screen 0 1600x900x24", "blender", "-W", "-p", "0", "0", "1600", "900"]
    said = in_blender(screen, "window.py", tmp_path)
    assert "WINDOW ok" in said, said
