# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package burnish: the one in lib/ beside this file, or the one that is installed. Nothing else here imports it first.

Where neither can be loaded `load()` is None and `failure()` says why; the panels show that, and nothing else works.
"""

import importlib
import os
import pathlib
import sys

LIB = pathlib.Path(__file__).parent / "lib"

_failures = []


def load():
    """The package, or None."""
    if "burnish" in sys.modules:
        return sys.modules["burnish"]
    _failures.clear()
    bundled = [str(LIB)] if (LIB / "burnish").is_dir() else []
    for folder in (*bundled, None):
        if (package := _imported(folder)) is not None:
            return package
    return None


def failure():
    """Why there is no package, in one line for each place that was tried."""
    return list(_failures)


def where():
    """The folder of the package and its version."""
    package = load()
    return f"burnish {package.__version__} in {pathlib.Path(package.__file__).parent}" if package else ""


def program():
    """The command line: the one beside the package. Zip archives lose the right to run it, which is given back here."""
    path = pathlib.Path(load().__file__).parent / "bin" / "burnish"
    if path.exists() and not os.access(path, os.X_OK):
        path.chmod(path.stat().st_mode | 0o755)
    return str(path) if path.exists() else "burnish"


def _imported(folder):
    """The package from a folder, or from wherever Python looks."""
    if folder:
        sys.path.insert(0, folder)
    try:
        return importlib.import_module("burnish")
    except ImportError as error:
        for name in [name for name in sys.modules if name.split(".")[0] == "burnish"]:
            del sys.modules[name]
        place = "the add-on's own burnish" if folder else "an installed burnish"
        _failures.append(f"{place} cannot be loaded by Blender's Python {sys.version.split()[0]}: {error}")
    finally:
        if folder:
            sys.path.remove(folder)
    return None
