"""The Python package: documentation, types, exceptions, arrays of any kind, cancellation."""

import ast
import inspect
import re
import threading

import burnish
import numpy as np
import pytest
import scenes
from burnish import _core, errors
from conftest import SOURCE

FUNCTIONS = [getattr(module, name) for module in (burnish, burnish.sequence) for name in module.__all__
             if inspect.isroutine(getattr(module, name))]
CLASSES = (burnish.Lobe, burnish.Environment, burnish.Shot, burnish.sequence.SequenceReport)
METHODS = [method for owner in CLASSES for name, method in vars(owner).items() if not name.startswith("_") and callable(method)]


@pytest.mark.parametrize("function", FUNCTIONS + METHODS, ids=lambda f: getattr(f, "__qualname__", f.__name__))
def test_every_public_name_is_documented(function):
    text = function.__doc__
    for section in ("Returns\n", "Raises\n"):
        assert section in text, f"{function.__name__} lacks {section}"
    returned = text.split("Returns\n")[1].split("Raises\n")[0]
    assert "shape" in returned or "dict" in returned or "list" in returned
    assert getattr(function, "__annotations__", True), f"{function.__name__} has no types"
    if function in FUNCTIONS:
        for name in inspect.signature(function).parameters:
            assert re.search(rf"^\s*(\*\*)?(\w+, )*{name}(, \w+)* ?(:|$)", text, re.MULTILINE), f"{function.__name__}: {name}"


def test_exceptions_are_what_python_callers_expect():
    for error in errors.BY_CODE.values():
        assert issubclass(error, burnish.Error) and error.__doc__ and error.code in errors.BY_CODE
    assert issubclass(burnish.BadArgument, ValueError) and issubclass(burnish.ReadFailed, OSError)


def stub_names(node):
    return {item.name for item in node.body if isinstance(item, (ast.FunctionDef, ast.ClassDef))}


def test_the_stubs_name_what_the_module_has():
    tree = ast.parse((SOURCE / "python/burnish/_core.pyi").read_text())
    assert stub_names(tree) == {name for name in vars(_core) if not name.startswith("_")}
    for owner in (item for item in tree.body if isinstance(item, ast.ClassDef)):
        assert {name for name in stub_names(owner) if name != "__init__"} == {
            name for name in vars(getattr(_core, owner.name)) if not name.startswith("_")}


def test_the_stubs_have_the_modules_parameters():
    tree = ast.parse((SOURCE / "python/burnish/_core.pyi").read_text())
    owners = [(_core, tree)] + [(getattr(_core, item.name), item) for item in tree.body if isinstance(item, ast.ClassDef)]
    for owner, node in owners:
        for item in (item for item in node.body if isinstance(item, ast.FunctionDef)):
            if item.decorator_list or item.name == "__init__":
                continue
            names = [argument.arg for argument in item.args.args if argument.arg != "self"]
            signature = getattr(owner, item.name).__doc__.splitlines()[0]
            inside = signature[signature.index("(") + 1 : signature.rindex(") ->")]
            found = [name for name in re.findall(r"(\w+): ", inside) if name != "self"]
            assert found == names, f"{item.name}: {found} in the module, {names} in the stub"


@pytest.mark.parametrize("owner", [burnish.Shot, burnish.sequence.SequenceReport, burnish.sequence.FrameOutcome, burnish.Frames],
                         ids=lambda owner: owner.__name__)
def test_every_public_class_tells_what_it_holds(owner):
    text = inspect.getdoc(owner)
    for name in inspect.signature(owner).parameters:
        assert re.search(rf"^(\*\*)?(\w+, )*{name}(, \w+)* ?(:|$)", text, re.MULTILINE), f"{owner.__name__}: {name}"


def test_arrays_of_any_kind_are_taken():
    frame, sky = scenes.sphere(), scenes.gradient_sky()
    expected = burnish.composite(frame, sky, "chrome", camera=scenes.CAMERA)["beauty"]
    doubles = {role: array.astype(np.float64) for role, array in frame.items()}
    reversed_view = {role: np.asfortranarray(array) for role, array in frame.items()}
    for other in (doubles, reversed_view):
        assert np.array_equal(burnish.composite(other, sky, "chrome", camera=scenes.CAMERA)["beauty"], expected)
    assert expected.flags.c_contiguous and expected.dtype == np.float32


def test_inputs_are_left_as_they_were():
    frame = scenes.sphere()
    before = {role: array.copy() for role, array in frame.items()}
    burnish.composite(frame, scenes.gradient_sky(), "chrome", camera=scenes.CAMERA)
    assert all(np.array_equal(frame[role], before[role]) for role in frame)


