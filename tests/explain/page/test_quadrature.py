"""Motions by two integrals over time."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.core.symbols import t
from lagrange.explain.page.quasi_velocities import _integral

C, g, w = sp.Symbol("C", real=True), *sp.symbols("g omega", positive=True)


@pytest.mark.parametrize("rate", [g * sp.cos(w * t), g * sp.sin(w * t) * sp.cos(w * t) + 2, sp.cos(w * t) ** 2 * g])
def test_the_integral_has_the_rate_as_its_derivative(rate: sp.Expr) -> None:
    found = _integral(rate, C)
    assert found is not None
    assert sp.simplify(found.diff(t) - rate) == 0
    assert found.coeff(C) == 1


@pytest.mark.parametrize("rate", [sp.exp(t), t * sp.cos(w * t), 1 / (1 + t), g * sp.Symbol("x'", real=True)])
def test_other_rates_are_not_integrated(rate: sp.Expr) -> None:
    assert _integral(rate, C) is None
