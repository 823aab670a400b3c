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


@pytest.fixture(scope="module")
def outcome(tmp_path_factory):
    """Check -> "ok" or what went wrong."""
    blender = shutil.which("blender")
    if not blender:
        pytest.skip("BLENDER MISSING: apt install blender")
    folder = tmp_path_factory.mktemp("addon")
    user = {"HOME": folder, "BLENDER_USER_SCRIPTS": folder / "scripts", "BLENDER_USER_CONFIG": folder / "config"}
    for path in user.values():
        path.mkdir(exist_ok=True)
    (archive,) = (BUILD / "plugin").glob("burnish_addon-*.zip")
    run = subprocess.run([blender, "-b", "--factory-startup", "--python-exit-code", "1", "--python", HERE / "face_checks.py", "--", archive, folder],
                         capture_output=True, text=True, timeout=300, env={**os.environ, **{name: str(path) for name, path in user.items()}})
    found = dict(re.findall(r"^CHECK (\w+): (.*)$", run.stdout, re.MULTILINE))
    assert run.returncode == 0, run.stdout + run.stderr
    return found


@pytest.mark.parametrize("name", CHECKS)
def test_in_blender(outcome, name):
    assert outcome.get(name) == "ok", outcome.get(name, "did not run").encode().decode("unicode_escape")
