"""What a case of the stability suite is: a scene that a method is known to fail in, one figure, and the threshold it must keep."""

from __future__ import annotations

import dataclasses
import importlib
import pkgutil
from collections.abc import Callable

import numpy as np

CASES = {}
"""Name -> Case, filled as the modules of cases are imported; `every_case` imports all of them."""


@dataclasses.dataclass(frozen=True)
class Outcome:
    """What a run of a case found."""

    figure: float
    picture: np.ndarray  # shape (height, width, 3), display-encoded in [0, 1]: what a person should look at
    caption: str = ""  # what the picture's parts are, left to right
    details: tuple = ()  # pairs of text and number that the figure was taken from


@dataclasses.dataclass(frozen=True)
class Case:
    """A weakness, and how far it may go."""

    name: str  # "grazing-horizon"
    asks: str  # what could go wrong, one sentence
    unit: str  # of the figure: "dB", "% of white", "relative RMS"
    threshold: float
    is_least: bool  # the figure must be at least the threshold; else at most
    why: str  # the threshold: where it comes from
    measure: Callable[[], Outcome]

    def holds(self, figure):
        """Whether a figure keeps the threshold; NaN never does."""
        return figure >= self.threshold if self.is_least else figure <= self.threshold


def case(name, asks, unit, why, at_least=None, at_most=None):
    """Make a function that returns an Outcome a case; give one of the thresholds."""
    if (at_least is None) == (at_most is None):
        raise ValueError(f"{name}: give at_least or at_most")

    def register(measure):
        if name in CASES:
            raise ValueError(f"two cases are called {name}")
        threshold = at_least if at_most is None else at_most
        CASES[name] = Case(name, asks, unit, threshold, at_most is None, why, measure)
        return measure

    return register


def every_case():
    """Name -> Case of all modules beside this one, by name."""
    package = importlib.import_module(__package__)
    for module in pkgutil.iter_modules(package.__path__):
        importlib.import_module(f"{__package__}.{module.name}")
    return dict(sorted(CASES.items()))
