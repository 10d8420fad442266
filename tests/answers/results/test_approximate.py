"""Values of expressions in floating point."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.limits import BESIDE_LIMIT
from lagrange.answers.results.approximate import approximate, beside_limit


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
