"""Files as they come and go: views, parts that are kept, outputs that are whole and of the same job."""

import json
import os
import time

import burnish
import numpy as np
import OpenImageIO as oiio
import pytest
import scenes
from jobs import composite, work  # noqa: F401: fixtures

EYES = {"left": (-0.2, -4.0, 0.0), "right": (0.2, -4.0, 0.0)}


def parts(path):
    """Specs of all parts."""
    source, specs = oiio.ImageInput.open(str(path)), []
    while source.seek_subimage(len(specs), 0):
        specs.append(source.spec())
    return specs


def eye(view):
    return scenes.channels_of(scenes.sphere(camera=EYES[view]))


def write_stereo_parts(path):
    specs = {view: {"view": view, "oiio:subimagename": f"rgba.{view}"} for view in EYES}
    return scenes.write_parts(path, [scenes.part_of(*eye(view), specs[view]) for view in EYES])


def write_stereo_channels(path):
    """The older way: one part, the view second to last in the channel's name, the main layer of the first view bare."""
    def marked(name, view):
        layer, _, component = name.rpartition(".")
        return f"{layer}.{view}.{component}" if layer else name if view == "left" else f"{view}.{name}"

    names = [marked(name, view) for view in EYES for name in eye(view)[0]]
    pixels = np.concatenate([eye(view)[1] for view in EYES], -1)
    return scenes.write_exr(path, names, pixels, {"multiView": ("string[2]", tuple(EYES))})


def same(a, b):
    assert a.keys() == b.keys()
    assert all(np.array_equal(a[name], b[name]) for name in a)


def test_all_views_are_parts_as_the_views_of_the_frame_are(composite, work):
    write_stereo_parts(work / "stereo.exr")
    report = composite("stereo.exr", view="all")
    assert [spec.get_string_attribute("view") for spec in parts(work / "out.exr")] == list(EYES)
    views = []
    for part, view in enumerate(EYES):
        composite("stereo.exr", view=view, output="one.exr")
        views.append(scenes.read_exr(work / "out.exr", part))
        same(views[part], scenes.read_exr(work / "one.exr"))
    assert not np.array_equal(views[0]["burnish_spec.G"], views[1]["burnish_spec.G"])
    assert [frame["view"] for frame in report["frames"]] == list(EYES)
    assert sorted(path.name for path in work.iterdir() if path.name.startswith(".")) == []


def test_all_views_are_channels_where_those_of_the_frame_are(composite, work):
    write_stereo_channels(work / "stereo.exr")
    composite("stereo.exr", view="all")
    (spec,) = parts(work / "out.exr")
    assert {"R", "right.R", "burnish_spec.left.G", "burnish_spec.right.G"} <= set(spec.channelnames)
    joined = scenes.read_exr(work / "out.exr")
    for view in EYES:
        composite("stereo.exr", view=view, output="one.exr")
        one = scenes.read_exr(work / "one.exr")
        assert np.array_equal(joined[f"burnish_spec.{view}.G"], one["burnish_spec.G"])
        assert np.array_equal(joined["G" if view == "left" else "right.G"], one["G"])
    assert "view left of left, right" in burnish.info(work / "out.exr")["notes"]


def test_views_in_files_of_their_own(composite, work):
    for view in EYES:
        scenes.write_frame(work / f"shot.{view}.0007.exr", scenes.sphere(camera=EYES[view]))
    composite("shot.%V.####.exr", view="all", output="out.%v.####.exr")
    composite("shot.%V.####.exr", view="all", output="both.####.exr")
    for part, view in enumerate(EYES):
        composite(f"shot.{view}.0007.exr", output="one.exr")
        one = scenes.read_exr(work / "one.exr")
        same(scenes.read_exr(work / f"out.{view[0]}.0007.exr"), one)
        same(scenes.read_exr(work / "both.0007.exr", part), one)
    assert [spec.get_string_attribute("view") for spec in parts(work / "both.0007.exr")] == list(EYES)


def test_views_that_cannot_be_meant(composite, work):
    write_stereo_parts(work / "stereo.exr")
    for settings, part in (({"view": "up"}, "left, right"), ({"view": "all", "camera": "camera.json"}, "%V"), ({"output": "out.%V.exr"}, "%V")):
        with pytest.raises(burnish.BadArgument, match=part):
            composite("stereo.exr", **settings)
    assert not list(work.glob("*out*"))


def test_one_view_that_fails_leaves_no_half_of_a_frame(composite, work):
    (names, pixels), (others, blank) = eye("left"), eye("right")
    wrong = [name.replace("P.", "Q.") for name in others]
    names_of = {view: {"view": view, "oiio:subimagename": view} for view in EYES}
    scenes.write_parts(work / "stereo.exr", [scenes.part_of(names, pixels, names_of["left"]), scenes.part_of(wrong, blank, names_of["right"])])
    report = composite("stereo.exr", view="all", bad_frames="skip")
    assert report["failed"] == 2 and not (work / "out.exr").exists()
    assert not [path for path in work.iterdir() if path.name.startswith(".")]


