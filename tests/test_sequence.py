"""`burnish.sequence`: runs here and in processes, what becomes of bad frames, and the command line."""

import functools
import json
import os
import signal
import subprocess
import sys
import threading
import time

import burnish
import pytest
import scenes
from burnish.sequence import farm, pools, run_sequence, tasks
from conftest import BUILD, PROGRAM

@pytest.fixture
def shot(tmp_path):
    """Frames 1 to 6 of a sphere, but for 4."""
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    for frame in (1, 2, 3, 5, 6):
        scenes.write_frame(tmp_path / f"f.{frame:04d}.exr", scenes.sphere(40, 30, 0.7 + 0.03 * frame))
    return burnish.Shot(aovs=tmp_path / "f.####.exr", env=tmp_path / "sky.exr", up="z", materials="gold", camera=scenes.CAMERA_JSON,
                        output=tmp_path / "out" / "o.####.exr")


def files(shot):
    folder = os.path.dirname(shot.output)
    return {entry.name: open(entry.path, "rb").read() for entry in os.scandir(folder)} if os.path.isdir(folder) else {}


def statuses(report):
    return [outcome.status for outcome in report.frames]


def test_processes_and_chunks_give_the_same_bits(shot):
    assert burnish.sequence.run(shot).of("done") == [1, 2, 3, 5, 6]
    alone = files(shot)
    for how in (dict(processes=2, chunk=2), dict(chunk=1)):
        assert burnish.sequence.run(shot, skip_existing=False, **how).is_complete and files(shot) == alone
    burnish.run(shot.document, output=shot.output.replace("o.#", "run.#"))
    assert {name: data for name, data in files(shot).items() if name.startswith("run.")} == {
        name.replace("o.", "run."): data for name, data in alone.items()}


def test_a_missing_frame_stops_or_is_passed_over(shot):
    stopped = burnish.sequence.run(shot, "1-6", chunk=2)
    assert statuses(stopped) == ["done", "done", "done", "missing", "left", "left"] and "not begun (5,6)" in stopped.summary()
    with pytest.raises(burnish.FramesFailed, match=r"frame=4 E_READ_FAILED .*f\.0004\.exr") as raised:
        stopped.raise_if_failed()
    assert raised.value.report is stopped
    passed = burnish.sequence.run(shot, "1-6", chunk=2, bad_frames="skip", report=shot.output.replace("o.####.exr", "report.json"))
    assert statuses(passed) == ["skipped"] * 3 + ["missing"] + ["done"] * 2 and not any(each.tries > 1 for each in passed.frames)
    written = json.loads(files(shot).pop("report.json"))
    assert written == passed.to_dict() and (written["done"], written["skipped"], written["missing"]) == (2, 3, 1)
    assert passed.summary().startswith("2 of 6 frames done, 3 up to date, 1 missing (4: E_READ_FAILED), ")


def test_a_missing_frame_is_held_until_it_is_there(shot):
    report = burnish.sequence.run(shot, [6, 4, 0, 3], bad_frames="hold")
    assert statuses(report) == ["done", "held", "held", "done"] and [each.held_from for each in report.frames] == [None, 3, 3, None]
    written = files(shot)
    assert written["o.0004.exr"] == written["o.0000.exr"] == written["o.0003.exr"] != written["o.0006.exr"]
    report.raise_if_failed()
    os.link(shot.aovs.replace("####", "0006"), shot.aovs.replace("####", "0004"))
    assert statuses(burnish.sequence.run(shot, [3, 4])) == ["skipped", "done"]
    assert files(shot)["o.0004.exr"] != written["o.0004.exr"]


def test_errors_that_may_pass_are_tried_again_and_others_not(shot):
    open(shot.aovs.replace("####", "0004"), "wb").write(b"no EXR")
    scenes.write_frame(shot.aovs.replace("####", "0005"), {"beauty": scenes.sphere(40, 30)["beauty"]})
    report = burnish.sequence.run(shot, "3-6", bad_frames="skip", retries=2)
    assert [(each.status, each.code, each.tries) for each in report.frames] == [
        ("done", "", 1), ("failed", "E_READ_FAILED", 3), ("failed", "E_MISSING_CHANNEL", 1), ("done", "", 1)]
    assert "1 retried" in report.summary()


def test_a_target_that_cannot_be_written_fails_its_frame_alone(shot):
    os.makedirs(shot.output.replace("####", "0002"))
    report = burnish.sequence.run(shot, "1-3", bad_frames="skip", chunk=3, skip_existing=False)
    assert [(each.status, each.code, each.tries) for each in report.frames] == [
        ("done", "", 1), ("failed", "E_WRITE_FAILED", 2), ("done", "", 1)]


def test_a_frame_may_take_so_long(shot):
    report = burnish.sequence.run(shot, "1-2", bad_frames="skip", timeout=1e-3, retries=1)
    assert [(each.status, each.code, each.tries) for each in report.frames] == [("failed", "E_TIMEOUT", 2)] * 2 and files(shot) == {}


