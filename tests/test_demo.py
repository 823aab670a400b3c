"""burnish demo: leaves a shot that works, says where everything is, and fails in one line."""

import json

FILES = ["before_after.png", "before.png", "after.png", "out.exr", "shot.exr", "sky.exr", "shot.json", "report.json"]
SMALL = ["--width", "160", "--height", "90"]


def test_demo_leaves_every_file_it_names(cli, tmp_path):
    result = cli("demo", "-o", tmp_path / "demo", *SMALL, "--json")
    assert result.code == 0, result.err
    told = json.loads(result.out)
    assert list(told["files"]) == FILES
    assert sorted(path.name for path in (tmp_path / "demo").iterdir()) == sorted(FILES)
    for stage in ("make scene", "trace", "reading", "light", "surface", "shading", "composite", "writing"):
        assert told["seconds"][stage] >= 0


def test_every_object_of_the_demo_is_shaded(cli, tmp_path):
    told = json.loads(cli("demo", "-o", tmp_path, *SMALL, "--json").out)
    frame = told["report"]["frames"][0]
    assert len(frame["materials"]) == 10 and all(count > 50 for count in frame["materials"].values())
    assert frame["warnings"] == []


def test_the_shot_of_the_demo_runs_again_with_the_same_bits(cli, tmp_path):
    cli("demo", "-o", tmp_path, *SMALL)
    first = (tmp_path / "out.exr").read_bytes()
    (tmp_path / "out.exr").unlink()
    result = cli("composite", tmp_path / "shot.json")
    assert result.code == 0, result.err
    assert (tmp_path / "out.exr").read_bytes() == first


def test_the_camera_of_the_shot_is_the_one_its_positions_tell(cli, tmp_path):
    cli("demo", "-o", tmp_path, *SMALL)
    notes = cli("info", tmp_path / "shot.exr").out
    assert "camera recovered from" in notes and "100 % agree" in notes


def test_a_folder_that_cannot_be_made_is_told_before_any_work(cli, tmp_path):
    (tmp_path / "taken").write_text("a file, not a folder")
    result = cli("demo", "-o", tmp_path / "taken" / "demo", *SMALL)
    name, message = result.error
    assert result.code == 1 and name == "E_WRITE_FAILED" and "taken" in message
