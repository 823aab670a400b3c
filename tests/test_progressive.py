"""Pictures that get better while someone looks: the Python iterator and `burnish composite --progressive`."""

import json
import shutil
import signal
import subprocess

import burnish
import numpy as np
import pytest
import scenes
from conftest import PROGRAM

QUICK = dict(tolerance=0.02, max_samples=2048)


def test_steps_come_nearer_to_the_reference():
    frame, light = scenes.sphere(32, 24), burnish.Environment(scenes.gradient_sky())
    exact = burnish.composite(frame, light, "gold", camera=scenes.CAMERA, estimator="reference", tolerance=0.005)["overlay"]
    steps = list(burnish.refine(frame, light, "gold", camera=scenes.CAMERA, **QUICK))
    assert [step["label"] for step in steps][:3] == ["first look", "as set", "dense, 256 lookups"]
    assert [step["is_final"] for step in steps] == [False] * (len(steps) - 1) + [True]
    as_set = burnish.composite(frame, light, "gold", camera=scenes.CAMERA, **QUICK)
    assert np.array_equal(steps[1]["beauty"], as_set["beauty"])
    error = [np.sqrt(np.mean((step["overlay"] - exact) ** 2)) for step in steps]
    assert error[-1] < 0.02 * np.sqrt(np.mean(exact**2)) and error[-1] < error[1]
    assert steps[-1]["error"].max() > 0 and "error" not in steps[0]
    assert steps[-1]["report"]["lookups"] > steps[0]["report"]["lookups"]


def test_looking_may_end_at_any_time():
    steps = burnish.refine(scenes.sphere(), scenes.gradient_sky(), "gold", camera=scenes.CAMERA)
    assert next(steps)["step"] == 0
    steps.close()
    assert list(steps) == []


def test_progress_may_cancel_in_the_middle_of_a_step():
    steps = burnish.refine(scenes.sphere(), scenes.gradient_sky(), "gold", camera=scenes.CAMERA, progress=lambda *_: False)
    with pytest.raises(burnish.Cancelled):
        list(steps)


def test_a_wrong_argument_is_told_at_once():
    with pytest.raises(burnish.BadArgument):
        burnish.refine(scenes.sphere(), scenes.gradient_sky(), "no such metal", camera=scenes.CAMERA)


@pytest.fixture
def shot(tmp_path):
    """Arguments of `burnish composite` for a small sphere."""
    scenes.write_frame(tmp_path / "in.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    return ["composite", tmp_path / "in.exr", "--env", tmp_path / "sky.exr", "--material", "gold", "--camera",
            json.dumps(scenes.CAMERA_JSON), "-o", tmp_path / "out.exr", "--preview", tmp_path / "out.png", "--progressive"]


def test_the_command_line_writes_every_step(cli, shot, tmp_path):
    quick = ["--tolerance", 0.02, "--max-samples", 1024]
    told = cli(*shot, *quick)
    assert told.code == 0 and told.out.startswith("step 0: first look, ")
    lines = [line for line in told.out.splitlines() if line.startswith("step ")]
    assert lines[-1].startswith("step 4: reference, 1024 lookups") and lines[-1].endswith("final")
    assert (tmp_path / "out.exr").exists() and (tmp_path / "out.png").exists()
    report = json.loads(cli(*shot, *quick, "--json").out)
    steps = report["frames"][0]["steps"]
    assert [step["step"] for step in steps] == list(range(5)) and steps[-1]["is_final"]
    assert all(a["since_start"] < b["since_start"] for a, b in zip(steps, steps[1:]))


def test_ctrl_c_leaves_the_last_whole_picture(shot, tmp_path):
    endless = ["--tolerance", "1e-6", "--max-samples", "1048576"]
    with subprocess.Popen([PROGRAM, *map(str, shot), *endless], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
        assert run.stdout.readline().startswith("step 0")
        run.send_signal(signal.SIGINT)
        run.wait(30)
        assert run.returncode == 130 and run.stderr.read() == ""
    assert burnish.info(tmp_path / "out.exr")["data_window"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["in.exr", "out.exr", "out.png", "sky.exr"]


def test_several_frames_are_refused(cli, shot, tmp_path):
    for number in (1, 2):
        shutil.copy(tmp_path / "in.exr", tmp_path / f"in.{number:04}.exr")
    shot[1], shot[shot.index("-o") + 1] = tmp_path / "in.####.exr", tmp_path / "out.####.exr"
    shot[shot.index("--preview") + 1] = tmp_path / "out.####.png"
    name, message = cli(*shot).error
    assert name == "E_BAD_ARGUMENT" and "expected one frame, found 2" in message
    assert cli(*shot, "--frames", 2, "--tolerance", 0.1, "--max-samples", 512).code == 0
    assert (tmp_path / "out.0002.exr").exists()
