"""Values of expressions in floating point."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.answers.results.approximate import approximate


def test_values_in_floating_point() -> None:
    x = sp.Symbol("x")
    assert approximate(sp.sqrt(x) * sp.tan(x) / 2 + 1, {x: 1.0}) == pytest.approx(1.7787038623)
    assert str(approximate(sp.Function("f")(x), {x: 1.0})) == str(approximate(sp.sqrt(x), {x: -1.0})) == "nan"
