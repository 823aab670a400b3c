"""Large frames run in bounded memory: what a band takes, not what the frame takes."""

import os
import subprocess

import numpy as np
import pytest
import scenes
from conftest import PROGRAM

MEGABYTE = 1 << 20
SIDE = 4096


@pytest.fixture
def work(tmp_path):
    """A sphere of 4096 x 4096 pixels: position, normal, beauty and id are 0.7 GB as floats, and as much again when shaded."""
    small = scenes.sphere(SIDE // 4, SIDE // 4)
    scenes.write_frame(tmp_path / "beauty.exr", {role: np.repeat(np.repeat(a, 4, 0), 4, 1) for role, a in small.items()})
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    return tmp_path


def peak_bytes(arguments, **options):
    """Most memory a run had resident; it must succeed."""
    process = subprocess.Popen([PROGRAM, *arguments], **options)
    _, status, usage = os.wait4(process.pid, 0)
    assert os.waitstatus_to_exitcode(status) == 0
    return usage.ru_maxrss * 1024


def test_a_large_frame_takes_the_memory_of_its_bands(work):
    camera = '{"position": [0, -4, 0], "look_at": [0, 0, 0], "up": [0, 0, 1], "fov_x_deg": 45}'
    peak = peak_bytes(["composite", "beauty.exr", "--env", "sky.exr", "--material", "chrome", "--samples", "1", "--camera", camera,
                       "--preview", "out.png", "-o", "out.exr"], cwd=work)
    assert peak < 1000 * MEGABYTE
    overlay = scenes.read_exr(work / "out.exr")
    assert overlay["R"].shape[:2] == (SIDE, SIDE)
