"""tan θ = ρ θ beside θ = 0: where it has roots, and the sign of the slope there, against numbers."""

from __future__ import annotations

import itertools
import math

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.tangent_equation import beside_zero, slope, tangent_coefficients

q = sp.Symbol("theta", real=True)
R, h = sp.symbols("R h", positive=True)


def branch(e: sp.Expr) -> Branch:
    return Branch((), (SignCondition(q, "≠", sp.S.Zero),), left=(e,))


def test_roots_exist_under_a_condition() -> None:
    found = beside_zero(branch(h * sp.sin(q) - R * q * sp.cos(q)), q)
    assert found is not None
    assert found.occupied
    assert found.conditions == (SignCondition(R, ">", h), SignCondition(q, "≠", sp.S.Zero))


@pytest.mark.parametrize("ratio", [sp.Rational(1, 2), sp.S.One, sp.Rational(11, 10), sp.Integer(4), -sp.S.One])
@pytest.mark.parametrize("a", [2, -3])
def test_numbers(ratio: sp.Rational, a: int) -> None:
    e = a * (sp.sin(q) - ratio * q * sp.cos(q))
    value = sp.lambdify(q, e, "math")
    grid = [0.001 * n for n in range(1, 1571)]
    changes = [x for x, y in itertools.pairwise(grid) if value(x) * value(y) < 0]
    found = beside_zero(branch(e), q)
    assert (found is not None) == bool(changes)
    for x in changes:
        rise, sign = slope(e, q) or (sp.S.Zero, 0)
        assert math.copysign(1, value(x + 0.01) - value(x - 0.01)) == sign
        assert float(rise.subs(q, x)) == pytest.approx((value(x + 1e-4) - value(x - 1e-4)) / 2e-4, rel=0.05)


@pytest.mark.parametrize("e", [sp.sin(q) - q, h * sp.sin(2 * q) - R * q * sp.cos(q), sp.sin(q) - q**2 * sp.cos(q)])
def test_other_equations_are_left_as_they_are(e: sp.Expr) -> None:
    assert tangent_coefficients(e, q) is None
    assert beside_zero(branch(e), q) == branch(e)
