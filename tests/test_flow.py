"""Large frames run in bounded memory: what a band takes, not what the frame takes."""

import os
import subprocess

import numpy as np
import OpenImageIO as oiio
import pytest
import scenes
from conftest import PROGRAM

MEGABYTE = 1 << 20
SIDE, SCALE = 4096, 4


def write_enlarged(path, frame):
    """Write the frame with every pixel SCALE x SCALE times, row by row: this process must stay small, its size counts as its
    children's."""
    names = [name for role in frame for name in scenes.CHANNELS[role]]
    pixels = np.concatenate([a[..., None] if a.ndim == 2 else a for a in frame.values()], -1)
    spec = oiio.ImageSpec(SIDE, SIDE, len(names), oiio.FLOAT)
    spec.channelnames = tuple(names)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), spec), output.geterror()
    for y, row in enumerate(pixels):
        rows = np.ascontiguousarray(np.broadcast_to(np.repeat(row, SCALE, 0), (SCALE, SIDE, len(names))))
        assert output.write_scanlines(y * SCALE, (y + 1) * SCALE, 0, rows), output.geterror()
    output.close()


@pytest.fixture
def work(tmp_path):
    """A sphere of 4096 x 4096 pixels: what is read of it is 0.7 GB as floats, and as much again when shaded."""
    write_enlarged(tmp_path / "beauty.exr", scenes.sphere(SIDE // SCALE, SIDE // SCALE))
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
    print(f"peak {peak / MEGABYTE:.0f} MB")
    assert peak < 1000 * MEGABYTE
