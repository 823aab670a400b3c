"""The estimator `factored` as users meet it: maps made on the way or read from files, and what it refuses."""

import burnish
import numpy as np
import pytest
import scenes

LAMP = {"lamp": {"type": "area", "corners": [[-1, -1, 3], [-1, 1, 3], [1, 1, 3], [1, -1, 3]], "radiance": 5}}
GOLD = {"material": "gold", "density": "dense", "up": "z"}


@pytest.fixture(scope="module")
def sky():
    return scenes.gradient_sky()


@pytest.fixture(scope="module")
def maps(sky, tmp_path_factory):
    """A file of maps as `factored` makes them itself."""
    file = tmp_path_factory.mktemp("maps") / "gold.exr"
    burnish.factor("gold", sky, file, measure="display", up="z")
    return file


def overlay(light, **settings):
    return burnish.composite(scenes.sphere(), light, **{**GOLD, **settings})["overlay"]


def test_it_is_near_the_default_estimator(sky):
    by_maps, known = overlay(sky, estimator="factored"), overlay(sky)
    assert np.sqrt(((by_maps - known) ** 2).mean() / (known**2).mean()) < 0.05


def test_maps_from_a_file_are_those_it_makes(sky, maps):
    made, read = overlay(sky, estimator="factored"), overlay(sky, estimator="factored", factors={"gold": str(maps)})
    np.testing.assert_allclose(read, made, rtol=5e-3, atol=1e-4)  # half floats


def test_maps_from_a_file_serve_the_light_however_it_is_turned_and_scaled(sky, maps):
    turned = {"env_rotate": 70, "env_scale": 2, "estimator": "factored"}
    read = overlay(sky, **turned, factors={"gold": str(maps)})
    np.testing.assert_allclose(read, overlay(sky, **turned), rtol=5e-3, atol=1e-4)


def test_a_report_tells_how_many_lookups_it_took(sky):
    layers = burnish.composite(scenes.sphere(), sky, **GOLD, estimator="factored", parametrization="nr", diagnostics=True)
    assert set(np.unique(layers["samples"])) == {0, 2}


@pytest.mark.parametrize("settings, words", [
    ({"material": "brushed-steel"}, "anisotropic"),
    ({"per_pixel": ["roughness"]}, "layer"),
    ({"factors": {"silver": "silver.exr"}}, "no rule wears material 'silver'"),
    ({"factors": {"gold": "gold.exr"}, "estimator": "fitted"}, "--estimator factored"),
    ({"factors": {"gold": "nowhere.exr"}}, "nowhere.exr"),
    ({"parametrization": "pqp"}, "nrhd"),
    ({"lights": LAMP}, "a light that is near"),
])
def test_what_it_cannot_shade_is_said_with_a_remedy(sky, settings, words):
    with pytest.raises(burnish.Error, match=words):
        overlay(sky, **{"estimator": "factored", **settings})
