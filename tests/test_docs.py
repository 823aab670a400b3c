"""README and docs: their code is the examples' code, their names are the program's, their pictures, links and tables are true."""

import json
import re
import subprocess
import sys

import pytest
from conftest import SOURCE

PAGES = [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]
EXAMPLES = {"sh": "*.sh", "python": "*.py", "cpp": "*.cpp", "json": "*.json"}
RUN_BY_ANOTHER_TEST = {"python.md"}  # its blocks are run one by one


def blocks(page):
    """(language, code) of every block of a page."""
    return re.findall(r"^```(\w+)\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)


def anchor(title):
    """Of a heading, as on the web."""
    return re.sub(r"[^\w\- ]", "", title.strip().lower()).replace(" ", "-")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_code_is_what_the_examples_run(page):
    for language, code in blocks(page):
        if page.name in RUN_BY_ANOTHER_TEST or language not in EXAMPLES or "examples/demo.sh" in code:
            continue
        sources = [path.read_text() for path in (SOURCE / "examples").rglob(EXAMPLES[language])]
        if language == "json" and page.name == "shot_file.md":
            sources.append((SOURCE / "docs/shot_file.py").read_text())
        assert any(code in text for text in sources), code


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    for target in re.findall(r"\]\(([^):]+)\)", page.read_text()):
        file, _, part = target.partition("#")
        linked = page.parent / file if file else page
        assert linked.exists(), target
        if part:
            assert part in [anchor(title) for title in re.findall(r"^#+ (.*)", linked.read_text(), re.MULTILINE)], target


def test_the_two_commands_are_there():
    commands = re.findall(r"^(\S+/\S+\.sh) ", PAGES[0].read_text(), re.MULTILINE)
    assert commands == ["examples/demo.sh", "tests/run.sh"]
    assert all((SOURCE / command).exists() for command in commands)


def test_presets_and_estimators_are_the_programs(cli):
    presets = json.loads(cli("models", "--json").out)["presets"]
    materials = (SOURCE / "docs/materials.md").read_text()
    assert all(preset in materials for preset in presets)
    methods = (SOURCE / "docs/methods.md").read_text()
    quality = json.loads(cli("composite", "--schema").out)["properties"]["quality"]["properties"]
    assert re.findall(r"^\| `(\w+)` \|", methods, re.MULTILINE) == quality["estimator"]["enum"]


def test_options_that_the_pages_name_exist(cli):
    known = "".join(cli(command, "--help").out for command in
                    ("composite", "bandwidth", "bake", "fit", "factor", "chart", "envmap", "compare", "demo", "info", "preview"))
    for page in PAGES:
        if page.name not in ("measured.md", "python.md"):
            for option in re.findall(r"`(--[a-z][a-z-]+)", page.read_text()):
                assert option in known, f"{page.name}: {option}"


def test_the_shot_file_page_is_of_this_schema(cli):
    made = subprocess.run([sys.executable, SOURCE / "docs/shot_file.py"], input=cli("composite", "--schema").out, text=True,
                          capture_output=True, check=True).stdout
    assert (SOURCE / "docs/shot_file.md").read_text() == made, "burnish composite --schema | python3 docs/shot_file.py > docs/shot_file.md"
