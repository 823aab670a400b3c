"""`burnish.Shot`: a shot document as a value."""

import json
import os
import pickle

import burnish
import numpy as np
import pytest
import scenes
from burnish import Shot
from burnish.sequence import FrameOutcome
from burnish.sequence.outputs import Outputs, hold
from conftest import SOURCE

MIRROR = {"type": "mirror", "file": "floor.####.exr", "plane": {"point": [0, 0, 0], "normal": [0, 0, 1]}}
RICH = {
    "aovs": "f.####.exr", "frames": "1-9x2", "channels": {"normal": "View Layer.N"}, "camera": {"position": [0.1, 0.2, 0.3]},
    "lights": {"studio": {"file": "s.hdr", "rotate": 0.1, "tint": [1, 0.3, 1e-7]}, "floor": MIRROR},
    "materials": {"mine": {"lobes": [{"model": "ggx", "roughness": 0.3}]}, "brass": "merl:brass"},
    "assign": ["mine=index:3@floor,studio", {"material": "brass", "cryptomatte": "knot*"}], "per_pixel": ["roughness"],
    "quality": {"samples": 19}, "composite": {"gain": 0.1}, "output": {"file": "o.####.exr", "pixel_type": "float"},
}


@pytest.mark.parametrize("document", [{}, RICH, json.loads((SOURCE / "examples/lights.json").read_text())] + [
    {"materials": {"one": name}} for name in (*burnish.presets(), *list(burnish.library())[::9])], ids=lambda d: str(d)[:40])
def test_a_shot_comes_back_from_its_file(document, tmp_path):
    shot = Shot(document)
    shot.write(tmp_path / "deeper" / "shot.json")
    again = Shot(tmp_path / "deeper" / "shot.json")
    assert again == shot and again.document == shot.document == Shot(shot).document and pickle.loads(pickle.dumps(shot)) == shot
    assert (tmp_path / "deeper" / "shot.json").read_text() == json.dumps(again.document, indent=2) + "\n"
    assert os.listdir(tmp_path / "deeper") == ["shot.json"]


def test_settings_make_the_shot_that_its_document_makes():
    shot = Shot(RICH)
    other = Shot({"lights": {"studio": {}}}, **{name: value for name, value in shot.settings.items()})
    assert other.settings == shot.settings
    assert (shot.samples, shot.gain, shot.env_rotate, shot.estimator, shot.frames().numbers) == (19, 0.1, 0.1, "fitted", [1, 3, 5, 7, 9])
    assert set(shot.settings) <= {setting["name"] for setting in burnish.settings()} <= set(dir(shot))
    assert shot.lights.keys() == {"floor"} and shot.env == os.path.abspath("s.hdr")


def test_a_change_makes_another_shot():
    shot = Shot(RICH)
    other = shot.with_(samples=3, material="gold")
    assert (other.samples, shot.samples, other.material, other.assign) == (3, 19, "gold", shot.assign) and other != shot
    assert other.with_(samples=19, material="") == shot
    shot.document["quality"]["samples"] = shot.settings["assign"][0]["material"] = "changed"
    assert shot == Shot(RICH)


def test_materials_and_cameras_have_short_forms():
    lobes = {"lobes": [{"model": "ggx", "m": 0.1}]}
    assert Shot(materials="chrome").material == "chrome"
    assert Shot(materials={"mine": lobes}).material == "mine" and Shot(materials=lobes).materials.keys() == {"material"}
    assert Shot(materials={"mine": lobes}, assign=["mine=index:1"]).material == ""
    assert Shot(RICH).with_(materials={"mine": lobes}).material == ""
    assert Shot(camera=np.array([1, 2, 3])).camera == {"position": [1, 2, 3]} == Shot(camera=(1, 2, 3)).camera


def test_paths_are_found_from_everywhere(tmp_path, monkeypatch):
    (tmp_path / "mine.json").write_text('{"lobes": [{"model": "ggx", "m": 0.1}]}')
    (tmp_path / "shot.json").write_text('{"aovs": "f.exr", "lights": {"sky": {"file": "s.hdr"}}}')
    monkeypatch.chdir(tmp_path)
    shot = Shot("shot.json", material="mine.json", output="o.exr", assign=["mine.json=index:1"], fine_aovs="/abs/fine.exr")
    assert [shot.aovs, shot.env, shot.output, shot.material, shot.assign[0]["material"], shot.fine_aovs] == [
        *(str(tmp_path / name) for name in ("f.exr", "s.hdr", "o.exr", "mine.json", "mine.json")), "/abs/fine.exr"]


