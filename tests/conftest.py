"""Where the tests find the build (BURNISH_BUILD, default build/release) and the real data (BURNISH_DATA)."""

import os
import pathlib
import re
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(__file__).resolve().parent.parent
BUILD = pathlib.Path(os.environ.get("BURNISH_BUILD", SOURCE / "build" / "release")).resolve()
DATA = pathlib.Path(os.environ.get("BURNISH_DATA", SOURCE / ".." / "shared" / "data")).resolve()
PROGRAM = BUILD / "bin" / "burnish"

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, str(BUILD / "python"))

ERROR_LINE = re.compile(r"^burnish: error: (E_[A-Z_]+) (.+)$")


class Result:
    """What a run of the command line left behind."""

    def __init__(self, finished):
        self.code, self.out, self.err = finished.returncode, finished.stdout, finished.stderr

    @property
    def error(self):
        """(name, message) of the one error line that a failing run ends with."""
        lines = [line for line in self.err.splitlines() if not line.startswith("burnish: warning:")]
        assert len(lines) == 1, f"expected one line, found:\n{self.err}"
        match = ERROR_LINE.match(lines[0])
        assert match, lines[0]
        return match.groups()


@pytest.fixture
def cli():
    """Run the command line: cli("composite", "a.exr", ...) -> Result."""

    def run(*arguments, **options):
        options = {"timeout": 120, **options}
        return Result(subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, **options))

    return run


@pytest.fixture
def data():
    """The file or folder of the real data, or the test is skipped."""

    def find(relative):
        path = DATA / relative
        if not path.exists():
            pytest.skip(f"REAL DATA MISSING: {path}; set BURNISH_DATA")
        return path

    return find
