"""Operations, against SymPy's count."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.operations import count_operations

a, b, x = sp.symbols("a b x", positive=True)
F = sp.Function("F")


@pytest.mark.parametrize(
    "expression",
    [
        *(x, sp.S.Zero, sp.S.One, sp.Rational(-3, 2), sp.pi, sp.E, -x, 2 * x, -x / 2, x**2, 1 / x, -1 / x, sp.sqrt(x)),
        *(a + b, a - b, -a - b, b - a, -a - b - x, 2 * (a + b), -(a + b), sp.Mul(-1, a + b, evaluate=False)),
        sp.Mul(2, a + b, evaluate=False) / x,
        sp.Mul(-3, a + b, evaluate=False) / (2 * x * (a - b)),
        *(a * b / x, a / (b * x), (a + b) / (a - b), 3 / (2 * sp.sqrt(x)), -sp.sqrt(6) * x / 4, (a + b) ** -2),
        *(sp.exp(-x), x * sp.exp(-a * x), a**x / b, a ** (-x) * b, sp.E * x, 1.5 * x, x ** sp.Rational(-3, 2)),
        *(sp.sin(x) ** 2 * sp.cos(a - b), F(x, a) + F(x, a).diff(x), sp.Abs(x - a) / a, sp.atan2(x, -a)),
        *(sp.oo, sp.nan, sp.I * x, sp.Symbol("m", commutative=False) * x),
    ],
    ids=str,
)
def test_as_many_as_sympy_counts(expression: sp.Expr) -> None:
    assert count_operations(expression) == expression.count_ops()
