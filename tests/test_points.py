"""Points: values, changes of values, affine rows and linear algebra, in residues and in reals."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from lagrange.algebra.exact.exact import (
    FieldPoint,
    Fields,
    InadmissibleError,
    Point,
    Surface,
    UnsupportedError,
    ZeroDivisorError,
)
from lagrange.core.symbols import Sign, Unspecified

x, y, theta, u, v, w = sp.symbols("x y theta u v w", real=True)
m, l, R = sp.symbols("m l R", positive=True)


def field_point() -> Point:
    return Surface(fields=Fields(2)).point()


def real_point() -> Point:
    return Surface(fields=Fields(2)).real_point()


@pytest.fixture(params=[field_point, real_point], ids=["field", "reals"])
def point(request: pytest.FixtureRequest) -> Point:
    return request.param()


def close(point: Point, a: Any, b: Any) -> bool:
    return point.arithmetic.vanishes(point.arithmetic.reduce(a - b))


def test_values_are_consistent(point: Point) -> None:
    a, b = point.value(x), point.value(m)
    assert close(point, point.value(x * m + 3), a * b + 3)
    assert close(point, point.value(x / m) * b, a)
    assert close(point, point.value(sp.sqrt(m)) ** 2, b)
    c, s = point.values([sp.cos(theta / 3), sp.sin(theta / 3)])
    assert close(point, c * c + s * s, point.number(1))
    assert close(point, point.value(sp.cos(theta)), 4 * c**3 - 3 * c)
    assert point.is_zero(sp.cos(2 * theta) - 1 + 2 * sp.sin(theta) ** 2)
    assert not point.is_zero(x)


def test_signs_of_symbols_are_respected(point: Point) -> None:
    negative = sp.Symbol("n", negative=True)
    sigma = Sign("sigma")
    point.require_positive(point.value(m))
    point.require_positive(-point.value(negative))
    assert close(point, point.value(sigma + 1) * point.value(sigma - 1), point.number(0))
    with pytest.raises(InadmissibleError):
        point.require_positive(point.value(-m))


def test_a_real_symbol_may_have_either_sign() -> None:
    surface = Surface()
    signs = {surface.point(n).field.sign(surface.point(n).value(x)) for n in range(30)}  # type: ignore[attr-defined]
    assert signs == {1, -1}
    assert {surface.real_point(n).value(x) > 0 for n in range(30)} == {True, False}


def test_equal_arguments_have_equal_functions(point: Point) -> None:
    f, same = (Unspecified.of("f", "XY", a, y) for a in (x * (x + 1), x**2 + x))
    assert close(point, point.value(f), point.value(same))
    assert not close(point, point.value(f), point.value(f.partial(0)))
    assert not close(point, point.value(f), point.value(Unspecified.of("f", "XY", y, x)))


def test_a_vanishing_denominator_names_its_node(point: Point) -> None:
    with pytest.raises(ZeroDivisorError) as caught:
        point.with_values({x: point.value(y)}).value(1 / (x - y) + 1)
    assert point.graph.expressions[caught.value.node or 0] == 1 / (x - y)


def test_unsupported_expressions_are_refused(point: Point) -> None:
    with pytest.raises(UnsupportedError):
        point.value(sp.Piecewise((x, x > 0), (0, True)))


def test_with_values_changes_nothing_else(point: Point) -> None:
    before = point.values([x * y, sp.cos(theta) * y])
    other = point.with_values({x: point.number(2), theta: point.number(0)})
    assert close(point, other.value(x * y), 2 * other.value(y))
    assert other.value(y) == point.value(y)
    assert close(point, other.value(sp.cos(theta)), point.number(1))
    assert point.values([x * y, sp.cos(theta) * y]) == before


def test_symbols_wanted_later_have_the_same_value_in_all_copies(point: Point) -> None:
    first, second = (point.with_values({x: point.number(n)}) for n in (1, 2))
    assert first.value(m) == second.value(m) == point.value(m)
    assert first.value(sp.cos(theta)) == second.value(sp.cos(theta))


def test_redrawn_symbols_are_new_and_the_others_are_kept(point: Point) -> None:
    point.values([x, y, x * y])
    other = point.redrawn([x])
    assert other.value(y) == point.value(y)
    assert other.value(x) != point.value(x)
    assert close(point, other.value(x * y), other.value(x) * other.value(y))


def test_affine_rows_are_the_derivatives(point: Point) -> None:
    unknowns = (u, v, w)
    e = m * l**2 * u + sp.cos(theta) * (v - 3 * u) / R + x * y - u * sp.sin(theta)
    f = (v + 1) ** 2 - v**2 + 5
    rows = point.affine([e, f], unknowns)
    assert rows is not None
    for row, expression in zip(rows, (e, f), strict=True):
        zero = expression.xreplace(dict.fromkeys(unknowns, sp.S.Zero))
        expected = point.values([*(sp.expand(expression).diff(q) for q in unknowns), zero])
        assert all(close(point, a, b) for a, b in zip(row, expected, strict=True))


@pytest.mark.parametrize("expression", [u**2, u * v, 1 / u, sp.sin(u), sp.Abs(u), sp.sqrt(1 + u**2), u**3 - u])
def test_what_is_not_affine_has_no_row(point: Point, expression: sp.Expr) -> None:
    assert point.affine([u, expression], [u, v]) is None


def test_affine_after_cancelling(point: Point) -> None:
    rows = point.affine([(u**2 + u * v) / (u + v), u**2 / u], [u, v])
    one, zero = point.number(1), point.number(0)
    assert rows is not None
    assert all(close(point, a, b) for row in rows for a, b in zip(row, (one, zero, zero), strict=True))


def test_linear_algebra(point: Point) -> None:
    n = point.number
    rows = [[n(1), n(2), n(3)], [n(2), n(4), n(6)], [n(0), n(1), n(1, 3)]]
    assert point.rank(rows) == 2
    reduced, pivots = point.row_reduced(rows)
    assert pivots == [0, 1]
    assert len(reduced) == 2
    [kernel] = point.nullspace(rows, 3)
    assert all(close(point, sum(a * k for a, k in zip(row, kernel, strict=True)), n(0)) for row in rows)
    found = point.solution(rows, [n(1), n(2), n(5)], [n(7), n(8), n(9)])
    assert found is not None
    assert found[2] == n(9)
    residual = [sum(a * k for a, k in zip(row, found, strict=True)) for row in rows]
    assert all(close(point, r, n(b)) for r, b in zip(residual, (1, 2, 5), strict=True))
    assert point.solution(rows, [n(1), n(3), n(5)]) is None
    assert point.nullspace([], 2) == [[n(1), n(0)], [n(0), n(1)]]


def test_reals_do_not_guess_a_rank() -> None:
    point = real_point()
    nearly = [[point.number(1), point.number(1)], [point.number(1), 1 + point.number(1, 10**50)]]
    with pytest.raises(InadmissibleError):
        point.rank(nearly)
    nearly[1][1] = 1 + point.number(1, 10**30)
    assert point.rank(nearly) == 2
    nearly[1][1] = 1 + point.number(1, 10**70)
    assert point.rank(nearly) == 1


@settings(deadline=None, max_examples=50)
@given(st.lists(st.lists(st.integers(-4, 4), min_size=4, max_size=4), min_size=1, max_size=5))
def test_kernel_and_rank_of_integer_matrices(rows: list[list[int]]) -> None:
    point = field_point()
    values = [[point.number(k) for k in row] for row in rows]
    assert point.rank(values) == sp.Matrix(rows).rank()
    kernel = point.nullspace(values, 4)
    assert len(kernel) == 4 - point.rank(values)
    for vector in kernel:
        assert all(point.arithmetic.reduce(sum(a * k for a, k in zip(r, vector, strict=True))) == 0 for r in values)


def test_reconstruction_of_values() -> None:
    point = field_point()
    assert isinstance(point, FieldPoint)
    assert point.reconstructed(point.value((2 * x + 2 * y) / (-7 * x - 7 * y))) == sp.Rational(-2, 7)
    assert point.reconstructed(point.value(x)) is None
