"""Shot documents and settings by name: the same values in two shapes, and those of one frame."""

from __future__ import annotations

import os
from typing import Any

from . import _core
from ._compositing import one_material, placed_camera
from .errors import BadArgument

FILE_VIEWS = ("left", "right")  # of frames whose names hold %V, or %v for l and r


def spelled_out(settings: dict[str, Any], is_new: bool) -> dict[str, Any]:
    """Settings with the short forms of `materials` and `camera` as the core takes them."""
    if "materials" in settings:
        materials = settings.pop("materials")
        is_worn = is_new and not settings.get("assign") and "material" not in settings
        settings = {**settings, **one_material(materials, is_worn)}
    if "camera" in settings:
        settings["camera"] = placed_camera(settings["camera"])
    return settings


def _environment(document: dict[str, Any]) -> dict[str, Any]:
    """The light whose fields are settings of their own."""
    return next((light for light in document.get("lights", {}).values() if "type" not in light), {})


def by_name(document: dict[str, Any]) -> dict[str, Any]:
    """The document's values by the names of the settings."""
    near = {name: light for name, light in document.get("lights", {}).items() if "type" in light}
    sections = {**document, "": {**document, "lights": near}, "lights": _environment(document)}
    values = {}
    for setting in _core.settings():
        value = sections.get(setting["section"], {}).get(setting["key"])
        if value is not None and value != setting["default"]:
            values[setting["name"]] = value
    return values


def settings_of_frame(document: dict[str, Any], frame: int | None) -> dict[str, Any]:
    """Settings for one frame in memory: lights keep their names, and files are those of the frame."""
    values = by_name(document)
    lights = {name: {"type": "environment", **light} for name, light in document.get("lights", {}).items()}
    far = {setting["name"] for setting in _core.settings() if setting["section"] == "lights"}
    settings = {name: value for name, value in values.items() if name not in far} | ({"lights": lights} if lights else {})
    for name in {"aovs", "fine_aovs", "camera"} & settings.keys():
        if isinstance(settings[name], str):
            settings[name] = file_of_view(settings[name], settings.get("view", ""))
    pattern = settings.get("aovs", "")
    if frame is None and _core.has_frame_token(pattern):
        raise BadArgument(f"frame: '{pattern}' names many frames; say which number")
    if frame is not None and not _core.has_frame_token(pattern):
        raise BadArgument(f"frame: '{pattern}' names one file; leave the number out")
    if frame is None:
        return settings
    return {name: _of_frame(value, frame) if name in ("aovs", "fine_aovs", "camera", "lights") else value
            for name, value in settings.items()}


def file_of_view(pattern: str, view: str) -> str:
    """The pattern with its view's name, where it has a place for one; of all views the first that files are named for."""
    name = view if view not in ("", "all") else FILE_VIEWS[0]
    return pattern.replace("%V", name).replace("%v", name[0])


def _of_frame(value: Any, frame: int) -> Any:
    """The value with every pattern in it as the frame's file."""
    if isinstance(value, dict):
        return {key: _of_frame(field, frame) for key, field in value.items()}
    if isinstance(value, list):
        return [_of_frame(field, frame) for field in value]
    is_pattern = isinstance(value, str) and _core.has_frame_token(value)
    return _core.frame_file(value, frame) if is_pattern else value


def with_absolute_materials(document: dict[str, Any], folder: str) -> dict[str, Any]:
    """The document with materials that are files named so that every process finds them."""
    own = document.get("materials", {})

    def absolute(name: str) -> str:
        path = os.path.join(folder, name)
        return path if name not in own and os.path.isfile(path) else name

    if "material" in document:
        document["material"] = absolute(document["material"])
    for rule in document.get("assign", []):
        rule["material"] = absolute(rule["material"])
    for new, old in document.get("old_materials", {}).items():
        document["old_materials"][new] = absolute(old)
    return document
