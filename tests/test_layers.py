"""The house keeps its order: stages include only what stands above them, headers stand alone, nothing is left lying about."""

import concurrent.futures
import json
import os
import re
import subprocess

import pytest
from conftest import BUILD, SOURCE

CORE = SOURCE / "core" / "burnish"
STAGES = re.search(r"set\(stages ([a-z ]+)\)", (SOURCE / "core/CMakeLists.txt").read_text()).group(1).split()
HEADERS = sorted(CORE.rglob("*.h"))
OWN_FILES = [path for folder in ("core", "python", "tests", "examples", "plugin") if (SOURCE / folder).exists()
             for path in sorted((SOURCE / folder).rglob("*")) if path.suffix in (".h", ".cpp", ".py", ".pyi", ".def", ".cmake", ".sh", ".txt")]
HEAVY = ("OpenImageIO/", "OpenColorIO/", "embree", "tbb", "oneapi/", "Eigen/", "hwy/")


def includes(path):
    return re.findall(r'^\s*#include [<"]([^>"]+)[>"]', path.read_text(), re.MULTILINE)


def test_every_stage_has_its_place():
    assert sorted(STAGES) == sorted(path.name for path in CORE.iterdir() if path.is_dir())


@pytest.mark.parametrize("stage", STAGES)
def test_a_stage_includes_only_stages_above_it(stage):
    allowed = set(STAGES[: STAGES.index(stage) + 1])
    for path in (CORE / stage).rglob("*.[hc]*"):
        used = {name.split("/")[1] for name in includes(path) if re.match(r"burnish/\w+/", name)}
        assert used <= allowed, f"{path} includes {sorted(used - allowed)}"


def test_public_headers_are_light():
    def internal(path):
        return "nternal" in path.read_text().split("#pragma once")[0]

    for path in HEADERS:
        heavy = [name for name in includes(path) if name.startswith(HEAVY)]
        assert not heavy or internal(path), f"{path} includes {heavy}; say \"Internal\" in its first lines or hide it"


def test_the_umbrella_is_in_the_order_of_the_stages():
    order = [STAGES.index(name.split("/")[1]) for name in includes(CORE / "burnish.h")]
    assert order == sorted(order) and len(set(order)) >= len(STAGES) - 1


def compile_command():
    database = json.loads(subprocess.run(["ninja", "-C", BUILD, "-t", "compdb"], capture_output=True, text=True).stdout)
    command = next(entry["command"] for entry in database if entry["file"].endswith("burnish/job/run.cpp"))
    return [word for word in command.split() if word.startswith(("-I", "-isystem", "-D", "-std", "/usr/include"))]


def is_first_in_its_source(header):
    """Whether the build has compiled it with nothing before it: its .cpp includes it first."""
    source = header.with_suffix(".cpp")
    return source.exists() and includes(source)[:1] == [str(header.relative_to(SOURCE / "core"))]


def test_every_header_compiles_alone():
    flags, headers = compile_command(), [header for header in HEADERS if not is_first_in_its_source(header)]

    def failure(header):
        command = ["c++", "-fsyntax-only", "-x", "c++", *flags, str(header)]
        return subprocess.run(command, capture_output=True, text=True).stderr.replace("#pragma once in main file", "")

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for header, text in zip(headers, pool.map(failure, headers)):
            assert "error:" not in text, f"{header}\n{text}"


@pytest.mark.parametrize("path", OWN_FILES, ids=lambda path: str(path.relative_to(SOURCE)))
def test_nothing_is_left_lying_about(path):
    if path.name == "test_layers.py":
        return
    text = path.read_text()
    for leftover in (r"#if 0", r"\bTODO\b", r"\bFIXME\b", r"\bXXX\b", r"\bHACK\b", r"/home/\w"):
        found = re.search(leftover, text)
        assert not found, found.group()


@pytest.mark.parametrize("path", [p for p in OWN_FILES if p.suffix in (".h", ".cpp", ".py")], ids=lambda path: str(path.relative_to(SOURCE)))
def test_files_stay_short(path):
    count = len(path.read_text().splitlines())
    assert count <= 320, f"{count} lines: split it by idea"
