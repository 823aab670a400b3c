"""Output files: written beside their place and renamed when all went well."""

from __future__ import annotations

import contextlib
import os

from ..errors import WriteFailed


def check_folder(folder):
    """Refuse before measuring what could not be written after it."""
    nearest = next(path for path in (folder.absolute(), *folder.absolute().parents) if path.exists())
    if not nearest.is_dir():
        raise WriteFailed(f"{nearest} is a file, expected a folder; choose another with -o")
    if not os.access(nearest, os.W_OK):
        raise WriteFailed(f"{nearest} is not writable; choose another folder with -o")


@contextlib.contextmanager
def both_or_none(folder, *names):
    """Files to write in the folder: renamed to their names when all went well, removed when not."""
    paths = [folder / name for name in names]
    temporary = [path.with_name(f".{path.name}.{os.getpid()}") for path in paths]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        yield temporary
        for file, path in zip(temporary, paths):
            os.replace(file, path)
    except OSError as error:
        raise WriteFailed(f"{folder}: {error.strerror or error}; choose another folder with -o") from error
    finally:
        for file in temporary:
            file.unlink(missing_ok=True)
