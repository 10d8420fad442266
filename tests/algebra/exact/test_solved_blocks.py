"""Constraints solved block by block, and Newton's iteration where nothing can be solved."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Surface

sin, cos, tan, sqrt, pi = sp.sin, sp.cos, sp.tan, sp.sqrt, sp.pi
x, y, z, theta, phi, psi, alpha, u = sp.symbols("x y z theta phi psi alpha u", real=True)
l, r, R, h, c, d, l1, l2, l3, m, M = sp.symbols("l r R h c d l1 l2 l3 m M", positive=True)


def test_solved_parameters_keep_their_sign() -> None:
    surface = Surface([sqrt(x**2 + y**2) + x - l - R], [])
    for n in range(5):
        surface.point(n).require_positive(surface.point(n).value(l))
        surface.point(n).require_positive(surface.point(n).value(R))


NOT_EXACT = {
    "transcendental": [x + sin(x) - y - cos(y)],
    "exponential": [x * sp.exp(x) + y * sp.exp(y) - 5],
    "cubic": [x**3 + y**3 + x * y - 1],
}


@pytest.mark.parametrize("name", NOT_EXACT)
def test_newtons_iteration_where_nothing_can_be_solved(name: str) -> None:
    surface = Surface(NOT_EXACT[name], [x, y])
    assert not surface.exact
    point = surface.point()
    assert not point.exact
    assert point.is_zero(NOT_EXACT[name][0])
    assert surface.is_zero(NOT_EXACT[name][0] * (x + y)) is True
    assert surface.is_zero(x - y) is False
    assert surface.rank([[e.diff(q) for q in (x, y)] for e in NOT_EXACT[name]]) == 1
