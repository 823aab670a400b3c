"""What burnish does with every public sample file, as a table: processed, or refused and why.

    python3 tests/bench/sample_files.py ../shared/data > docs/sample_files.md

Does on each what `burnish info` and `burnish composite` do: as the frame, under a plain environment and in one material; files of env/ as
the environment of a plain frame. `test_sample_files.py` holds that the table says what happens.
"""

import os
import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("BURNISH_BUILD", ROOT / "build" / "release")).resolve()
sys.path[:0] = [str(ROOT / "tests"), str(BUILD / "python")]

import burnish  # noqa: E402
import scenes  # noqa: E402

FOLDERS = ("env", "exr_aov", "exr_spec", "exr_bad")

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


def why(message, file):
    """The reason of a refusal without the file's name and without the remedy."""
    return re.split(r"; | \(|: Failed|: OpenEXR|\. ", message.removeprefix(f"{file}: "))[0]


class Composite:
    """How a job with a file ended: `error` is what it was refused with, else None."""

    def __init__(self, data, file, plain):
        path = pathlib.Path(data) / "public" / file
        frame, light = (plain / "plain.exr", path) if file.parts[0] == "env" else (path, plain / "sky.exr")
        self.output, self.error = plain / f"{file.name}.out.exr", None
        try:
            burnish.run({"aovs": str(frame), "material": "chrome", "output": {"file": str(self.output)},
                         "lights": {"sky": {"file": str(light), "face_size": 64}}})
        except burnish.Error as error:
            self.error = error


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
    path = pathlib.Path(data) / "public" / file
    done = f"refused, `{composite.error.code}`: {why(str(composite.error), path)}" if composite.error else "processed"
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
