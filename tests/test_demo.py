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
    assert "camera from the header" in notes and "fits the position layer" in notes


def test_the_room_is_baked_and_every_object_shaded_by_its_own_lights(cli, tmp_path):
    told = json.loads(cli("demo", "--scene", "room", "-o", tmp_path, *SMALL, "--json", timeout=600).out)
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(told["files"])
    lights = json.loads((tmp_path / "shot.json").read_text())["lights"]
    assert sum(light["type"] == "cubemap" for light in lights.values()) == 12
    assert sum(light["type"] == "mirror" and not light.get("behind") for light in lights.values()) == 2
    assert sum(light["type"] == "mirror" and light.get("behind", False) for light in lights.values()) == 2
    frame = told["report"]["frames"][0]
    assert len(frame["materials"]) >= 12 and all(count > 0 for count in frame["materials"].values())
    assert frame["warnings"] == []
    for stage in ("light map", "cube maps", "mirrors", "frame", "shading"):
        assert told["seconds"][stage] >= 0


def test_a_folder_that_cannot_be_made_is_told_before_any_work(cli, tmp_path):
    (tmp_path / "taken").write_text("a file, not a folder")
    result = cli("demo", "-o", tmp_path / "taken" / "demo", *SMALL)
    name, message = result.error
    assert result.code == 1 and name == "E_WRITE_FAILED" and "taken" in message
