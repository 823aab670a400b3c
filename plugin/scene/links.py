# SPDX-License-Identifier: GPL-3.0-or-later
"""What feeds a socket: past reroutes, muted nodes and groups, down to a node that computes something or a plain number.

A `Place` is a socket and the groups it lies in, outermost first: an input of a group's tree goes on at the group node.
"""

from __future__ import annotations

import dataclasses

from . import values


CAMERA = ("Is Camera Ray",)  # what Light Path nodes say yes to
REFLECTED = ("Is Glossy Ray", "Is Reflection Ray")


@dataclasses.dataclass(frozen=True)
class Place:
    socket: object
    groups: tuple = ()

    @property
    def node(self):
        return self.socket.node

    def input(self, *names):
        """The first enabled input of this name on the same node: names of older and newer Blenders; None: there is none."""
        for name in names:
            for socket in self.node.inputs:
                if name in (socket.name, socket.identifier) and socket.enabled:
                    return Place(socket, self.groups)
        return None


def source(place):
    """The output that feeds an input, as a Place; None where a number stands."""
    while place.socket.is_linked:
        link = next((link for link in place.socket.links if link.is_valid), None)
        if link is None:
            return None
        found = _behind(Place(link.from_socket, place.groups))
        if found is None or found.socket.is_output:
            return found
        place = found
    return None


def end(place):
    """The input whose number counts, where nothing feeds it: the outermost of a chain of reroutes and groups."""
    while place is not None and place.socket.is_linked:
        place = _behind(Place(place.socket.links[0].from_socket, place.groups))
        if place is None or place.socket.is_output:
            return None
    return place


def _behind(place):
    """Where an output's value comes from: itself, or an input of a reroute, muted node or group; None: from nowhere."""
    node = place.node
    if node.mute:
        inside = next((link for link in node.internal_links if link.to_socket == place.socket), None)
        return Place(inside.from_socket, place.groups) if inside else None
    if node.type == "REROUTE":
        return Place(node.inputs[0], place.groups)
    if node.type == "GROUP" and node.node_tree:
        inner = next((n for n in node.node_tree.nodes if n.type == "GROUP_OUTPUT" and n.is_active_output), None)
        return inner and Place(_same(inner.inputs, place.socket), (*place.groups, node))
    if node.type == "GROUP_INPUT" and place.groups:
        *outer, group = place.groups
        return Place(_same(group.inputs, place.socket), tuple(outer))
    return place


def _same(sockets, wanted):
    return next(socket for socket in sockets if socket.identifier == wanted.identifier)


def value(place, rays=CAMERA):
    """The number or colour an input holds for such rays, or the Expression that gives it; one inside a group is None."""
    found = source(place)
    if found is None:
        last = end(place)
        return _plain((last or place).socket)
    known = _known_output(found, rays)
    if known is not None:
        return known
    return None if found.groups else values.from_socket(found.socket, _plain(place.socket))


def plain(place):
    """The number that stands in a socket, linked or not."""
    return _plain(place.socket)


def _plain(socket):
    """A socket's own number, colour as RGB."""
    if not hasattr(socket, "default_value"):
        return 0.0
    number = socket.default_value
    return float(number) if isinstance(number, (int, float)) else tuple(float(part) for part in number)[:3]


def _known_output(place, rays):
    """What nodes give that are the same for every such ray; None: not one of them."""
    node = place.node
    if node.type in ("VALUE", "RGB"):
        return _plain(place.socket)
    if node.type == "LIGHT_PATH" and place.socket.name != "Ray Length":
        return 1.0 if place.socket.name in rays else 0.0
    return None
