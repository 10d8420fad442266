"""Functions in floating point, where they have a value."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.core.floats import FUNCTIONS

x = sp.Symbol("x", real=True)


@pytest.mark.parametrize("function", [f for f in FUNCTIONS if f not in (sp.Abs, sp.sign, sp.atan2, sp.Pow)])
def test_each_function_is_that_of_sympy(function: type[sp.Basic]) -> None:
    at = 0.37
    assert FUNCTIONS[function](at) == pytest.approx(float(function(x).subs(x, at)), rel=1e-12)  # type: ignore[call-arg]


def test_a_cotangent() -> None:
    assert FUNCTIONS[sp.cot](math.pi / 4) == pytest.approx(1)
