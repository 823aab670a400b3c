"""The files that a sequence writes: checked before it runs, cleaned of what dead workers left, and copied where a frame is held."""

from __future__ import annotations

import os
import pathlib
import re
import shutil
from typing import TYPE_CHECKING

from .. import _core
from .._atomic import replaced
from .._shot_documents import FILE_VIEWS, file_of_view
from ..errors import BadArgument

if TYPE_CHECKING:
    from .._shot import Shot
    from .report import FrameOutcome

HIDDEN = re.compile(r"^\.(.*)\.[0-9a-f]{16}(\.\w+)$")  # as the core calls a file until it is whole


class Outputs:
    """Patterns of the files that a shot writes. Raises BadArgument where frames would share one."""

    def __init__(self, shot: Shot) -> None:
        if not _core.has_frame_token(shot.aovs):
            raise BadArgument(f"aovs: '{shot.aovs}' names one file; put #### where the frame number goes")
        if not shot.output:
            raise BadArgument("output: none; name the EXRs to write, such as out.####.exr (shot file: output.file)")
        self.patterns = {name: getattr(shot, name) for name in ("output", "preview") if getattr(shot, name)}
        self.views = FILE_VIEWS if shot.view in ("", "all") else (shot.view,)
        for name, pattern in self.patterns.items():
            if not _core.has_frame_token(pattern):
                raise BadArgument(f"{name}: all frames would be written to '{pattern}'; put #### where the number goes")

    def of(self, frame: int) -> list[pathlib.Path]:
        """Files of a frame."""
        files = (file_of_view(pattern, view) for pattern in self.patterns.values() for view in self.views)
        return list(dict.fromkeys(pathlib.Path(_core.frame_file(file, frame)) for file in files))

    def sweep(self, frames: list[int]) -> None:
        """Remove hidden files that workers left which were killed while they wrote."""
        own = {str(path) for frame in frames for path in self.of(frame)}
        for folder in {pathlib.Path(path).parent for path in own}:
            for hidden in folder.glob(".*"):
                target = HIDDEN.sub(r"\1\2", hidden.name)
                if target != hidden.name and str(folder / target) in own:
                    hidden.unlink(missing_ok=True)


def hold(outcomes: list[FrameOutcome], outputs: Outputs) -> None:
    """Give frames without an output that of the nearest frame before, or else of the first after. The copy is dated so far back that the
    frame is done as soon as it has an input.
    """
    by_number = sorted(outcomes, key=lambda outcome: outcome.frame)
    there = [outcome.frame for outcome in by_number if outcome.status in ("done", "skipped")]
    for outcome in by_number:
        if outcome.status not in ("missing", "failed") or not there:
            continue
        held = max((frame for frame in there if frame < outcome.frame), default=there[0])
        for source, target in zip(outputs.of(held), outputs.of(outcome.frame)):
            if not source.exists():  # a view that the frames do not have
                continue
            with replaced(target) as hidden:
                shutil.copyfile(source, hidden)
                os.utime(hidden, (0, 0))
        outcome.status, outcome.held_from, outcome.output = "held", held, str(outputs.of(outcome.frame)[0])
