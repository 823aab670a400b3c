"""An EXR with flags as settings by name: the flags are those of `burnish composite`."""

from __future__ import annotations

import difflib
import json

from .. import BadArgument, settings

ALIASES = {"light": "lights"}


def settings_of(words, command="chart"):
    """Settings from words such as --env sky.exr --material gold --up z; repeatable ones add up. `command`: whose help tells more."""
    table = {setting["name"]: setting for setting in settings()}
    found, left = {}, list(words)
    while left:
        word = left.pop(0)
        flag, _, text = word.partition("=") if word.startswith("--") else ("", "", "")
        name = ALIASES.get(flag[2:], flag[2:].replace("-", "_"))
        if name not in table:
            near = difflib.get_close_matches(name, table, 1)
            hint = f", did you mean --{near[0].replace('_', '-')}?" if near else f"; see burnish {command} --help"
            raise BadArgument(f"{word}: no such option{hint}")
        if "=" not in word:
            if not left:
                raise BadArgument(f"{flag}: expected a value after it")
            text = left.pop(0)
        add(found, name, table[name]["default"], text)
    return found


def add(found, name, default, text):
    """Set a value in the form of the setting's default."""
    if isinstance(default, dict):
        key, _, value = text.partition("=")
        found.setdefault(name, {})[key] = value
    elif isinstance(default, list) and name == "assign":
        found.setdefault(name, []).append(text)
    elif isinstance(default, list):
        found[name] = [value_of(part) for part in text.split(",")]
    elif isinstance(default, str):
        found[name] = text
    else:
        found[name] = value_of(text)


def value_of(text):
    """A number or truth value as JSON has it, or the text itself."""
    try:
        return json.loads(text)
    except json.JSONDecodeError:
        return text
