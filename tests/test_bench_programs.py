"""The programs behind docs/measured.md that are written in Python still run: tiny settings, and closed forms of what they conclude."""

import math
import shutil
import subprocess
import sys

import burnish
import numpy as np
import pytest
import scenes
from conftest import BUILD, SOURCE

BENCH = SOURCE / "tests" / "bench"
sys.path.insert(0, str(BENCH))
pytest.importorskip("matplotlib", reason="MATPLOTLIB MISSING")

import rival_runs  # noqa: E402
import rival_scene  # noqa: E402
import rival_table  # noqa: E402
import source_balls  # noqa: E402
import source_rates  # noqa: E402
from source_setups import LOOKS, MICROFACETS, RATES  # noqa: E402


@pytest.mark.parametrize("program", ["rivals.py", "source_figures.py", "farm.py"])
def test_a_program_explains_itself(program):
    text = subprocess.run([sys.executable, BENCH / program, "--help"], capture_output=True, text=True, check=True).stdout
    assert f"tests/bench/{program}" in text


def row(rival, db, seconds, setting=""):
    return dict(rival=rival, family=rival, db=db, frame_s=seconds, once_s=1.0, process_s=seconds + 2, cpu_s=seconds + 2, setting=setting)


def test_cycles_at_the_target_lies_on_the_line_through_its_runs():
    rows = [row("cycles", 28, 2.0), row("cycles", 34, 8.0), row("cycles", 38, 16.0)]
    assert rival_table.cycles_at(rows, ["frame_s"]) == pytest.approx(16 * math.sqrt(2))
    assert rival_table.cycles_at([*rows, row("cycles", 42, 64.0)], ["frame_s"]) == pytest.approx(32)
    assert rival_table.cycles_at(rows[:1], ["frame_s"]) is None


def test_burnish_at_the_target_is_the_cheapest_that_reaches_it():
    rows = [row("burnish", 39.9, 0.01, "fast"), row("burnish", 41, 0.03, "good"), row("burnish", 50, 0.2, "slow")]
    assert rival_table.burnish_at(rows, ["frame_s"]) == (0.03, "good")
    assert rival_table.burnish_at(rows, ["frame_s", "once_s"]) == (1.03, "good")
    assert rival_table.burnish_at(rows[:1], ["frame_s"]) is None


def test_what_the_sources_state_is_plausible():
    for look in LOOKS:
        assert look.samples[0] < look.samples[1] and look.psnr_db[0] < look.psnr_db[1] < 80, look.name
    for table in RATES.values():
        full, half = zip(*table.values())
        assert list(full) == sorted(full, reverse=True) and list(half) == sorted(half, reverse=True)
        assert all(a < b for a, b in zip(full, half))


def test_the_sources_order_of_methods_holds_on_a_tiny_ball():
    ball, light, lobe = source_balls.Ball(20, 0.1), source_balls.benchmark.load_light(1), MICROFACETS[0]
    found = source_balls.microfacet_errors(ball, light, ball.truth(light, lobe.material()), lobe.material(), 14)
    assert found["published"].relative_rms < found["importance"].relative_rms
    assert found["default"].psnr_db > found["published"].psnr_db > 20


def test_diffuse_light_of_a_constant_sky_is_constant():
    normals = source_balls.benchmark.sphere(8)["normal"].reshape(-1, 3)
    normals = normals[np.abs(normals).sum(1) > 0]
    light = burnish.Environment(np.full((8, 16, 3), 2.0))
    assert np.allclose(source_balls.diffuse(light, normals), 2, rtol=2e-3)


def test_frames_a_second_are_of_frames_wholly_shaded():
    frame, eye = source_rates.ball_screen((40, 25), (1, 2, 3))
    light = burnish.Environment(scenes.gradient_sky())
    layers = burnish.composite(frame, light, source_rates.FLOOR, camera=eye)
    assert (layers["validity"] == 0).all()
    half = burnish.composite(source_rates.part_of(frame, 0.5), light, source_rates.FLOOR, camera=eye)
    assert (half["validity"] == 0).mean() == 0.5
    assert source_rates.rate(frame, eye, source_rates.FLOOR, light, 1, 1) > 0


def test_openimageio_looks_where_burnish_does(tmp_path):
    program = BUILD / "tests" / "bench" / "burnish_oiio_blur"
    if not program.exists():
        pytest.skip(f"BENCHES NOT BUILT: {program}; configure with BURNISH_BENCH=ON")
    frame = scenes.sphere(32, 24)
    names = ["P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "IndexMA.X"]
    covered = frame["object_id"] > 0
    picture = np.dstack([frame["position"], frame["normal"], 7.0 * covered])
    aovs = scenes.write_exr(tmp_path / "frame.exr", names, picture)
    sky = scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], np.minimum(scenes.gradient_sky(256), 1))
    output = tmp_path / "out.exr"
    subprocess.run([program, aovs, sky, "--rotate", "30", "--radius", "7=0.001", "-o", output, "--repeats", "1"], check=True,
                   capture_output=True)
    seen = scenes.stacked(scenes.read_exr(output), "R", "G", "B")[covered]
    n, wo = frame["normal"][covered], np.asarray(scenes.CAMERA) - frame["position"][covered]
    wo /= np.linalg.norm(wo, axis=1, keepdims=True)
    mirrored = (2 * (n * wo).sum(1, keepdims=True) * n - wo).astype(np.float32)
    light = burnish.Environment(sky, env_convention="blender", up="z", env_rotate=30)
    expected = light.radiance(mirrored @ light.world_to_light)
    assert np.median(np.abs(seen - expected)) < 0.005


def test_cycles_says_what_it_took(data, tmp_path):
    if shutil.which("blender") is None:
        pytest.skip("BLENDER MISSING: Cycles is not compared")
    folder = data("cycles/make_scene.py").parent
    scene = rival_scene.scene_of("courtyard", folder.parent, tmp_path)
    run = rival_runs.run_cycles(scene, "blender", folder / "make_scene.py", tmp_path, 1, 2)
    assert 0 < run.frame_s < run.frame_s + run.once_s < run.process_s
    assert run.overlay.shape == (360, 640, 3) and run.overlay.mean() > 0.01
