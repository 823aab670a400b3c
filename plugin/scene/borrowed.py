# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of shared data changed for the time of a render, and put back whatever happens.

    with Borrowed() as borrowed:
        borrowed.set(thing, "visible_camera", False)
        ...
"""

from __future__ import annotations


class Borrowed:
    def __init__(self):
        self._returns = []

    def __enter__(self):
        return self

    def __exit__(self, *error):
        while self._returns:
            self._returns.pop()()

    def later(self, action):
        """Have `action()` called at the end, before what was asked for earlier."""
        self._returns.append(action)

    def set(self, owner, name, value):
        before = getattr(owner, name)
        if before != value:
            self.later(lambda: setattr(owner, name, before))
            setattr(owner, name, value)

    def plug(self, tree, socket, value):
        """An input holds a number instead of what is linked to it."""
        before = socket.default_value if isinstance(value, (int, float)) else tuple(socket.default_value)
        sources = [link.from_socket for link in socket.links]
        for link in list(socket.links):
            tree.links.remove(link)
        socket.default_value = value

        def put_back():
            socket.default_value = before
            for source in sources:
                tree.links.new(source, socket)

        self.later(put_back)
