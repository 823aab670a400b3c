"""The command line: commands, exit codes, progress, other programs, Ctrl-C."""

import json
import os
import re
import signal
import subprocess
import time

import numpy as np
import pytest
import scenes
from conftest import PROGRAM


@pytest.fixture
def job(tmp_path):
    """Arguments of a small job, and the folder it writes to (made beside its inputs)."""
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    (tmp_path / "out").mkdir()
    return ["composite", tmp_path / "beauty.exr", "--env", tmp_path / "sky.exr", "--material", "chrome", "--up", "z",
            "-o", tmp_path / "out" / "out.exr"]


@pytest.fixture
def sequence(tmp_path, job):
    """The same as frames 1, 2 and 4."""
    for frame in (1, 2, 4):
        (tmp_path / f"beauty.{frame:04d}.exr").write_bytes((tmp_path / "beauty.exr").read_bytes())
    return [str(word).replace("beauty.exr", "beauty.####.exr").replace("out.exr", "out.####.exr") for word in job]


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_help_tells_commands_and_exit_codes(cli):
    result = cli("--help")
    assert result.code == 0
    for word in ("composite", "info", "envmap", "compare", "models", "Exit codes: 0 done, 1 failed, 2 wrong usage, 3 ", "130"):
        assert word in result.out


@pytest.mark.parametrize("command", ["composite", "info", "envmap", "compare", "models"])
def test_every_command_has_help(cli, command):
    result = cli(command, "--help")
    assert result.code == 0 and result.out.startswith(result.out.strip().splitlines()[0]) and "Usage: burnish " + command in result.out


def test_version_is_a_number(cli):
    assert re.fullmatch(r"burnish \d+\.\d+\.\d+\n", cli("--version").out)


@pytest.mark.parametrize("words, named", [
    (["composite"], "AOVS"),
    (["composite", "a.exr", "--sampels", "3"], "--sampels"),
    (["composite", "a.exr", "--samples"], "--samples"),
    (["compare", "a.exr"], "REFERENCE"),
    (["envmap", "a.exr", "--layout", "ball"], "--layout"),
    ([], "subcommand"),
])
def test_wrong_usage_is_one_line_and_exit_code_two(cli, words, named):
    result = cli(*words)
    assert result.code == 2
    assert result.error[0] == "E_USAGE" and named in result.error[1] and "--help" in result.error[1]


@pytest.mark.parametrize("words, named", [
    (["--samples=-1"], "samples: expected a whole number in [0, 4096], found -1"),
    (["--samples", "many"], 'found "many"'),
    (["--gain=-1"], "gain"),
    (["--estimator", "regulr"], 'did you mean "regular"'),
    (["--tint", "1,2"], "tint"),
    (["--assign", "gold=object:3"], "NAME=index:N"),
    (["--channel", "normals=N"], 'did you mean "normal"'),
    (["--material", "chrme"], 'did you mean "chrome"'),
    (["--preview", "look.jpg"], ".png"),
])
def test_wrong_values_name_the_setting(cli, job, tmp_path, words, named):
    result = cli(*job, *words)
    assert result.code == 2
    assert result.error[0] == "E_BAD_ARGUMENT" and named in result.error[1]
    assert names(tmp_path / "out") == []


def test_other_words_run_programs_from_the_path(cli, tmp_path):
    program = tmp_path / "burnish-hello"
    program.write_text("#!/bin/sh\necho hello \"$@\"\nexit 7\n")
    program.chmod(0o755)
    result = cli("hello", "-o", "x y", env={**os.environ, "PATH": f"{tmp_path}:{os.environ['PATH']}"})
    assert (result.code, result.out) == (7, "hello -o x y\n")


def test_a_mistyped_command_names_the_nearest(cli):
    result = cli("compsite")
    assert result.code == 2 and 'did you mean "composite"' in result.error[1]


def test_a_single_frame_needs_no_file_at_all(cli, job, tmp_path):
    result = cli(*job)
    assert result.code == 0 and result.err == ""
    assert re.search(r"out\.exr  64x48  [\d.]+ s .*chrome on \d+ pixels\n", result.out)
    layers = scenes.read_exr(tmp_path / "out" / "out.exr")
    assert set(layers) == {"R", "G", "B", "A", "burnish_spec.R", "burnish_spec.G", "burnish_spec.B"}
    assert layers["burnish_spec.G"].max() > 0.1