@pytest.mark.parametrize("make, error, part", [
    (lambda: Shot({"quality": {"samples": -1}}), burnish.BadArgument, r"quality\.samples: expected a whole number in \[0, 4096\], found -1"),
    (lambda: Shot({"quality": {"smaples": 1}}), burnish.BadArgument, "quality.*smaples.*samples"),
    (lambda: Shot({"lights": {"floor": {**MIRROR, "plane": 3}}}), burnish.BadArgument, r"lights\.floor\.plane"),
    (lambda: Shot({"materials": {"a": {"lobes": [{"model": "gggx"}]}}}), burnish.BadArgument, r"materials\.a\.lobes\[0\]\.model.*ggx"),
    (lambda: Shot({"assign": [{"index": 3}]}), burnish.BadArgument, r"assign\[0\]\.material: missing"),
    (lambda: Shot(samples="many"), burnish.BadArgument, "samples"),
    (lambda: Shot(smaples=3), burnish.BadArgument, "samples"),
    (lambda: Shot("absent.json"), burnish.ReadFailed, "absent.json"),
    (lambda: Shot().smaples, AttributeError, "did you mean 'samples'"),
    (lambda: Shot().write("/dev/null/shot.json"), burnish.WriteFailed, "/dev/null"),
    (lambda: Shot(aovs="one.exr").frames(), burnish.BadArgument, "####"),
    (lambda: Shot(aovs="one.exr").composite(3), burnish.BadArgument, "names one file"),
    (lambda: Shot(aovs="f.####.exr").composite(), burnish.BadArgument, "which number"),
])
def test_what_is_wrong_is_named_by_its_path(make, error, part):
    with pytest.raises(error, match=part):
        make()


@pytest.fixture
def shot(tmp_path):
    """Frames 1, 2 and 4, each with a mirror and a camera of its own."""
    for frame in (1, 2, 4):
        scenes.write_frame(tmp_path / f"f.{frame:04d}.exr", scenes.sphere(40, 30, 0.6 + 0.1 * frame))
        (tmp_path / f"camera.{frame:04d}.json").write_text(json.dumps(scenes.CAMERA_JSON))
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    return Shot(aovs=tmp_path / "f.####.exr", env=tmp_path / "sky.exr", up="z", camera=tmp_path / "camera.####.json", materials="gold",
                pixel_type="float", output=tmp_path / "o.####.exr")


def test_frames_on_disk_are_told_with_their_gaps(shot):
    assert shot.frames() == ([1, 2, 4], [3]) == burnish.Frames([1, 2, 4], [3])
    assert shot.with_(frames="0-2").frames() == ([0, 1, 2], [0])
    assert shot.with_(aovs="none.####.exr").frames() == ([], [])


def test_a_frame_in_memory_is_the_one_on_disk(shot):
    assert [frame["status"] for frame in shot.run()["frames"]] == ["done"] * 3
    for frame in (1, 4):
        written = scenes.stacked(scenes.read_exr(shot.output.replace("####", f"{frame:04d}")), "R", "G", "B", "A")
        assert np.array_equal(shot.composite(frame)["beauty"], written)
    told = []
    changed = shot.composite(4, progress=lambda stage, done: told.append(done), material="chrome")
    assert told[-1] == 1 and not np.array_equal(changed["beauty"], written)
    with pytest.raises(burnish.ReadFailed, match="0003"):
        shot.composite(3)


def test_lights_of_a_frame_keep_their_names(shot):
    lamp = {"type": "area", "corners": [[-1, -2, 3], [-1, 0, 3], [1, 0, 3], [1, -2, 3]], "radiance": 9}
    document = {**shot.document, "assign": ["gold=index:1@lamp,studio"]}
    document["lights"] = {"studio": document["lights"]["sky"], "lamp": lamp}
    named = Shot(document)
    named.run(frames="2", output=shot.output.replace("o.", "named."))
    written = scenes.stacked(scenes.read_exr(shot.output.replace("o.####", "named.0002")), "R", "G", "B", "A")
    assert np.array_equal(named.composite(2)["beauty"], written)
    assert not np.array_equal(written, shot.composite(2)["beauty"])


def test_views_have_files_of_their_own(shot, tmp_path):
    for view, frames in (("left", (1, 2, 4)), ("r", (1, 2))):
        for frame in frames:
            os.link(tmp_path / f"f.{frame:04d}.exr", tmp_path / f"{view}.{frame:04d}.exr")
    both = shot.with_(aovs=tmp_path / "%V.####.exr", output=tmp_path / "out.%V.####.exr")
    assert both.frames() == ([1, 2, 4], [3]) and both.with_(aovs=tmp_path / "%v.####.exr", view="right").frames() == ([1, 2], [])
    assert np.array_equal(both.composite(2)["beauty"], shot.composite(2)["beauty"])
    outputs = Outputs(both.with_(view="all"))
    assert [path.name for path in outputs.of(3)] == ["out.left.0003.exr", "out.right.0003.exr"]
    assert [path.name for path in Outputs(both.with_(view="right")).of(3)] == ["out.right.0003.exr"]
    for view in ("left", "right"):
        (tmp_path / f"out.{view}.0002.exr").write_text(view)
    hold([FrameOutcome(2, "done"), FrameOutcome(3, "missing")], outputs)
    assert [(tmp_path / f"out.{view}.0003.exr").read_text() for view in ("left", "right")] == ["left", "right"]
