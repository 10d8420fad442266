"""Equations that are put aside at random values, and forces that are right where they are positive."""

from __future__ import annotations

import sympy as sp

from lagrange.answers.models.variation import Variation
from lagrange.answers.results.at_random import AtRandom
from tests.support.shared import solved


def test_what_differs_at_random_values_is_put_aside() -> None:
    solution = solved("three-weights", complete=False)
    equilibrium = solution.own.equilibrium
    assert equilibrium is not None
    letters = {s.name: s for e in equilibrium.expressions for s in e.free_symbols}
    y, b, p, w = (letters[n] for n in ("y", "b", "P", "W"))
    halved = AtRandom([[y - b * w / sp.sqrt(p**2 - w**2)]], equilibrium)
    assert not halved.may_hold(Variation("", ""))
    assert halved.may_hold(Variation("", "", rule={p: 2 * p}))
