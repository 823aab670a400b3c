"""`burnish chart --stability`: every case of the stability suite, run again, as a page and as JSON."""

from __future__ import annotations

import json

from .. import __version__
from .files import both_or_none
from .page import Page


def run(folder, cases, announced):
    """Measure the cases, write the page and the JSON; returns the names of those that do not hold. `announced`: iterates with progress."""
    outcomes = {case.name: case.measure() for case in announced(list(cases.values()))}
    page = page_of(cases, outcomes)
    with both_or_none(folder, "stability.html", "stability.json") as (html, data):
        html.write_text(page.text_of(), encoding="utf-8")
        data.write_text(json.dumps({"burnish": __version__, "cases": [entry(cases[name], outcome) for name, outcome in outcomes.items()]},
                                   indent=1) + "\n", encoding="utf-8")
    return [name for name, outcome in outcomes.items() if not cases[name].holds(outcome.figure)]


def entry(case, outcome):
    """A case as JSON."""
    return {"case": case.name, "figure": float(outcome.figure), "threshold": case.threshold, "is_least": case.is_least, "unit": case.unit,
            "holds": bool(case.holds(outcome.figure)), "details": [[str(text), value_of(number)] for text, number in outcome.details]}


def value_of(number):
    """Numbers of numpy as Python's own, anything else as text."""
    return number.item() if hasattr(number, "item") else number if isinstance(number, (int, float)) else str(number)


def bound(case):
    """The threshold in words."""
    return f"{'at least' if case.is_least else 'at most'} {case.threshold:.4g}"


def page_of(cases, outcomes):
    """The Page: all figures in a table, then case by case."""
    page = Page("burnish: where methods fail")
    held = {name: cases[name].holds(outcome.figure) for name, outcome in outcomes.items()}
    page.text(f"{sum(held.values())} of {len(held)} cases hold. burnish {__version__}.")
    page.table(["case", "figure", "threshold", "unit", "holds"],
               [[name, float(outcome.figure), bound(cases[name]), cases[name].unit, "yes" if held[name] else "no"]
                for name, outcome in outcomes.items()], [index for index, name in enumerate(outcomes) if not held[name]])
    for name, outcome in outcomes.items():
        case = cases[name]
        page.heading(name)
        page.text(case.asks)
        page.text(f"{outcome.figure:.4g} {case.unit}, {bound(case)}: {case.why}")
        page.picture(outcome.picture, outcome.caption)
        if outcome.details:
            page.table(["taken from", ""], [[text, value_of(number)] for text, number in outcome.details])
    return page
