# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of a shader: known ones are floats or RGB tuples, others expressions of nodes that an AOV shows pixel by pixel.

Arithmetic on known numbers is done at once; on others it makes an `Expression`, which `node_of` builds as Math nodes.
Expressions are values: two that compute the same are equal, so that lobes can share an AOV.
"""

from __future__ import annotations

import dataclasses
import math


@dataclasses.dataclass(frozen=True)
class Expression:
    """What `operation` makes of its arguments: numbers and other expressions; "SOCKET": of a node's name and output."""

    operation: str
    arguments: tuple
    is_colour: bool
    typical: float | tuple  # stands for it where no AOV can show it


_FOLDED = {
    "ADD": lambda a, b: a + b,
    "SUBTRACT": lambda a, b: a - b,
    "MULTIPLY": lambda a, b: a * b,
    "MAXIMUM": max,
    "SQRT": lambda a: math.sqrt(max(a, 0.0)),
}


def from_socket(socket, typical):
    """What an output socket gives."""
    index = next(i for i, output in enumerate(socket.node.outputs) if output == socket)
    return Expression("SOCKET", (socket.node.name, index), socket.type in ("RGBA", "VECTOR"), typical)


def is_known(value):
    return not isinstance(value, Expression)


def is_colour(value):
    return isinstance(value, tuple) if is_known(value) else value.is_colour


def typical(value):
    return value if is_known(value) else value.typical


def channels(value):
    """Red, green and blue of a known value."""
    return value if isinstance(value, tuple) else (value, value, value)


def apply(operation, *values):
    """One of ADD, SUBTRACT, MULTIPLY, MAXIMUM of two values, SQRT of one; a number goes with all channels of a colour."""
    known = _fold(operation, [typical(value) for value in values])
    if all(is_known(value) for value in values):
        return known
    return Expression(operation, values, any(is_colour(value) for value in values), known)


def _fold(operation, values):
    function = _FOLDED[operation]
    if any(isinstance(value, tuple) for value in values):
        return tuple(function(*parts) for parts in zip(*(channels(value) for value in values)))
    return float(function(*values))


def multiply(a, b):
    for one, other in ((a, b), (b, a)):
        if is_known(one) and (one == 1 or channels(one) == (1, 1, 1)) and (is_colour(other) or not is_colour(one)):
            return other
        if is_known(one) and set(channels(one)) == {0}:
            return 0.0
    if is_known(b) and not is_known(a):
        a, b = b, a
    if is_known(a) and not is_known(b):
        known, rest = factors(b)
        return apply("MULTIPLY", apply("MULTIPLY", a, known), rest)
    return apply("MULTIPLY", a, b)


def factors(value):
    """(known, rest) whose product a value is; rest 1 where it is known."""
    if is_known(value):
        return value, 1.0
    if value.operation == "MULTIPLY" and is_known(value.arguments[0]):
        return value.arguments
    return 1.0, value


def add(a, b):
    for one, other in ((a, b), (b, a)):
        if is_known(one) and set(channels(one)) == {0}:
            return other
    return apply("ADD", a, b)


def complement(a):
    """1 - a."""
    return apply("SUBTRACT", 1.0, a)


def mix(a, b, factor):
    """a where factor is 0, b where it is 1."""
    return add(multiply(a, complement(factor)), multiply(b, factor))


def mean(value):
    """One number of a colour: the mean of its channels."""
    if not is_colour(value):
        return value
    if is_known(value):
        return sum(value) / 3
    return Expression("MEAN", (value,), False, sum(channels(value.typical)) / 3)


def fresnel(ior, normal=None):
    """Reflectance of a dielectric at the surface's normal, as Cycles' Fresnel node has it; `normal`: expression of another one."""
    eta = max(typical(ior), 1e-5)
    return Expression("FRESNEL", (ior, normal), False, ((eta - 1) / (eta + 1)) ** 2)


def node_of(tree, value, made):
    """The output socket that gives `value` in a node tree; nodes it takes are added to `tree` and appended to `made`."""
    if not is_known(value) and value.operation == "SOCKET":
        name, index = value.arguments
        return tree.nodes[name].outputs[index]
    if not is_known(value) and value.operation == "FRESNEL":
        return _fresnel_node(tree, *value.arguments, made)
    arguments = ("", value) if is_known(value) else (value.operation, *value.arguments)
    return _operator_node(tree, is_colour(value), *arguments, made=made)


def _operator_node(tree, colour, operation, *arguments, made):
    """A Math node, of colours a Vector Math node; without an operation it holds its one argument."""
    if operation == "MEAN":
        node, operation, arguments = tree.nodes.new("ShaderNodeVectorMath"), "DOT_PRODUCT", (*arguments, (1 / 3, 1 / 3, 1 / 3))
        colour = True
    else:
        node = tree.nodes.new("ShaderNodeVectorMath" if colour else "ShaderNodeMath")
    made.append(node)
    node.operation = operation or "ADD"
    for index, argument in enumerate(arguments if operation else (*arguments, 0.0)):
        _feed(tree, node.inputs[index], channels(argument) if colour and is_known(argument) else argument, made)
    return node.outputs["Value" if node.operation == "DOT_PRODUCT" or not colour else "Vector"]


def _fresnel_node(tree, ior, normal, made):
    node = tree.nodes.new("ShaderNodeFresnel")
    made.append(node)
    _feed(tree, node.inputs["IOR"], ior, made)
    if normal:
        _feed(tree, node.inputs["Normal"], normal, made)
    return node.outputs[0]


def _feed(tree, socket, value, made):
    if is_known(value):
        socket.default_value = value
    else:
        tree.links.new(node_of(tree, value, made), socket)
