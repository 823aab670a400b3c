"""Files that are there whole or not at all: written beside their target under a hidden name, then renamed, as the core does."""

from __future__ import annotations

import contextlib
import os
import pathlib
import secrets
from typing import TYPE_CHECKING

from .errors import WriteFailed

if TYPE_CHECKING:
    from collections.abc import Iterator


@contextlib.contextmanager
def replaced(target: str | os.PathLike[str]) -> Iterator[pathlib.Path]:
    """Give the name of a file to write; it takes the target's place at the end, unless something was raised."""
    path = pathlib.Path(target)
    hidden = path.with_name(f".{path.stem}.{secrets.token_hex(8)}{path.suffix}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        yield hidden
        hidden.replace(path)
    except OSError as error:
        raise WriteFailed(f"{target}: cannot be written: {error.strerror or error}") from error
    finally:
        with contextlib.suppress(OSError):
            hidden.unlink()


def write_text(target: str | os.PathLike[str], text: str) -> None:
    """Write a text file."""
    with replaced(target) as hidden:
        hidden.write_text(text, encoding="utf-8")
