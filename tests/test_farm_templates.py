"""The templates of examples/farm: the command that each of them holds does its frames, tokens filled in as the farm would."""

import os
import re
import runpy
import subprocess
import sys

import burnish
import pytest
import scenes
from conftest import BUILD, PROGRAM, SOURCE

yaml = pytest.importorskip("yaml", reason="YAML MISSING: install python3-yaml")

FARM = SOURCE / "examples" / "farm"
ENVIRONMENT = {**os.environ, "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}", "PYTHONPATH": str(BUILD / "python")}


@pytest.fixture
def shot(tmp_path):
    """A shot file of frames 1 to 8."""
    scenes.write_frame(tmp_path / "f.0001.exr", scenes.sphere(24, 18))
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    for frame in range(2, 9):
        os.link(tmp_path / "f.0001.exr", tmp_path / f"f.{frame:04d}.exr")
    burnish.Shot(aovs=tmp_path / "f.####.exr", env=tmp_path / "sky.exr", up="z", materials="gold", camera=scenes.CAMERA_JSON,
                 output=tmp_path / "out" / "out.####.exr").write(tmp_path / "shot.json")
    return tmp_path / "shot.json"


def run(words, **options):
    return subprocess.run(list(map(str, words)), capture_output=True, text=True, env={**ENVIRONMENT, **options}, timeout=60)


def done(folder):
    return sorted(int(path.name.split(".")[1]) for path in folder.glob("out.*.exr"))


def test_openjd(shot, tmp_path):
    template = yaml.safe_load((FARM / "openjd.yaml").read_text())
    assert template["specificationVersion"] == "jobtemplate-2023-09" and template["extensions"] == ["TASK_CHUNKING"]
    names = {parameter["name"] for parameter in template["parameterDefinitions"]}
    space = template["steps"][0]["parameterSpace"]["taskParameterDefinitions"][0]
    assert (space["name"], space["type"], space["chunks"]["rangeConstraint"]) == ("Frame", "CHUNK[INT]", "NONCONTIGUOUS")
    values = {parameter["name"]: parameter.get("default") for parameter in template["parameterDefinitions"]}
    values.update(ShotFile=shot, OutputDir=tmp_path / "farm")
    assert set(re.findall(r"{{Param\.(\w+)}}", yaml.dump(template))) == names
    filled = {f"{{{{Param.{name}}}}}": str(value) for name, value in values.items()} | {"{{Task.Param.Frame}}": "1-2,4-8:4"}
    action = template["steps"][0]["script"]["actions"]["onRun"]
    words = [action["command"], *(re.sub(r"{{[\w.]+}}", lambda token: filled[token.group()], word) for word in action["args"])]
    result = run(words)
    assert result.returncode == 0 and done(tmp_path / "farm") == [1, 2, 4, 8], result.stderr
    assert re.fullmatch(r"(openjd_progress: \d+\n)+", result.stderr)


def test_slurm(shot, tmp_path):
    script = FARM / "slurm.sh"
    assert subprocess.run(["sh", "-n", script]).returncode == 0 and subprocess.run(["bash", "-n", script]).returncode == 0
    for first in ("1", "4", "7"):
        result = run(["sh", script, shot, "1-8"], SLURM_ARRAY_TASK_ID=first, SLURM_ARRAY_TASK_STEP="3", SLURM_CPUS_PER_TASK="1")
        assert result.returncode == 0, result.stderr
        assert done(tmp_path / "out") == list(range(1, min(int(first) + 3, 9)))
    assert run(["sh", script, shot, "1-8"], SLURM_ARRAY_TASK_ID="2").stdout.startswith("0 of 1 frames done, 1 up to date")


def test_opencue(shot, tmp_path):
    words = runpy.run_path(str(FARM / "opencue.py"))["command"](str(shot), "1-8")
    filled = [word.replace("#FRAME_START#", "7").replace("#FRAME_END#", "16") for word in words]
    result = run(filled)
    assert result.returncode == 0 and done(tmp_path / "out") == [7, 8], result.stderr
    (tmp_path / "f.0008.exr").unlink()
    missing = run([*filled, "--redo"])
    assert missing.returncode == 1 and missing.stderr.splitlines()[-1].startswith("burnish: error: E_READ_FAILED frame=8 ")


def test_dask(shot, tmp_path):
    distributed = pytest.importorskip("distributed", reason="DASK MISSING: install python3-distributed")
    from loopback_farm import LoopbackFarm

    farm = LoopbackFarm(tmp_path)
    farm.add_workers(1)
    try:
        result = run([sys.executable, FARM / "dask_farm.py", farm.address, shot, "1-8"])
    finally:
        farm.close()
    assert distributed and result.returncode == 0 and done(tmp_path / "out") == list(range(1, 9)), result.stderr
    assert "8 of 8 frames done" in result.stdout