@pytest.mark.parametrize("change, error, part", [
    (dict(aovs={}), burnish.SizeMismatch, "position"),
    (dict(aovs={"beuty": np.zeros((4, 4, 3))}), burnish.BadArgument, "beauty"),
    (dict(aovs={**scenes.sphere(), "normal": np.zeros((4, 4, 3))}), burnish.SizeMismatch, "normal"),
    (dict(aovs={**scenes.sphere(), "normal": np.zeros((48, 64))}), burnish.SizeMismatch, "3 channels"),
    (dict(aovs={**scenes.sphere(), "normal": "text"}), burnish.BadArgument, "normal"),
    (dict(aovs="absent.exr"), burnish.ReadFailed, "absent.exr"),
    (dict(light=np.zeros((4, 4, 4, 4))), burnish.SizeMismatch, "light"),
    (dict(light="absent.hdr"), burnish.ReadFailed, "absent.hdr"),
    (dict(light=None), burnish.BadArgument, "--env"),
    (dict(materials="chrme"), burnish.BadArgument, "chrome"),
    (dict(materials=None), burnish.BadArgument, "no material"),
    (dict(materials={"a": "gold", "b": "chrome"}), burnish.BadArgument, "no material"),
    (dict(materials={"model": "ggx", "m": -1}), burnish.BadArgument, "m"),
    (dict(assign={"gold": np.zeros((3, 3))}), burnish.SizeMismatch, "assign"),
    (dict(assign={}), burnish.BadArgument, "mask"),
    (dict(camera=(1, 2)), burnish.BadArgument, "position"),
    (dict(smaples=3), burnish.BadArgument, "samples"),
    (dict(samples=object()), burnish.BadArgument, "object"),
])
def test_what_cannot_be_used_is_named(change, error, part):
    job = dict(aovs=scenes.sphere(), light=scenes.gradient_sky(), materials="chrome", camera=scenes.CAMERA)
    with pytest.raises(error, match=part):
        burnish.composite(**{**job, **change})


def test_progress_rises_to_the_end_and_can_cancel():
    told = []
    job = dict(aovs=scenes.sphere(), light=scenes.gradient_sky(), materials="chrome", camera=scenes.CAMERA)
    burnish.composite(**job, progress=lambda stage, done: told.append((stage, done)))
    assert [done for _, done in told] == sorted(done for _, done in told) and told[-1][1] == 1
    with pytest.raises(burnish.Cancelled):
        burnish.composite(**job, progress=lambda stage, done: done < 0.5)


def test_what_the_callback_raises_comes_through():
    def broken(stage, done):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        burnish.composite(scenes.sphere(), scenes.gradient_sky(), "chrome", camera=scenes.CAMERA, progress=broken)


def test_other_threads_run_meanwhile():
    ticks = []
    worker = threading.Thread(target=burnish.composite, args=(scenes.sphere(256, 192), scenes.gradient_sky(), "chrome"),
                              kwargs=dict(camera=scenes.CAMERA, estimator="reference", tolerance=0.05))
    worker.start()
    while worker.is_alive():
        ticks.append(1)
        worker.join(0.005)
    assert len(ticks) > 3


def test_a_lobes_samples_follow_its_density():
    """The mean of f cos / pdf over samples is the albedo that quadrature over the hemisphere gives."""
    lobe = burnish.Lobe({"model": "ggx", "mx": 0.3, "my": 0.2})
    rng = np.random.default_rng(7)
    wo = np.tile([0.5, 0, np.sqrt(0.75)], (40000, 1)).astype(np.float32)
    wi = lobe.sample(wo, rng.random((40000, 2)))
    up = wi[:, 2] > 0
    estimate = (lobe.eval(wo[up], wi[up])[:, 0] * wi[up, 2] / lobe.pdf(wo[up], wi[up])).sum() / len(wo)
    n = 600
    mu, phi = (np.arange(n) + 0.5) / n, 2 * np.pi * (np.arange(n) + 0.5) / n
    mu, phi = map(np.ravel, np.meshgrid(mu, phi))
    grid = np.stack([np.sqrt(1 - mu**2) * np.cos(phi), np.sqrt(1 - mu**2) * np.sin(phi), mu], -1)
    exact = (lobe.eval(np.tile(wo[:1], (n * n, 1)), grid)[:, 0] * mu).mean() * 2 * np.pi
    assert estimate == pytest.approx(exact, rel=0.01)
    assert lobe.albedo(wo[:1])[0, 0] == pytest.approx(exact, rel=0.01)
    assert (lobe.D(grid) * mu).mean() * 2 * np.pi == pytest.approx(1, rel=0.01)


