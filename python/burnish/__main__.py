"""``python -m burnish`` runs the command line that was installed with the package, or the one on the PATH."""

import os
import pathlib
import shutil
import sys


def main():
    """Replace this process by the burnish program, with the same arguments."""
    beside = pathlib.Path(__file__).parent / "bin" / "burnish"
    program = str(beside) if beside.exists() else shutil.which("burnish")
    if program is None or os.path.realpath(program) == os.path.realpath(sys.argv[0]):  # or it would run itself for ever
        sys.exit("burnish: error: E_READ_FAILED the burnish program is not on the PATH; install it with cmake --install")
    # Commands in Python that burnish starts, such as burnish-chart, run in this one.
    folders = [os.path.dirname(sys.executable), os.environ.get("PATH", os.defpath)]
    os.execve(program, [program, *sys.argv[1:]], {**os.environ, "PATH": os.pathsep.join(folders)})


if __name__ == "__main__":
    main()
