"""The stability suite: every case keeps its threshold, has a picture, and could fail."""

import numpy as np
import pytest
from burnish.stability.case import every_case

CASES = every_case().values()


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_a_weakness_is_no_worse_than_it_was(case):
    outcome = case.measure()
    assert case.holds(outcome.figure), f"{case.asks} {outcome.figure:.5g} {case.unit}; {outcome.details}"
    assert outcome.picture.ndim == 3 and outcome.picture.shape[2] == 3 and outcome.picture.size
    assert np.isfinite(outcome.picture).all() and 0 <= outcome.picture.min() and outcome.picture.max() <= 1
    assert len(np.unique(outcome.picture)) > 1, "a picture with nothing in it"


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_a_worse_figure_would_not_hold(case):
    worse = -1 if case.is_least else 1
    assert not case.holds(np.nextafter(case.threshold, worse * np.inf)) and not case.holds(np.nan)
    assert case.why and case.asks and case.unit