def test_files_are_made_where_asked_and_nothing_else(cli, job, tmp_path):
    out = tmp_path / "out" / "deeper" / "still"
    result = cli(*job[:-1], out / "o.exr", "--preview", out / "o.png", "--report", out / "o.json", "-q")
    assert (result.code, result.out, result.err) == (0, "", "")
    assert names(out) == ["o.exr", "o.json", "o.png"]
    report = json.loads((out / "o.json").read_text())
    assert report["done"] == 1 and report["frames"][0]["pixels"]["valid"] > 0
    assert {"reading", "shading", "composite", "writing"} <= set(report["frames"][0]["seconds"])


def test_the_report_goes_to_stdout_alone(cli, job):
    result = cli(*job, "--json", "--progress", "text")
    assert json.loads(result.out)["frames"][0]["status"] == "done"
    assert "100 %" in result.err


@pytest.mark.parametrize("form, line", [
    ("text", r" *\d+ % \w+"), ("alf", r"ALF_PROGRESS \d+%"), ("openjd", r"openjd_progress: \d+"),
    ("json", r'\{"percent":\d+,"stage":"\w+"\}')])
def test_progress_is_told_in_the_form_asked_for(cli, job, form, line):
    lines = cli(*job, "--progress", form).err.splitlines()
    assert len(lines) > 3 and all(re.fullmatch(line, text) for text in lines)
    percents = [int(re.search(r"\d+", text).group()) for text in lines]
    assert percents == sorted(percents) and percents[-1] == 100


def test_a_sequence_does_every_frame_on_disk(cli, sequence, tmp_path):
    result = cli(*sequence)
    assert result.code == 0
    assert names(tmp_path / "out") == ["out.0001.exr", "out.0002.exr", "out.0004.exr"]
    first, *others = [scenes.read_exr(path)["R"] for path in (tmp_path / "out").iterdir()]
    assert all(np.array_equal(first, other) for other in others)


def test_a_missing_frame_stops_the_run_and_names_it(cli, sequence, tmp_path):
    result = cli(*sequence, "--frames", "1-4", "-q")
    assert result.code == 1
    assert result.error[0] == "E_READ_FAILED" and result.error[1].startswith("frame=3 ") and "beauty.0003.exr" in result.error[1]
    assert names(tmp_path / "out") == ["out.0001.exr", "out.0002.exr"]


def test_a_missing_frame_can_be_passed_over(cli, sequence, tmp_path):
    report = tmp_path / "report.json"
    result = cli(*sequence, "--frames", "1-4", "--bad-frames", "skip", "--report", report)
    assert result.code == 3
    assert names(tmp_path / "out") == ["out.0001.exr", "out.0002.exr", "out.0004.exr"]
    frames = json.loads(report.read_text())["frames"]
    assert [frame["status"] for frame in frames] == ["done", "done", "failed", "done"]
    assert frames[2]["frame"] == 3 and frames[2]["error"].startswith("E_READ_FAILED ")


def test_a_range_that_is_none_is_told(cli, sequence, tmp_path):
    result = cli(*sequence, "--frames", "1-x")
    assert result.code == 2 and "1-x" in result.error[1] and names(tmp_path / "out") == []


def test_one_output_for_several_frames_is_refused(cli, sequence, tmp_path):
    result = cli(*sequence[:-1], tmp_path / "out" / "one.exr")
    assert result.code == 2 and "####" in result.error[1] and names(tmp_path / "out") == []


def test_frames_that_are_done_can_be_left_out(cli, job, tmp_path):
    assert cli(*job).code == 0
    before = (tmp_path / "out" / "out.exr").stat().st_mtime_ns
    assert cli(*job, "--skip-existing").code == 0
    assert (tmp_path / "out" / "out.exr").stat().st_mtime_ns == before
    os.utime(tmp_path / "beauty.exr")
    assert cli(*job, "--skip-existing").code == 0
    assert (tmp_path / "out" / "out.exr").stat().st_mtime_ns > before


def test_info_tells_roles_for_people_and_machines(cli, job, tmp_path):
    assert "normal" in cli("info", tmp_path / "beauty.exr").out
    described = json.loads(cli("info", tmp_path / "beauty.exr", "--json").out)
    assert {"beauty", "position", "normal", "object_id"} <= set(described["roles"])


