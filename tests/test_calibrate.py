"""burnish calibrate: what it writes, where, and what a broken calibration says."""

import json
import os

import pytest


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("calibration")


@pytest.fixture
def environment(folder):
    return {**os.environ, "BURNISH_COSTS": str(folder / "deep" / "costs.json")}


def test_it_writes_what_it_prints(cli, environment, folder):
    done = cli("calibrate", "--json", env=environment)
    assert done.code == 0, done.err
    printed = json.loads(done.out)
    assert json.loads((folder / "deep" / "costs.json").read_text()) == printed
    assert printed["cores"] == os.cpu_count()
    constants = printed["nanoseconds"]
    for name in ("pyramid_texel", "stack_texel", "fit_lookup", "lookup", "stack_lookup", "reference_lookup", "near_ray"):
        assert constants[name] > 0, name
    assert all(cost > 0 for cost in printed["evaluation"].values()) and "sgd" in printed["evaluation"]


def test_help_says_what_it_is_for(cli):
    shown = cli("calibrate", "--help")
    assert shown.code == 0
    assert "--time" in shown.out and "BURNISH_COSTS" in shown.out and "--dry-run" in shown.out


def test_a_folder_is_no_file(cli, folder):
    name, message = cli("calibrate", "-o", folder).error
    assert name == "E_WRITE_FAILED" and "directory" in message
