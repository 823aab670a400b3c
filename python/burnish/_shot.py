"""`burnish.Shot`: a shot document as a value that is checked when it is made and never changes."""

from __future__ import annotations

import copy
import difflib
import json
import os
from typing import TYPE_CHECKING, Any, NamedTuple

from . import _core
from ._atomic import write_text
from ._shot_documents import by_name, file_of_view, settings_of_frame, spelled_out, with_absolute_materials

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ._core import Progress

    Path = str | os.PathLike[str]


class Frames(NamedTuple):
    """Which frames a shot has.

    Attributes
    ----------
    numbers : list of int
        The frames it asks for, in order; where it names none, those on disk, ascending.
    missing : list of int
        Those of them that have no file; where the shot names none, the gaps between the first and the last on disk.
    """

    numbers: list[int]
    missing: list[int]


class Shot:
    """A shot document as a value: checked at once by the core, never changed, equal when it means the same.

    Every setting can be read as an attribute (``shot.samples``), by the names of `burnish.settings`. Paths are absolute: those
    of a shot file are taken from its folder, others from the working directory.

    Parameters
    ----------
    source : str or os.PathLike or dict or Shot, optional
        A shot file, a document as a shot file holds it (see `burnish.shot_schema`), or another shot.
    **settings
        Settings by name; they win over the source's. `materials` may also be a preset, a file or one material, and `camera` a
        position, as for `burnish.composite`.

    Raises
    ------
    BadArgument
        A field is unknown or out of range; the message names its path in the document.
    ReadFailed
        The shot file is absent.

    Examples
    --------
    >>> shot = Shot(aovs="beauty.####.exr", env="studio.hdr", materials="chrome", output="out.####.exr")
    >>> shot.with_(samples=8).samples
    8
    """

    __slots__ = ("_document",)
    __hash__ = None  # type: ignore[assignment]
    _document: dict[str, Any]

    def __init__(self, source: Path | Mapping[str, Any] | Shot | None = None, **settings: Any) -> None:
        here = os.getcwd()
        if isinstance(source, Shot):
            source = source._document
        elif source is not None and not isinstance(source, dict):
            source = os.path.abspath(source)
        document = _core.shot_document(source or {}, spelled_out(settings, is_new=source is None), here)
        self._document = with_absolute_materials(document, here)

    @property
    def document(self) -> dict[str, Any]:
        """The document as a shot file holds it, a copy; settings at their defaults are left out."""
        return copy.deepcopy(self._document)

    @property
    def settings(self) -> dict[str, Any]:
        """Settings by name, a copy; those at their defaults are left out."""
        return {name: copy.deepcopy(value) for name, value in by_name(self._document).items()}

    def __getattr__(self, name: str) -> Any:
        """The value of a setting, or its default."""
        defaults = {} if name.startswith("_") else {setting["name"]: setting["default"] for setting in _core.settings()}
        if name not in defaults:
            near = difflib.get_close_matches(name, defaults, 1)
            raise AttributeError(f"a shot has no setting '{name}'" + (f"; did you mean '{near[0]}'?" if near else ""))
        return self.settings.get(name, defaults[name])

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(setting["name"] for setting in _core.settings())})

    def __eq__(self, other: object) -> bool:
        return self._document == other._document if isinstance(other, Shot) else NotImplemented

    def __repr__(self) -> str:
        return f"Shot({self._document!r})"

    def with_(self, **changes: Any) -> Shot:
        """Make the same shot with other settings.

        Parameters
        ----------
        **changes
            Settings by name; lists and objects take the place of the old ones.

        Returns
        -------
        Shot
            A new one; this one stays as it is. Its document is a dict of other settings.

        Raises
        ------
        BadArgument
            A setting is unknown or out of range.
        """
        return Shot(self, **changes)

    def write(self, path: Path) -> None:
        """Write the shot file, whole or not at all; reading it gives an equal shot.

        Parameters
        ----------
        path : str or os.PathLike
            The file, ``.json``; its folder is made when it is absent.

        Returns
        -------
        None
            The file holds the document, a JSON object; `document` is the same as a dict.

        Raises
        ------
        WriteFailed
            The file cannot be written.
        """
        write_text(path, json.dumps(self._document, indent=2) + "\n")

    def frames(self) -> Frames:
        """Find the frames on disk.

        Returns
        -------
        Frames
            Frame numbers, each a list: ``numbers`` and, of these, ``missing``.

        Raises
        ------
        BadArgument
            `aovs` names one file, or `frames` is no range.
        """
        found = _core.frames_on_disk(file_of_view(self.aovs, self.view))
        if "frames" not in self._document:
            return Frames(found, sorted(set(range(found[0], found[-1])) - set(found)) if found else [])
        asked = _core.parse_frames(self._document["frames"])
        return Frames(asked, [number for number in asked if number not in set(found)])

    def composite(self, frame: int | None = None, progress: Progress | None = None, **changes: Any) -> dict[str, Any]:
        """Composite one frame in memory.

        Parameters
        ----------
        frame : int, optional
            Its number, where `aovs` is a pattern.
        progress : callable, optional
            ``progress(stage, done)``, done in [0, 1]; returning False cancels.
        **changes
            Settings by name that differ from the shot's.

        Returns
        -------
        dict
            Layers of shape (height, width, channels), float32, linear, and the report: as `burnish.composite`.

        Raises
        ------
        BadArgument, MissingChannel, SizeMismatch, ReadFailed, ColorSpaceError
            What went wrong.
        Cancelled
            `progress` returned False.
        """
        shot = self.with_(**changes) if changes else self
        return _core.composite(None, None, None, None, settings_of_frame(shot._document, frame), progress)

    def run(self, progress: Progress | None = None, **changes: Any) -> dict[str, Any]:
        """Composite all frames from file to file in this process; `burnish.sequence.run` does it on several, or on a farm.

        Parameters
        ----------
        progress : callable, optional
            ``progress(stage, done)`` with done in [0, 1] over the whole run; returning False cancels.
        **changes
            Settings by name that differ from the shot's.

        Returns
        -------
        dict
            The report, as `burnish.run`.

        Raises
        ------
        BadArgument, MissingChannel, SizeMismatch, ReadFailed, WriteFailed, ColorSpaceError
            What went wrong; nothing half-written is left behind.
        Cancelled
            `progress` returned False.
        """
        return _core.run(self._document, spelled_out(changes, is_new=False), progress)
