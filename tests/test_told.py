"""What burnish says of a file unasked: colours of headers, precision, packing; and what pixels of two materials wear."""

import json

import burnish
import numpy as np
import OpenImageIO as oiio
import pytest
import scenes
from jobs import composite, work  # noqa: F401: fixtures


def warnings_of(report):
    return report["warnings"] + report["frames"][0]["warnings"]


PRIMARIES = ("float[8]", (0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32168, 0.33767))


def test_colours_that_headers_tell_apart(composite, work):
    for attributes in ({"arnold/color_space": "ACES - ACEScg"}, {"chromaticities": PRIMARIES}):
        scenes.write_frame(work / "beauty.exr", scenes.sphere(), attributes)
        (told,) = warnings_of(composite("beauty.exr"))
        assert "sky.exr does not tell" in told and "--beauty-space ACEScg --env-space lin_rec709" in told
        assert warnings_of(composite("beauty.exr", beauty_space="ACEScg", env_space="lin_rec709")) == []
        (told,) = warnings_of(composite("beauty.exr", beauty_space="lin_rec709", env_space="ACEScg"))
        assert "beauty.exr is ACEScg" in told
    scenes.write_exr(work / "sky.exr", ["R", "G", "B"], scenes.gradient_sky(), {"chromaticities": PRIMARIES})
    assert warnings_of(composite("beauty.exr")) == []
    scenes.write_frame(work / "beauty.exr", scenes.sphere(), {"arnold/color_space": "lin_srgb"})
    (told,) = warnings_of(composite("beauty.exr"))
    assert "sky.exr is ACEScg, the frame is lin_rec709" in told


def test_acescg_under_a_rec709_light_needs_no_config(composite, work):
    """Grey has no primaries: under white light both working spaces agree."""
    scenes.write_exr(work / "sky.exr", ["R", "G", "B"], np.full((16, 32, 3), 0.5))
    composite("beauty.exr", beauty_space="acescg", env_space="lin_rec709", pixel_type="float")
    composite("beauty.exr", pixel_type="float", output="plain.exr")
    a, b = (scenes.read_exr(work / name)["burnish_spec.G"] for name in ("out.exr", "plain.exr"))
    assert np.allclose(a, b, rtol=1e-3) and b.max() > 0.1


def test_half_positions_tell_what_they_cost(composite, work):
    """100 units out halves are 0.0625 apart; 3 units from the camera half of that is 0.6 degrees."""
    frame = scenes.sphere()
    hit = np.linalg.norm(frame["position"], axis=-1, keepdims=True) > 0
    frame["position"] = np.where(hit, frame["position"] + [100, 0, 0], 0)
    names, pixels = scenes.channels_of(frame)
    scenes.write_parts(work / "half.exr", [scenes.part_of(names, pixels, kind=oiio.HALF)])
    (work / "camera.json").write_text(json.dumps({**scenes.CAMERA_JSON, "position": [100, -4, 0], "look_at": [100, 0, 0]}))
    (told,) = [line for line in warnings_of(composite("half.exr", camera="camera.json")) if "half floats" in line]
    assert "in steps of 0.062 units" in told and "32-bit float" in told
    degrees = float(told.split("up to ")[1].split(" degrees")[0])
    assert degrees == pytest.approx(np.degrees(np.arctan(0.03125 / 3)), rel=0.05)


@pytest.mark.parametrize("compression, kind, changed", [
    ("dwaa", oiio.FLOAT, ["position: dwaa compression has changed P.Y", "normal: dwaa compression has changed N.Y"]),
    ("b44", oiio.HALF, ["position: b44 compression has changed P.X, P.Y, P.Z", "object_id: b44 compression has changed IndexOB.X"]),
    ("zip", oiio.FLOAT, []), ("pxr24", oiio.FLOAT, [])])
def test_packing_that_loses_data_is_told(work, compression, kind, changed):
    names, pixels = scenes.channels_of(scenes.sphere())
    scenes.write_parts(work / "packed.exr", [scenes.part_of(names, pixels, {"compression": compression}, kind)])
    warnings = [line for line in burnish.info(work / "packed.exr")["warnings"] if "compression" in line]
    assert bool(warnings) == bool(changed)
    for text in changed:
        assert any(line.startswith(text) for line in warnings), warnings


def as_id(name):
    """MurmurHash3_x86_32 of the name, as a float (cryptomatte 1.2.0)."""
    data, h = name.encode(), 0
    scramble = lambda k: ((k * 0xCC9E2D51 & 0xFFFFFFFF) << 15 | (k * 0xCC9E2D51 & 0xFFFFFFFF) >> 17) * 0x1B873593 & 0xFFFFFFFF  # noqa: E731
    whole = len(data) // 4 * 4
    for i in range(0, whole, 4):
        h ^= scramble(int.from_bytes(data[i : i + 4], "little"))
        h = ((h << 13 | h >> 19) & 0xFFFFFFFF) * 5 + 0xE6546B64 & 0xFFFFFFFF
    h ^= scramble(int.from_bytes(data[whole:], "little")) ^ len(data)
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35)):
        h = (h ^ h >> shift) * factor & 0xFFFFFFFF
    return np.uint32(h ^ h >> 16).view(np.float32)


def test_a_pixel_that_two_materials_share_wears_the_larger_share(composite, work):
    """The winner with its own coverage; what the other covers stays as it was rendered. No manifest: names are found by hash."""
    frame = scenes.sphere()
    names, pixels = scenes.channels_of(frame)
    ranks = np.zeros((*frame["object_id"].shape, 4), np.float32)
    ranks[...] = [as_id("ball"), 0.75, as_id("ring"), 0.25]
    header = {"cryptomatte/f834d0a/name": "obj", "cryptomatte/f834d0a/hash": "MurmurHash3_32", "cryptomatte/f834d0a/conversion": "uint32_to_float32"}
    scenes.write_exr(work / "ids.exr", names + [f"obj00.{c}" for c in "RGBA"], np.concatenate([pixels, ranks], -1), header)
    scenes.write_exr(work / "plain.exr", names, pixels)

    def overlay(file, **settings):
        composite(file, pixel_type="float", density="dense", **settings)
        return scenes.read_exr(work / "out.exr")["burnish_spec.G"]

    whole = overlay("plain.exr")
    both = overlay("ids.exr", assign=["chrome=crypto:ball", "rubber=crypto:ring"], material="gold")
    assert whole.max() > 1 and np.allclose(both, 0.75 * whole, rtol=1e-5, atol=1e-6)
