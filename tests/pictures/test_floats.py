"""Numbers of pictures: values, vectors, linear equations, and points of relations."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from lagrange.pictures.floats import NoValueError, inner, minus, outer, plus, projected, solved, unit, value

x, y = sp.symbols("x y", real=True)


@pytest.mark.parametrize(
    "e", [x + y, x * y - 2, x**y, sp.sin(x) * sp.cos(y), sp.sqrt(x), x / y, sp.pi * x, sp.Abs(-x), sp.atan2(y, x)]
)
def test_the_value_is_sympys(e: sp.Expr) -> None:
    assert value(e, {x: 1.25, y: 2.5}) == pytest.approx(float(e.evalf(subs={x: 1.25, y: 2.5})))


@pytest.mark.parametrize("e", [x + y, sp.sqrt(-1 - x**2), 1 / (x - 1), sp.log(-x)])
def test_what_has_no_value_is_refused(e: sp.Expr) -> None:
    with pytest.raises(NoValueError):
        value(e, {x: 1.0})


def test_vectors() -> None:
    a, b = (1.0, 2.0, 3.0), (-2.0, 0.5, 4.0)
    assert inner(outer(a, b), a) == pytest.approx(0)
    assert inner(outer(a, b), outer(a, b)) == pytest.approx(inner(a, a) * inner(b, b) - inner(a, b) ** 2)
    assert outer((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)) == (0.0, 0.0, 1.0)
    assert plus(a, minus(b, a)) == pytest.approx(b)
    assert math.hypot(*unit(b)) == pytest.approx(1)
    with pytest.raises(NoValueError):
        unit((0.0, 0.0, 0.0))


def test_linear_equations_need_pivots() -> None:
    matrix, wanted = [[0.0, 2.0, 1.0], [1.0, 1.0, 1.0], [3.0, -1.0, 0.0]], [1.5, -2.0, 4.0]
    right = [inner(row, wanted) for row in matrix]
    assert solved(matrix, right) == pytest.approx(wanted)
    with pytest.raises(NoValueError):
        solved([[1.0, 2.0], [2.0, 4.0]], [1.0, 1.0])


def test_the_nearest_point_of_a_circle() -> None:
    relation = x**2 + y**2 - 4
    found = projected([relation], [[2 * x, 2 * y]], [x, y], {x: 3.0, y: 4.0})
    assert (found[x], found[y]) == pytest.approx((1.2, 1.6))
    with pytest.raises(NoValueError):
        projected([x**2 + 1], [[2 * x]], [x], {x: 1.0})
