"""Fixtures of tests that run small jobs on the command line: `from jobs import composite, work`."""

import pytest
import scenes


@pytest.fixture
def work(tmp_path):
    """A folder with a frame and a light."""
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    return tmp_path


@pytest.fixture
def composite(cli, work):
    """Run a job in the folder; must succeed unless told otherwise."""

    def run(aovs, *words, output="out.exr", material="chrome", fails=False):
        result = cli("composite", aovs, "--env", "sky.exr", "--material", material, "-o", output, *words, cwd=work)
        assert fails or result.code == 0, result.err
        return result

    return run
