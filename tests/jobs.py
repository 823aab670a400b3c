"""Fixtures of tests that run small jobs from file to file: `from jobs import composite, work`."""

import burnish
import pytest
import scenes


@pytest.fixture
def work(tmp_path):
    """A folder with a frame and a light."""
    scenes.write_frame(tmp_path / "beauty.exr", scenes.sphere())
    scenes.write_exr(tmp_path / "sky.exr", ["R", "G", "B"], scenes.gradient_sky())
    return tmp_path


@pytest.fixture
def composite(work):
    """Run a job in the folder; the settings `camera` and `preview` are names of files there. Returns the report."""

    def run(aovs, output="out.exr", material="chrome", **settings):
        for name in {"camera", "preview"} & settings.keys():
            settings[name] = str(work / settings[name])
        return burnish.run({"aovs": str(work / aovs)}, env=str(work / "sky.exr"), material=material, output=str(work / output), **settings)

    return run