def test_a_process_that_is_killed_loses_nothing(shot, monkeypatch):
    slow = shot.with_(estimator="reference", tolerance=0.02, max_samples=1 << 15)
    assert burnish.sequence.run(slow).is_complete
    undisturbed = files(shot)
    children = []
    spawn = pools.Processes._new_child
    monkeypatch.setattr(pools.Processes, "_new_child", lambda self: children.append(spawn(self)) or children[-1])

    def kill():
        while not any(os.stat(shot.output.replace("####", f"{frame:04d}")).st_mtime > begin for frame in (1, 2, 3, 5, 6)):
            time.sleep(0.01)
        children[0].send_signal(signal.SIGKILL)

    begin = time.time()
    killing = threading.Thread(target=kill)
    killing.start()
    report = burnish.sequence.run(slow, processes=2, chunk=2, skip_existing=False)
    killing.join()
    assert report.is_complete and files(shot) == undisturbed
    assert children[0].returncode == -signal.SIGKILL and all(child.poll() is not None for child in children)


class DeadlyPool(pools.ThisProcess):
    """Its worker dies of frame 3."""

    def wait(self, progress):
        if 3 in self.tasks[0]["frames"]:
            return [(self.tasks.pop(0), pools.Lost("killed"))]
        return super().wait(progress)


def test_a_frame_that_kills_workers_is_found(shot):
    make = functools.partial(tasks.make_task, shot.with_(skip_existing=True, bad_frames="skip").document, timeout=None)
    hunt = farm.Farm(DeadlyPool(), make, [1, 2, 3, 5, 6], 1, False, None)
    hunt.run(5)
    assert [(each.status, each.code) for each in hunt.outcomes.values()] == [
        ("done", ""), ("done", ""), ("failed", "E_LOST_WORKER"), ("done", ""), ("done", "")]


def test_what_killed_workers_left_is_swept(shot):
    os.makedirs(os.path.dirname(shot.output))
    left = shot.output.replace("o.####.exr", ".o.0002.0123456789abcdef.exr")
    mine = [shot.output.replace("o.####.exr", name) for name in (".o.0007.0123456789abcdef.exr", ".o.0002.exr", ".notes")]
    for path in [left, *mine]:
        open(path, "w").close()
    burnish.sequence.run(shot, "1-2")
    assert not os.path.exists(left) and all(os.path.exists(path) for path in mine)


@pytest.mark.parametrize("change, part", [
    (dict(chunk=0), "chunk"), (dict(processes=0), "processes"), (dict(retries=-1), "retries"), (dict(timeout=0), "timeout"),
    (dict(bad_frames="ignore"), "hold"), (dict(frames="6-1"), "backwards"), (dict(frames=[]), "at least one"),
    (dict(output=""), "output"), (dict(output="one.exr"), "####"), (dict(preview="one.png"), "preview"), (dict(aovs="one.exr"), "one file"),
    (dict(aovs="none.####.exr"), "none"), (dict(smaples=3), "samples"), (dict(material="godl"), "gold"),
])
def test_what_cannot_be_meant_is_named(shot, change, part):
    with pytest.raises(burnish.BadArgument, match=part):
        burnish.sequence.run(shot, **change)


def test_progress_rises_and_can_stop_and_may_raise(shot):
    told = []
    burnish.sequence.run(shot, chunk=2, progress=lambda stage, done: told.append(done))
    assert told == sorted(told) and told[-1] == 1 and len({done for done in told if 0 < done < 1}) > 3
    for how in ({}, {"processes": 2}):
        with pytest.raises(burnish.Cancelled):
            burnish.sequence.run(shot, skip_existing=False, progress=lambda stage, done: False, **how)

    def broken(stage, done):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        burnish.sequence.run(shot, skip_existing=False, progress=broken)


