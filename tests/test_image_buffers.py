"""OpenImageIO.ImageBuf in and out of burnish.composite: the same as files and arrays."""

import subprocess
import sys

import burnish
import numpy as np
import OpenImageIO as oiio
import pytest
import scenes
from conftest import BUILD


def buffer_of(array, names):
    array = np.atleast_3d(array)
    spec = oiio.ImageSpec(array.shape[1], array.shape[0], array.shape[2], oiio.FLOAT)
    spec.channelnames = names
    buffer = oiio.ImageBuf(spec)
    buffer.set_pixels(oiio.ROI(), np.ascontiguousarray(array))
    return buffer


def test_buffers_stand_for_arrays(tmp_path):
    frame, sky = scenes.sphere(), scenes.gradient_sky()
    expected = burnish.composite(frame, sky, "chrome", camera=scenes.CAMERA)
    shuffled = {"beauty": buffer_of(frame["beauty"][..., [3, 2, 1, 0]], ("A", "B", "G", "R")),
                "normal": buffer_of(frame["normal"][..., [2, 0, 1]], ("N.Z", "N.X", "N.Y")), "position": frame["position"],
                "object_id": buffer_of(frame["object_id"], ("id",))}
    light = buffer_of(np.dstack([np.ones(sky.shape[:2], np.float32), sky[..., ::-1]]), ("A", "B", "G", "R"))
    found = burnish.composite(shuffled, light, "chrome", camera=scenes.CAMERA)
    for layer in ("beauty", "overlay", "validity"):
        assert np.array_equal(found[layer], expected[layer]), layer
    half = np.zeros(frame["object_id"].shape, np.float32)
    half[:24] = 1
    masked = [burnish.composite(frame, sky, assign={"gold": mask}, camera=scenes.CAMERA)["overlay"] for mask in (half, buffer_of(half, ("Y",)))]
    assert np.array_equal(*masked) and masked[0].any()


def test_a_buffer_of_a_whole_frame_stands_for_its_file(tmp_path):
    path = scenes.write_frame(tmp_path / "f.exr", scenes.sphere(128, 96), {"maker": "me"})
    job = dict(light=scenes.gradient_sky(), up="z", assign=[{"material": "gold", "index": 1}])
    expected, found = (burnish.composite(frame, **job) for frame in (path, oiio.ImageBuf(str(path))))
    assert np.array_equal(found["beauty"], expected["beauty"]) and found["overlay"].any()
    assert "recovered" in found["report"]["camera"] and found["report"]["materials"] == expected["report"]["materials"]
    first = next(burnish.refine(oiio.ImageBuf(str(path)), **job))
    assert first["beauty"].shape == (96, 128, 4)


def test_layers_become_one_buffer_named_as_the_file(tmp_path):
    path = scenes.write_frame(tmp_path / "f.exr", scenes.sphere())
    shot = burnish.Shot(aovs=path, materials="chrome", camera=scenes.CAMERA, output=tmp_path / "o.exr", diagnostics=True, pixel_type="float")
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    shot = shot.with_(env=tmp_path / "sky.exr", up="z")
    shot.run()
    written, buffer = scenes.read_exr(tmp_path / "o.exr"), burnish.to_imagebuf(shot.composite())
    names, pixels = buffer.spec().channelnames, buffer.get_pixels(oiio.FLOAT)
    assert set(names) == set(written)
    for index, name in enumerate(names):
        assert np.array_equal(pixels[..., index], written[name]), name


def test_what_holds_nothing_is_told():
    with pytest.raises(burnish.BadArgument, match="beauty"):
        burnish.to_imagebuf({"report": {}})
    with pytest.raises(burnish.ReadFailed, match="normal"):
        burnish.composite({"normal": oiio.ImageBuf()}, None, "chrome")


def test_openimageio_is_not_imported_unasked():
    code = "import sys, burnish; sys.exit('OpenImageIO' in sys.modules or 'distributed' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], env={"PYTHONPATH": str(BUILD / "python")}).returncode == 0
