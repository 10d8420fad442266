"""Quotients whose denominators may vanish."""

from __future__ import annotations

import sympy as sp

from lagrange.algebra.closed_forms.undefined_points import quotients

x, y = sp.symbols("x y", real=True)
a = sp.Symbol("a", positive=True)


def test_terms_with_an_unknown_in_the_denominator() -> None:
    assert list(quotients(a / x + y / a, (x, y))) == [(a, x)]
    assert list(quotients(x * y, (x, y))) == []