def test_envmap_keeps_the_light_in_another_layout(cli, job, tmp_path):
    cube = tmp_path / "cube.exr"
    assert cli("envmap", tmp_path / "sky.exr", "--layout", "cube", "--size", "32", "-o", cube).code == 0
    faces = scenes.stacked(scenes.read_exr(cube), "R", "G", "B")
    assert faces.shape == (6 * 32, 32, 3)
    sky = scenes.gradient_sky()
    theta = np.pi * (np.arange(sky.shape[0]) + 0.5) / sky.shape[0]
    mean = (sky * np.sin(theta)[:, None, None]).sum((0, 1)) / (np.sin(theta).sum() * sky.shape[1])
    side = (np.arange(32) + 0.5) / 16 - 1
    weight = np.tile((1 + side[:, None] ** 2 + side[None, :] ** 2) ** -1.5, (6, 1))
    assert np.allclose((faces * weight[..., None]).sum((0, 1)) / weight.sum(), mean, rtol=0.02)


def test_envmap_written_and_read_gives_the_same_pixels(cli, job, tmp_path):
    assert cli(*job).code == 0
    again = tmp_path / "again.exr"
    assert cli("envmap", tmp_path / "sky.exr", "--up", "z", "--env-rotate", "70", "--size", "128", "-o", again).code == 0
    rotated = [str(word).replace("out.exr", "rotated.exr") for word in job]
    assert cli(*rotated, "--env-rotate", "70", "--estimator", "reference", "--material", "rubber").code == 0
    resampled = [word.replace("sky.exr", "again.exr").replace("rotated.exr", "resampled.exr") for word in rotated]
    assert cli(*resampled, "--estimator", "reference", "--material", "rubber").code == 0
    compared = cli("compare", tmp_path / "out/resampled.exr", tmp_path / "out/rotated.exr", "--layer", "burnish_spec", "--json")
    assert json.loads(compared.out)["relative_rms"] < 0.05


def test_compare_measures_and_draws(cli, job, tmp_path):
    assert cli(*job).code == 0
    result = cli("compare", tmp_path / "out/out.exr", tmp_path / "beauty.exr", "-o", tmp_path / "diff.png")
    assert result.code == 0 and "display PSNR" in result.out and "largest error" in result.out
    assert (tmp_path / "diff.png").read_bytes().startswith(b"\x89PNG")
    same = json.loads(cli("compare", tmp_path / "beauty.exr", tmp_path / "beauty.exr", "--json").out)
    assert same["psnr_db"] is None and same["relative_rms"] == 0


def test_models_lists_models_and_presets(cli):
    text, listed = cli("models").out, json.loads(cli("models", "--json").out)
    by_name = {model["name"]: model for model in listed["models"]}
    assert {"kurt", "ggx", "beckmann", "ward", "ashikhmin-shirley", "oren-nayar"} <= set(by_name)
    assert by_name["abc"]["own_width"] and not by_name["lewis"]["anisotropic"] and not by_name["phong"]["reciprocal"]
    assert by_name["kurt"]["parameters"][0]["default"] == 0.4 and not by_name["kurt"]["parameters"][0]["per_channel"]
    assert all(model["name"] in text for model in listed["models"]) and all(name in text for name in listed["presets"])


def test_the_library_of_measured_materials_is_listed_and_usable(cli, tmp_path):
    text, listed = cli("models").out, json.loads(cli("models", "--json").out)["library"]
    assert len(listed) == 100 and all(" " + name.removeprefix("merl:") in text for name in listed)
    assert listed["merl:brass"]["model"] == "sgd"
    for name in ("brass.png", "brass.exr"):
        assert cli("preview", "merl:brass", "-o", tmp_path / name, "--size", 32).code == 0
    assert (tmp_path / "brass.png").read_bytes().startswith(b"\x89PNG")
    typo = cli("preview", "merl:bras", "-o", tmp_path / "typo.png")
    assert typo.code == 2 and 'did you mean "merl:brass"?' in typo.err and not (tmp_path / "typo.png").exists()


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_signals_end_the_run_without_a_trace(job, tmp_path, number, code):
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere(512, 384))
    words = [PROGRAM, *map(str, job), "--estimator", "reference", "--tolerance", "1e-6", "--progress", "text"]
    process = subprocess.Popen(words, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    while "shading" not in process.stderr.readline():
        assert process.poll() is None
    time.sleep(0.2)
    process.send_signal(number)
    _, err = process.communicate(timeout=60)
    assert process.returncode == code
    assert err.splitlines()[-1].startswith("burnish: error: E_CANCELLED ")
    assert names(tmp_path / "out") == []
