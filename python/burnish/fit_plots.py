"""`burnish fit-plots`: the report of a fit as pictures."""

from __future__ import annotations

import argparse
import importlib.util
import json
import pathlib
import sys

from ._command_line import FAILED, USAGE, fail
from .charting import fit_picture
from .charting.files import check_folder
from .errors import BadArgument, Error, ReadFailed

DESCRIPTION = """Draws what `burnish fit --report` wrote: DIR/slices.png (data and fit along both slices), DIR/lobes.png (polar
lobes by the light's angle, cube roots of the values), and DIR/balls.png (a ball of the data, one of the fit, and their
difference), the last one only where the table is still where it was."""


def main(arguments=None):
    """Run the command; returns its exit code."""
    words = argparse.ArgumentParser("burnish fit-plots", description=DESCRIPTION)
    words.add_argument("report", metavar="REPORT", type=pathlib.Path, help="JSON of burnish fit --report")
    words.add_argument("-o", "--output", metavar="DIR", type=pathlib.Path, required=True, help="folder to write to")
    options = words.parse_args(arguments)
    try:
        for path in run(options):
            print(path)
    except Error as error:
        return fail(error.code, error, USAGE if isinstance(error, BadArgument) else FAILED)
    return 0


def run(options):
    """Read, draw, write; returns the files."""
    if importlib.util.find_spec("matplotlib") is None:
        raise ReadFailed("matplotlib is not installed; apt install python3-matplotlib, or pip install matplotlib")
    check_folder(options.output)
    report = read(options.report)
    options.output.mkdir(parents=True, exist_ok=True)
    files = []
    for name, figure in fit_picture.figures(report):
        files.append(options.output / f"{name}.png")
        fit_picture.save(name, figure, files[-1])
    return files


def read(path):
    """The report; what is no report is refused."""
    try:
        report = json.loads(path.read_text())
    except OSError as error:
        raise ReadFailed(f"{path}: {error.strerror}") from None
    except ValueError as error:
        raise ReadFailed(f"{path}: no JSON: {error}") from None
    if not isinstance(report, dict) or not {"material", "curves", "errors", "table"} <= report.keys():
        raise BadArgument(f"{path}: expected a report of burnish fit --report")
    return report


if __name__ == "__main__":
    sys.exit(main())
