"""What burnish does with every public sample file, as a table: processed, or refused and why.

    python3 tests/bench/sample_files.py ../shared/data > docs/sample_files.md

Runs `burnish info` (as a Python call, which prints the same) and `burnish composite` on each: as the frame, under a plain environment and in one material; files of env/ as the
environment of a plain frame. `test_sample_files.py` holds that the table says what happens.
"""

import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BURNISH_BUILD", ROOT / "build" / "release")).resolve()
sys.path[:0] = [str(ROOT / "tests"), str(BUILD / "python")]

import burnish  # noqa: E402
import scenes  # noqa: E402

FOLDERS = ("env", "exr_aov", "exr_spec", "exr_bad")
MOST_MEMORY = 3 << 30
MOST_SECONDS = 60
ERROR = re.compile(r"^burnish: error: (E_[A-Z_]+) (.+)$")

HEAD = """# Sample files

What burnish does with the public sample files that it is tested with: files of renderers, of the OpenEXR and OpenImageIO test suites, of other
tools, and damaged ones. Nothing crashes, hangs or takes more memory than its pixels need: a file is processed, or refused with one line.

Frames need position and normal to be composited, which few of these have; `info` shows what burnish reads of them. Files of `env/` are composited
with as environments, all others as frames. Made by `tests/bench/sample_files.py`; `tests/test_sample_files.py` holds that it is true.

| file | what it is | `burnish info` | `burnish composite` |
|---|---|---|---|"""


def sample_files(data):
    """Paths of all samples, relative to the folder public/ of `data`, in the order of the table."""
    public = pathlib.Path(data) / "public"
    return [path.relative_to(public) for folder in FOLDERS for path in sorted((public / folder).glob("*")) if path.suffix != ".json"]


def descriptions(data):
    """Relative path -> what the data's README says of it."""
    told, folder = {}, ""
    for line in (pathlib.Path(data) / "public/README.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if line.startswith("## "):
            folder = line[3:].strip()
        elif len(cells) > 4 and cells[1].startswith("`"):
            told[f"{folder}/{cells[1].strip('`')}"] = cells[3]
    return told


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def why(message, file):
    """The reason of a refusal without the file's name and without the remedy."""
    return re.split(r"; | \(|: Failed|: OpenEXR|\. ", message.removeprefix(f"{file}: "))[0]


class Composite:
    """How `burnish composite` with a file ended: its exit code, and the error line if it failed."""

    def __init__(self, data, file, plain):
        frame, light = (plain / "plain.exr", file) if file.parts[0] == "env" else (file, plain / "sky.exr")
        self.output = plain / f"{file.name}.out.exr"
        words = ["composite", frame, "--env", light, "--material", "chrome", "--env-face-size", 64, "-o", self.output]
        run = subprocess.run([BUILD / "bin" / "burnish", *map(str, words)], cwd=pathlib.Path(data) / "public", preexec_fn=limit_memory,
                             capture_output=True, text=True, timeout=MOST_SECONDS)
        lines = [line for line in run.stderr.splitlines() if not line.startswith("burnish: warning:")]
        match = ERROR.match(lines[0]) if len(lines) == 1 else None
        self.code, self.err = run.returncode, run.stderr
        self.error, self.message = match.groups() if match else ("", "")
        self.is_clean = (self.code == 0 and not lines) or (self.code in (1, 2) and match is not None and str(file) in self.message)


def read_as(data, file):
    """What `burnish info` sees, in a few words."""
    try:
        frame = burnish.info(pathlib.Path(data) / "public" / file)
    except burnish.Error as error:
        return f"refused: {why(str(error), pathlib.Path(data) / 'public' / file)}"
    width, height = frame["data_window"][2:]
    seen = ", ".join(frame["roles"] + [f"cryptomatte {name}" for name in frame["cryptomattes"]])
    return f"{width}x{height}: {seen or 'no layer that it knows'}"


def row(data, file, what, composite):
    """A line of the table."""
    done = "processed" if composite.code == 0 else f"refused, `{composite.error}`: {why(composite.message, file)}"
    cells = [f"`{file}`", what, read_as(data, file), done]
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def make_plain(folder):
    """A plain frame and a plain environment."""
    scenes.write_frame(folder / "plain.exr", scenes.sphere(24, 16))
    scenes.write_exr(folder / "sky.exr", ["R", "G", "B"], scenes.gradient_sky(16))
    return folder


def main(data):
    told = descriptions(data)
    print(HEAD)
    with tempfile.TemporaryDirectory() as folder:
        plain = make_plain(pathlib.Path(folder))
        for file in sample_files(data):
            print(row(data, file, told[str(file)], Composite(data, file, plain)))


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
