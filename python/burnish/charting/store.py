"""What was measured, line by line on disk: a run that was stopped goes on where it stopped.

Lines carry the digest of their scene, so that those of another version, of other settings or of a shot that has changed are
never taken for today's. Beside them lies what the reference saw, and the error images, of each scene.
"""

from __future__ import annotations

import dataclasses
import json

import numpy as np

from .bench import Row

COLUMNS = [field.name for field in dataclasses.fields(Row)]


class Store:
    """The folder `measured` of an output folder."""

    def __init__(self, folder):
        self.folder = folder / "measured"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.file = self.folder / "rows.jsonl"
        self.rows, self.done = {}, set()  # (digest, material, setting) -> Row
        self.new = 0
        for line in self.file.read_text().splitlines() if self.file.exists() else ():
            self.take(line)

    def take(self, line):
        """Add a line of the file; the last one may have been cut off as the run ended."""
        try:
            entry = json.loads(line)
        except json.JSONDecodeError:
            return
        if "done" in entry:
            self.done.add(entry["digest"])
        elif set(entry["row"]) == set(COLUMNS):
            self.keep(entry["digest"], Row(**entry["row"]))

    def keep(self, digest, row):
        """Hold a row in memory."""
        self.rows[digest, row.material, row.setting] = row

    def add(self, digest, row):
        """Hold a new row and write it."""
        self.keep(digest, row)
        self.new += 1
        self.write({"digest": digest, "row": dataclasses.asdict(row)})

    def finish(self, digest):
        """Note that a scene is complete."""
        self.done.add(digest)
        self.write({"digest": digest, "done": True})

    def write(self, entry):
        """A line, on disk before the next is measured; on a line of its own also after one that was cut off."""
        with open(self.file, "a+b") as file:
            if file.tell():
                file.seek(-1, 2)
                file.write(b"" if file.read(1) == b"\n" else b"\n")
            file.write(json.dumps(entry).encode() + b"\n")

    def find(self, digest, material, setting):
        """The row of a setting, or None."""
        return self.rows.get((digest, material, setting))

    def of(self, digests):
        """All rows of scenes, in the order of these."""
        return [row for digest in digests for key, row in self.rows.items() if key[0] == digest]

    def others(self, digests):
        """How many rows are of anything else."""
        return sum(key[0] not in digests for key in self.rows)

    def save(self, name, digest, **arrays):
        """Keep arrays of a scene, in place of what was kept."""
        np.savez_compressed(self.folder / f".{name}.npz", **arrays)
        (self.folder / f".{name}.npz").replace(self.folder / f"{name}-{digest}.npz")

    def load(self, name, digest):
        """The arrays of a scene by name; none where nothing was kept."""
        file = self.folder / f"{name}-{digest}.npz"
        if not file.exists():
            return {}
        with np.load(file) as arrays:
            return dict(arrays)


def write_json(rows, path, **about):
    """All rows as objects, with what they are of."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump({**about, "rows": [dataclasses.asdict(row) for row in rows]}, file, indent=0)
