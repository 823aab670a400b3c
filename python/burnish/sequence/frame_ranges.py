"""Frame ranges as text in the dialects of the programs that write them.

               1-9x4      1-9y4            1-9:4                  9-1
    burnish    1,5,9      refused          1,5,9                  refused
    openjd     refused    refused          1,5,9                  refused; 9-1:-1 is 1-9
    fileseq    1,5,9      2-4,6-8          1,5,9,4,7,3,2,6,8      9,8,7,...     (1-9:4 is 1-9x4,1-9x3,1-9x2,1-9)
    oiio       1,5,9      2-4,6-8          refused                9,8,7,...     (1-9x-4 is 9,5,1)

Commas separate ranges everywhere, and numbers may be negative: -5--1. Each frame comes once, where it comes first.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Literal

from .. import _core
from ..errors import BadArgument

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    Dialect = Literal["burnish", "openjd", "fileseq", "oiio"]

MOST_FRAMES = 1_000_000
ITEM = re.compile(r"(-?\d+)(?:\s*-\s*(-?\d+)(?:([xy:])(-?\d+))?)?")


def parse_frames(text: str, dialect: Dialect = "burnish") -> list[int]:
    """Read a frame range as the program means that wrote it.

    Parameters
    ----------
    text : str
        Such as "1-24", "1-100x5" or "1,3,7-9".
    dialect : {"burnish", "openjd", "fileseq", "oiio"}
        ``1-9:4`` is every fourth frame for OpenJD and burnish, and a staggered order of all frames for fileseq.

    Returns
    -------
    list of int
        Frame numbers in the order they are given, each once; those of OpenJD, which has no order, ascending.

    Raises
    ------
    BadArgument
        The text is no range of this dialect.

    Examples
    --------
    >>> parse_frames("1-9:4", "openjd"), parse_frames("1-9:4", "fileseq")
    ([1, 5, 9], [1, 5, 9, 4, 7, 3, 2, 6, 8])
    """
    _check(dialect)
    if dialect == "burnish":
        return _core.parse_frames(text)
    expand = EXPANDERS[dialect]
    frames: dict[int, None] = {}
    for item in text.split(","):
        if item.strip():
            found = expand(text, item.strip())
            if dialect == "openjd" and not frames.keys().isdisjoint(found):
                raise _refusal(text, f'"{item.strip()}" overlaps a range before it, which OpenJD does not allow')
            frames.update(dict.fromkeys(found))
            if len(frames) > MOST_FRAMES:
                raise _refusal(text, "more than a million frames; check the range")
    if not frames:
        raise _refusal(text, "no frame; give ranges such as 1-24")
    return sorted(frames) if dialect == "openjd" else list(frames)


def format_frames(frames: Iterable[int], dialect: Dialect = "burnish") -> str:
    """Write frame numbers as a range.

    Parameters
    ----------
    frames : iterable of int
        Frame numbers; each is written once, in the order given (of OpenJD: ascending).
    dialect : {"burnish", "openjd", "fileseq", "oiio"}
        Who is to read it.

    Returns
    -------
    str
        The range; `parse_frames` makes the same list of it.

    Raises
    ------
    BadArgument
        The dialect is unknown.

    Examples
    --------
    >>> format_frames([1, 2, 3, 10, 12, 14], "openjd")
    '1-3,10-14:2'
    """
    _check(dialect)
    numbers = list(dict.fromkeys(frames))
    if dialect == "openjd":
        numbers.sort()
    return ",".join(_item(run, dialect) for run in _runs(numbers, counts_down=dialect in ("fileseq", "oiio")))


def _runs(numbers: Sequence[int], counts_down: bool) -> Iterable[Sequence[int]]:
    """Split into pieces with one step each: of three numbers or more, or single ones."""
    begin = 0
    while begin < len(numbers):
        step = numbers[begin + 1] - numbers[begin] if begin + 1 < len(numbers) else 0
        end = begin + 1
        while end < len(numbers) and numbers[end] - numbers[end - 1] == step and (counts_down or step > 0):
            end += 1
        end = end if end - begin > 2 else begin + 1
        yield numbers[begin:end]
        begin = end


def _item(run: Sequence[int], dialect: Dialect) -> str:
    """One piece of a range."""
    if len(run) == 1:
        return str(run[0])
    step = abs(run[1] - run[0])
    sign = ":" if dialect == "openjd" else "x"
    return f"{run[0]}-{run[-1]}" + (f"{sign}{step}" if step > 1 else "")


def _check(dialect: str) -> None:
    if dialect not in ("burnish", *EXPANDERS):
        raise BadArgument(f"dialect: expected burnish, {', '.join(EXPANDERS)}, found '{dialect}'")


def _refusal(text: str, reason: str) -> BadArgument:
    return BadArgument(f'frames "{text}": {reason}')


def _parts(text: str, item: str, signs: str, example: str) -> tuple[int, int, str, int]:
    """First, last, sign and step of an item; a single number is a range to itself."""
    match = ITEM.fullmatch(item)
    if not match or (match[3] or "") not in signs:
        raise _refusal(text, f'expected ranges such as {example}, found "{item}"')
    first = int(match[1])
    last = first if match[2] is None else int(match[2])
    if abs(last - first) > MOST_FRAMES:
        raise _refusal(text, "more than a million frames; check the range")
    return first, last, match[3] or "", 1 if match[4] is None else int(match[4])


def _counted(first: int, last: int, step: int) -> range:
    """Both ends included; `step` is positive, counting down where the range does."""
    return range(first, last + 1, step) if first <= last else range(first, last - 1, -step)


def _of_openjd(text: str, item: str) -> Sequence[int]:
    first, last, _, step = _parts(text, item, ":", "1-24, 1-24:2 or 1,3,5-7 (OpenJD)")
    if step == 0 or (last - first) * step < 0:
        raise _refusal(text, f'the step in "{item}" must lead from {first} to {last}')
    return _counted(first, last, abs(step))


def _of_fileseq(text: str, item: str) -> Sequence[int]:
    first, last, sign, step = _parts(text, item, "xy:", "1-24, 1-24x2, 1-24y2 or 1-24:3 (fileseq)")
    if step < 1:
        raise _refusal(text, f'the step in "{item}" must be 1 or more')
    if sign == ":":
        return [frame for stagger in range(step, 0, -1) for frame in _counted(first, last, stagger)]
    return _stepped(first, last, sign, step)


def _of_oiio(text: str, item: str) -> Sequence[int]:
    first, last, sign, step = _parts(text, item, "xy", "1-24, 1-24x2 or 1-24y2 (OpenImageIO)")
    if step < 0 and first < last:
        first, last = last, first
    return _stepped(first, last, sign, abs(step) or 1)


def _stepped(first: int, last: int, sign: str, step: int) -> Sequence[int]:
    """Every `step`-th frame, or with y all others."""
    chosen = _counted(first, last, step)
    return [frame for frame in _counted(first, last, 1) if frame not in chosen] if sign == "y" else chosen


EXPANDERS = {"openjd": _of_openjd, "fileseq": _of_fileseq, "oiio": _of_oiio}
