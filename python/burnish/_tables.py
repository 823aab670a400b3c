"""What burnish knows by name: settings, roles, models, materials, and the schema of the shot file."""

from __future__ import annotations

from typing import Any

from . import _core


def settings() -> list[dict[str, Any]]:
    """The table of settings that the command line, the shot file and Python share.

    Returns
    -------
    list of dict
        In the order they are shown: name, section and key in the shot file, unit, help, min, max, choices, default.

    Raises
    ------
    MemoryError
        Only when there is no memory for the answer.
    """
    return _core.settings()


def roles() -> dict[str, Any]:
    """The roles that layers of a frame can play.

    Returns
    -------
    dict
        Role name -> {"channels": int, "help": str}.

    Raises
    ------
    MemoryError
        Only when there is no memory for the answer.
    """
    return _core.roles()


def models() -> dict[str, Any]:
    """The reflectance models.

    Returns
    -------
    dict
        Model name -> {"summary", "source", "reciprocal", "anisotropic", "own_width", "parameters": name -> {"default", "min", "max",
        "per_channel", "help"}}. own_width: its width follows from its parameters, and mx, my stretch it.

    Raises
    ------
    MemoryError
        Only when there is no memory for the answer.
    """
    return _core.models()


def presets() -> dict[str, Any]:
    """The built-in materials.

    Returns
    -------
    dict
        Name -> material, as the shot file spells it.

    Raises
    ------
    MemoryError
        Only when there is no memory for the answer.
    """
    return _core.presets()


def library() -> dict[str, Any]:
    """The published fits of measured materials, each usable by its name wherever a material is.

    Returns
    -------
    dict
        Name, such as "merl:brass" -> material, as the shot file spells it.

    Raises
    ------
    MemoryError
        Only when there is no memory for the answer.
    """
    return _core.library()


def shot_schema() -> dict[str, Any]:
    """The JSON schema of the shot file.

    Returns
    -------
    dict
        JSON Schema, draft 2020-12.

    Raises
    ------
    MemoryError
        Only when there is no memory for the answer.
    """
    return _core.shot_schema()
