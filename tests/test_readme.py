"""The README: its code is the examples' code, its names are the program's, its pictures and links exist."""

import json
import re

import pytest
from conftest import SOURCE

README = (SOURCE / "README.md").read_text()


@pytest.mark.parametrize("language, example", [("sh", "quickstart.sh"), ("sh", "antialias.sh"), ("sh", "room.sh"), ("sh", "measured.sh"), ("sh", "target.sh"), ("sh", "progressive.sh"), ("python", "progressive.py"), ("json", "lights.json"), ("python", "quickstart.py"), ("cpp", "quickstart.cpp")])
def test_code_is_what_the_examples_run(language, example):
    blocks = re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)
    assert any(block in (SOURCE / "examples" / example).read_text() for block in blocks)


def test_files_it_names_exist():
    targets = re.findall(r"\]\(([^)#:]+)\)", README) + re.findall(r"^(\S+/\S+\.sh) ", README, re.MULTILINE)
    assert targets
    for target in targets:
        assert (SOURCE / target).exists(), target


def test_presets_and_estimators_are_the_programs(cli):
    presets = json.loads(cli("models", "--json").out)["presets"]
    help_text = cli("composite", "--help").out
    assert all(preset in README for preset in presets)
    assert all(name in help_text for name in re.findall(r"^\| `(\w+)` \|", README, re.MULTILINE))