def test_chunks_follow_frames_and_workers():
    for frames in (1, 7, 40, 200, 5000):
        for workers in (1, 4, 64):
            chunk = run_sequence.default_chunk(frames, workers)
            assert 1 <= chunk <= max(1, -(-frames // workers))
    assert run_sequence.default_chunk(100, 1) > run_sequence.default_chunk(100, 4) > run_sequence.default_chunk(4, 64) == 1


def test_light_and_tables_are_made_once_a_run(shot, monkeypatch):
    class Counted(tasks._core.ShotRunner):
        made = 0

        def __init__(self, document):
            super().__init__(document)
            Counted.made += 1

    monkeypatch.setattr(tasks._core, "ShotRunner", Counted)
    burnish.sequence.run(shot, chunk=1)
    assert Counted.made == 1 and tasks.KEPT.idle == []
    burnish.sequence.run(shot, chunk=1, psnr=30, skip_existing=False)
    assert Counted.made == 1 + 5


def test_a_frame_is_as_bad_as_its_worst_view(tmp_path):
    there = tmp_path / "f.exr"
    there.touch()

    def entry(frame, status, error="", **more):
        return {"frame": frame, "status": status, "input": str(there), "output": "o", "seconds": {"reading": 1.0}, "warnings": [status],
                **({"error": error} if error else {}), **more}

    entries = [entry(1, "done"), entry(1, "failed", "E_READ_FAILED cut off"), entry(2, "skipped"), entry(2, "done"),
               entry(3, "failed", "E_READ_FAILED no file", input="absent.exr"), entry(3, "done")]
    told = tasks.outcomes_of({"frames": entries})
    assert [(each["frame"], each["status"], each["code"], each["seconds"]) for each in told] == [
        (1, "failed", "E_READ_FAILED", 2), (2, "done", "", 2), (3, "missing", "E_READ_FAILED", 2)]
    assert told[0]["message"] == "cut off" and told[0]["warnings"] == ["done", "failed"]


def test_a_worker_of_another_version_is_refused(shot):
    with pytest.raises(burnish.BadArgument, match="install the same"):
        tasks.run_task({**tasks.make_task(shot.document, [1], None), "burnish": "0.0.0"})


def test_the_command_does_frames_and_tells(cli, shot, tmp_path):
    shot.write(tmp_path / "shot.json")
    result = cli("sequence", tmp_path / "shot.json", "--frames", "1-9:4", "--dialect", "fileseq", "--within", "1-6", "--bad-frames", "skip",
                 "--processes", "2", "--progress", "openjd", "--samples", "3")
    assert result.code == 3 and "5 of 6 frames done, 1 missing (4: E_READ_FAILED), " in result.out
    lines = result.err.splitlines()
    assert lines[-1].startswith("burnish: warning: frame=4 missing: E_READ_FAILED ")
    percents = [int(line.removeprefix("openjd_progress: ")) for line in lines[:-1]]
    assert percents == sorted(percents) and percents[-1] == 100
    words = ["sequence", shot.aovs, "--env", shot.env, "--up", "z", "--material", "gold", "-o", tmp_path / "o.####.exr", "--frames", "1-3"]
    assert json.loads(cli(*words, "--json").out)["done"] == 3 and cli(*words, "-q").out == ""
    beyond = cli(*words[:-1], "7-9", "--within", "1-6")
    assert beyond.code == 0 and beyond.out == "0 of 0 frames done, 0.0 s\n"
    stopped = cli(*words[:-1], "3-5")
    assert stopped.code == 1 and stopped.err.splitlines()[-1].startswith("burnish: error: E_READ_FAILED frame=4 ")


@pytest.mark.parametrize("words, code, name, part", [
    (["--frames", "1-x"], 2, "E_BAD_ARGUMENT", "1-x"),
    (["--smaples", "3"], 2, "E_BAD_ARGUMENT", "did you mean --samples"),
    (["--processes", "2", "--scheduler", "tcp://127.0.0.1:1"], 2, "E_USAGE", "not allowed"),
    (["--chunk", "0"], 2, "E_BAD_ARGUMENT", "chunk"),
    (["--scheduler", "nowhere"], 1, "E_LOST_CONNECTION", "nowhere"),
])
def test_what_cannot_be_used_is_one_line(cli, shot, tmp_path, words, code, name, part):
    shot.write(tmp_path / "shot.json")
    result = cli("sequence", tmp_path / "shot.json", *words)
    assert result.code == code and result.error[0] == name and part in result.error[1]
    assert files(shot) == {}


@pytest.mark.parametrize("number, code", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_signals_end_the_run_without_a_trace(shot, tmp_path, number, code):
    for frame in (1, 2):
        scenes.write_frame(shot.aovs.replace("####", f"{frame:04d}"), scenes.sphere(512, 384))
    shot.with_(estimator="reference", tolerance=1e-6).write(tmp_path / "shot.json")
    words = [PROGRAM, "sequence", tmp_path / "shot.json", "--frames", "1-2", "--processes", "2", "--progress", "text"]
    process = subprocess.Popen(words, stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": str(BUILD / "python")})
    while "frames" not in process.stderr.readline():
        assert process.poll() is None
    time.sleep(0.5)
    process.send_signal(number)
    _, err = process.communicate(timeout=60)
    assert process.returncode == code and err.splitlines()[-1].startswith("burnish: error: E_CANCELLED ")
    assert files(shot) == {}


def test_the_module_runs_it_too(shot, tmp_path):
    shot.write(tmp_path / "shot.json")
    done = subprocess.run([sys.executable, "-m", "burnish", "sequence", tmp_path / "shot.json", "--frames", "1"], capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(BUILD / "python"), "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"})
    assert done.returncode == 0 and done.stdout.startswith("1 of 1 frames done"), done.stderr