@pytest.mark.parametrize("tile", [0, 16])
def test_layers_are_kept_as_they_are_stored(composite, work, tile):
    """Overscan, cropped parts, half and float, four compressions, tiles: nothing of them changes."""
    rng = np.random.default_rng(5)
    names, pixels = scenes.channels_of(scenes.sphere(80, 64))
    stored = [("beauty", names, pixels, "zips", oiio.FLOAT, (-8, -8)), ("id", ["id"], rng.random((20, 30, 1)), "piz", oiio.HALF, (5, 9)),
              ("ab", ["a.R", "a.G"], rng.random((40, 40, 2)), "rle", oiio.HALF, (0, 0)),
              ("packed", ["b.R", "b.G", "b.B"], rng.random((40, 40, 3)), "dwaa", oiio.HALF, (0, 0))]
    specs = []
    for name, channels, values, compression, kind, origin in stored:
        part = scenes.part_of(channels, values, {"oiio:subimagename": name, "compression": compression}, kind, origin, (64, 48))
        part[0].tile_width = part[0].tile_height = tile
        specs.append(part)
    scenes.write_parts(work / "layers.exr", specs)
    composite("layers.exr", keep_layers=True)
    own, *kept = parts(work / "out.exr")
    assert own.get_string_attribute("oiio:subimagename") == "burnish" and "burnish_spec.G" in own.channelnames
    assert (own.x, own.y, own.width, own.height, own.full_width, own.full_height) == (-8, -8, 80, 64, 64, 48)
    assert len(kept) == len(stored)
    for i, (before, after) in enumerate(zip(parts(work / "layers.exr"), kept)):
        for attribute in ("x", "y", "width", "height", "full_width", "full_height", "tile_width", "channelnames", "format"):
            assert getattr(before, attribute) == getattr(after, attribute)
        for attribute in ("compression", "oiio:subimagename"):
            assert before.get_string_attribute(attribute) == after.get_string_attribute(attribute)
        same(scenes.read_exr(work / "layers.exr", i), scenes.read_exr(work / "out.exr", i + 1))
    composite("layers.exr", output="plain.exr")
    same(scenes.read_exr(work / "out.exr"), scenes.read_exr(work / "plain.exr"))


def test_layers_of_all_views_are_kept(composite, work):
    write_stereo_parts(work / "stereo.exr")
    write_stereo_channels(work / "older.exr")
    for file, names in (("stereo.exr", ["burnish.left", "burnish.right", "rgba.left", "rgba.right"]), ("older.exr", ["burnish", "frame"])):
        composite(file, view="all", keep_layers=True)
        assert [spec.get_string_attribute("oiio:subimagename") for spec in parts(work / "out.exr")] == names
        same(scenes.read_exr(work / "out.exr", len(names) - 1), scenes.read_exr(work / file, len(names) // 2 - 1))


@pytest.fixture
def is_skipped(composite, work):
    """Run the job again, leaving out what is there: whether it was left out."""

    def run(**settings):
        return composite("beauty.exr", skip_existing=True, **settings)["skipped"] == 1

    return run


def test_an_output_is_left_alone_only_when_it_is_of_the_same_job(is_skipped, work):
    assert not is_skipped(env_rotate=10)
    assert is_skipped(env_rotate=10, threads=1, report=str(work / "report.json"))
    assert not is_skipped(env_rotate=11)
    assert not is_skipped(env_rotate=11, diagnostics=True)
    assert not is_skipped(env_rotate=11, preview="out.png", diagnostics=True)
    assert is_skipped(env_rotate=11, preview="out.png", diagnostics=True)
    (work / "brass.json").write_text(json.dumps({"model": "ggx", "roughness": 0.3}))
    brass = {"materials": {"brass": str(work / "brass.json")}, "material": "brass"}
    assert not is_skipped(**brass) and is_skipped(**brass)
    (work / "brass.json").write_text(json.dumps({"model": "ggx", "roughness": 0.31}))
    os.utime(work / "brass.json", (0, 0))
    assert not is_skipped(**brass)


def test_an_output_is_left_alone_only_when_it_is_newer_than_all_inputs(is_skipped, work):
    brass = {"model": "ggx", "m": 0.2, "r0": 0.8}
    (work / "brass.json").write_text(json.dumps(brass))
    (work / "camera.json").write_text(json.dumps(scenes.CAMERA_JSON))
    cube = {"type": "cubemap", "file": str(work / "sky.exr"), "centre": [0, 0, 0], "proxy": {"mesh": str(work / "box.obj")}}
    (work / "box.obj").write_text("v 9 0 0\nv 0 9 0\nv 0 0 9\nv -9 -9 -9\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n")
    job = {"camera": "camera.json", "lights": {"room": cube}, "material": str(work / "brass.json")}
    assert not is_skipped(**job) and is_skipped(**job)
    for i, name in enumerate(("beauty.exr", "sky.exr", "camera.json", "brass.json", "box.obj")):
        later = time.time() + 1000 * (i + 1)
        os.utime(work / name, (later, later))
        assert not is_skipped(**job), name
        os.utime(work / "out.exr", (later + 1, later + 1))
        assert is_skipped(**job), name


@pytest.mark.parametrize("keep_layers", [False, True])
def test_an_output_that_is_not_whole_is_made_again(is_skipped, work, keep_layers):
    assert not is_skipped(keep_layers=keep_layers)
    whole = (work / "out.exr").read_bytes()
    for damaged in (whole[:-100], whole[: len(whole) // 2], whole[:200], b"", whole[:-100] + b"\0" * 100):
        (work / "out.exr").write_bytes(damaged)
        assert is_skipped(keep_layers=keep_layers) == (len(damaged) == len(whole)), len(damaged)  # pixels are not unpacked to look at them
        (work / "out.exr").write_bytes(whole)
    assert is_skipped(keep_layers=keep_layers)


def test_the_same_job_writes_the_same_bytes(composite, work):
    composite("beauty.exr", threads=1, output="a.exr")
    composite("beauty.exr", threads=2, report=str(work / "report.json"), output="b.exr")
    assert (work / "a.exr").read_bytes() == (work / "b.exr").read_bytes()