def test_an_environments_samples_follow_its_density():
    light = burnish.Environment(scenes.gradient_sky())
    u = np.random.default_rng(3).random((100000, 2))
    d, pdf = light.sample(u)
    assert np.allclose(np.linalg.norm(d, axis=1), 1, atol=1e-5) and np.allclose(light.pdf(d), pdf, rtol=1e-3)
    everywhere = np.random.default_rng(4).normal(size=(400000, 3))
    everywhere /= np.linalg.norm(everywhere, axis=1, keepdims=True)
    expected = light.radiance(everywhere).mean(0) * 4 * np.pi
    assert np.allclose((light.radiance(d) / pdf[:, None]).mean(0), expected, rtol=0.02)


def test_a_light_that_is_there_is_turned_and_weighed_without_its_file():
    picture, changed = scenes.gradient_sky(), {"env_rotate": 75, "env_scale": 2, "env_tint": [1, 0.5, 2]}
    light = burnish.Environment(picture, env_rotate=20, env_flip=True)
    turned, anew = burnish.Environment(light, **changed), burnish.Environment(picture, env_flip=True, **changed)
    assert np.array_equal(turned.world_to_light, anew.world_to_light) and turned.gain == anew.gain
    with pytest.raises(burnish.BadArgument, match="read its file again"):
        burnish.Environment(light, env_face_size=64)


def test_the_coarsest_level_is_the_mean_of_all_light():
    light = burnish.Environment(scenes.gradient_sky())
    everywhere = np.random.default_rng(4).normal(size=(400000, 3))
    everywhere /= np.linalg.norm(everywhere, axis=1, keepdims=True)
    coarsest = light.lookup([[0, 0, 1], [0, 1, 0], [1, 0, 0], [0, 0, -1], [0, -1, 0], [-1, 0, 0]], light.level_count - 1.0)
    assert np.allclose(coarsest.mean(0), light.radiance(everywhere).mean(0), rtol=0.05)


def test_info_and_compare(tmp_path):
    path = scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    assert "normal" in burnish.info(path)["roles"]
    a = np.full((8, 8, 3), 0.5, np.float32)
    b = a.copy()
    b[2, 3] = 0.75
    measured = burnish.compare(b, a)
    assert measured["largest_error"] == 0.25 and measured["largest_at"] == (3, 2)
    assert measured["relative_rms"] == pytest.approx(np.sqrt(0.25**2 / 64) / 0.5)
    with pytest.raises(burnish.SizeMismatch):
        burnish.compare(a, a[:4])


def test_arrays_need_no_camera_where_positions_tell_it():
    given = burnish.composite(scenes.sphere(128, 96), scenes.gradient_sky(), "chrome", camera=scenes.CAMERA)
    found = burnish.composite(scenes.sphere(128, 96), scenes.gradient_sky(), "chrome")
    assert "recovered" in found["report"]["camera"]
    assert np.allclose(found["overlay"], given["overlay"], rtol=1e-2, atol=1e-3)


def test_flat_arrays_without_a_camera_ask_for_one():
    with pytest.raises(burnish.MissingChannel, match="camera"):
        burnish.composite(scenes.plane(), scenes.gradient_sky(), "chrome")


def test_replace_leaves_pixels_it_cannot_shade_as_they_were():
    frame = scenes.sphere()
    frame["specular_direct"] = np.full(frame["normal"].shape, 0.1, np.float32)
    broken = (24, 32)
    frame["normal"][broken] *= -1
    layers = burnish.composite(frame, scenes.gradient_sky(), "chrome", camera=scenes.CAMERA, mode="replace")
    assert layers["validity"][broken] != 0
    assert np.array_equal(layers["beauty"][broken], frame["beauty"][broken])
    assert not np.array_equal(layers["beauty"][24, 33], frame["beauty"][24, 33])


def test_preview_gives_a_ball_with_alpha():
    ball = burnish.preview("merl:brass", size=32)
    assert ball.shape == (32, 32, 4) and ball.dtype == np.float32
    assert ball[0, 0].max() == 0 and ball[16, 16, 3] == pytest.approx(1) and ball[..., :3].max() > 0
    assert np.array_equal(ball, burnish.preview(burnish.library()["merl:brass"], size=32))
    with pytest.raises(burnish.BadArgument):
        burnish.preview("merl:brass", size=0)
