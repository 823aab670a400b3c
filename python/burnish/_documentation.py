"""The settings table as a section of docstrings."""

import textwrap

from . import _core


def _entry(setting):
    kind = " | ".join(map(str, setting["choices"])) or setting["unit"]
    head = f"{setting['name']} : {kind}" if kind else setting["name"]
    return f"{head}\n{textwrap.fill(setting['help'], 100, initial_indent='    ', subsequent_indent='    ')} [{setting['default']!r}]"


def add_settings(*functions):
    """Append the list of settings to each function's docstring."""
    section = "Settings\n--------\n" + "\n".join(_entry(setting) for setting in _core.settings())
    for function in functions:
        text = textwrap.dedent(function.__doc__.split("\n", 1)[1])
        function.__doc__ = f"{function.__doc__.splitlines()[0]}\n{text.rstrip()}\n\n{section}\n"
