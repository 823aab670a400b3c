"""The add-on's half that reads and prepares scenes, inside a real Blender."""

import json
import os
import pathlib
import shutil
import subprocess

import burnish
import cycles
import numpy as np
import pytest
import scenes

BLENDER = shutil.which("blender")
HERE = pathlib.Path(__file__).parent

pytestmark = pytest.mark.skipif(BLENDER is None, reason="BLENDER MISSING: the add-on is not tested")


def run(script, folder):
    """Run a script inside Blender; what it checks itself raises there."""
    command = [BLENDER, "-b", "--factory-startup", "--python-exit-code", "1", "--python", HERE / script]
    environment = {**os.environ, "BURNISH_OUT": str(folder), "PYTHONPATH": str(HERE)}
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, env=environment)
    assert done.returncode == 0 and "CHECKED" in done.stdout, done.stdout[-4000:] + done.stderr[-4000:]


def test_prepare_can_be_taken_back(tmp_path):
    run("scene_touched.py", tmp_path)
