"""Equations that are put aside at random values, and forces that are right where they are positive.

Values of expressions in floating point.
"""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.limits import BESIDE_LIMIT
from lagrange.answers.models.mechanics import Variation
from lagrange.answers.results.at_random import AtRandom, approximate, beside_limit
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


# Approximate


def test_values_in_floating_point() -> None:
    x = sp.Symbol("x")
    assert approximate(sp.sqrt(x) * sp.tan(x) / 2 + 1, {x: 1.0}) == pytest.approx(1.7787038623)
    assert str(approximate(sp.Function("f")(x), {x: 1.0})) == str(approximate(sp.sqrt(x), {x: -1.0})) == "nan"


def test_the_two_sides_of_a_limit() -> None:
    x, y, z = sp.symbols("x y z", positive=True)
    state = {x: sp.Float(3), y: sp.Float(2), z: sp.Float(5)}
    moved = [*beside_limit(2 * x * y - z, state, {z})]
    limits = [(x, 1.25), (x, 1.25), (y, 5 / 6), (y, 5 / 6)]
    assert [float(m[s]) for m, (s, _) in zip(moved, limits, strict=True)] == pytest.approx(
        [limit * (1 + side * BESIDE_LIMIT) for (_, limit), side in zip(limits, (1, -1, 1, -1), strict=True)]
    )
    assert all(m[z] is state[z] for m in moved)
    [above, below] = beside_limit(x - sp.Rational(31, 10), {x: sp.Float(1)})  # 3.1: it may be rounded
    assert (above[x] > 3.2, below[x] < 3) == (True, True)
    assert [*beside_limit(x + y, state)] == []
