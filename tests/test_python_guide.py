"""docs/python.md: its code runs, in its order, in one folder; its tables are true."""

import os
import re
import subprocess

import burnish
import pytest
import scenes
from conftest import BUILD, PROGRAM, SOURCE

GUIDE = (SOURCE / "docs" / "python.md").read_text()


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The small shot that the guide is about."""
    folder = tmp_path_factory.mktemp("guide")
    scenes.write_exr(folder / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    scenes.write_frame(folder / "shot.exr", scenes.sphere(128, 96))
    for frame in (1, 2, 3, 4, 6, 7, 8):
        os.link(folder / "shot.exr", folder / f"shot.{frame:04d}.exr")
    return folder


@pytest.fixture(scope="module")
def farm(tmp_path_factory):
    pytest.importorskip("distributed", reason="DASK MISSING: install python3-distributed")
    from loopback_farm import LoopbackFarm

    farm = LoopbackFarm(tmp_path_factory.mktemp("farm"))
    farm.add_workers(1)
    yield farm
    farm.close()


def test_its_code_runs(folder, farm, monkeypatch):
    monkeypatch.chdir(folder)
    names = {"address": farm.address}
    blocks = re.findall(r"^```python\n(.*?)^```", GUIDE, re.DOTALL | re.MULTILINE)
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    assert len(blocks) > 10 and names["report"].of("done") == [1, 2, 3, 4, 6, 7, 8] and names["layers"]["overlay"].any()


def test_its_commands_run(folder):
    burnish.Shot(aovs=folder / "shot.####.exr", env=folder / "sky.exr", up="z", materials="gold", output=folder / "sh" / "o.####.exr").write(
        folder / "shot.json")
    commands = re.findall(r"^```sh\n(.*?)^```", GUIDE, re.DOTALL | re.MULTILINE)
    for command in commands:
        done = subprocess.run(["sh", "-e", "-c", command], cwd=folder, capture_output=True, text=True,
                              env={**os.environ, "PATH": f"{PROGRAM.parent}:{os.environ['PATH']}", "PYTHONPATH": str(BUILD / "python")})
        assert done.returncode == 3 and done.stdout.startswith("7 of 8 frames done, 1 missing (5: E_READ_FAILED), "), done.stderr
    assert commands


def test_its_templates_are_there():
    names = re.findall(r"`(\w+\.(?:yaml|sh|py))`", GUIDE)
    assert sorted(names) == sorted(path.name for path in (SOURCE / "examples" / "farm").iterdir())


def test_its_table_of_errors_is_whole():
    rows = re.findall(r"^\| (`\w+`(?:, `\w+`)*) \|\s*(\w*)\s*\| (E_\w+(?:, E_\w+)*) \|$", GUIDE, re.MULTILINE)
    found = {name: (base, code) for names, base, codes in rows for name, code in zip(re.findall(r"\w+", names), codes.split(", "))}
    public = {name: getattr(burnish, name) for name in burnish.__all__}
    errors = {name: value for name, value in public.items() if isinstance(value, type) and issubclass(value, burnish.Error)}
    assert found.keys() == errors.keys() - {"Error"}
    for name, (base, code) in found.items():
        assert errors[name].code == code and (not base or base in [each.__name__ for each in errors[name].__mro__]), name
