"""Points: values, changes of values, affine rows and linear algebra, in residues and in reals."""

from __future__ import annotations

import pytest
import sympy as sp

from lagrange.algebra.exact.zero_test import Point, UnsupportedError
from lagrange.core.symbols import Unspecified
from tests.support.points import close

x, y, theta, u, v, w = sp.symbols("x y theta u v w", real=True)
m, l, R = sp.symbols("m l R", positive=True)


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


def test_equal_arguments_have_equal_functions(point: Point) -> None:
    f, same = (Unspecified.of("f", "XY", a, y) for a in (x * (x + 1), x**2 + x))
    assert close(point, point.value(f), point.value(same))
    assert not close(point, point.value(f), point.value(f.partial(0)))
    assert not close(point, point.value(f), point.value(Unspecified.of("f", "XY", y, x)))


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


def test_a_row_takes_the_unknowns_that_occur(point: Point, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of the multipliers of hundreds of constraints an equation has a few: nothing is looked up for the others."""
    unknowns = sp.symbols("c1:101", real=True)
    asked: list[sp.Symbol] = []
    real = type(point).input

    def input_of(self: Point, symbol: sp.Symbol) -> object:
        asked.append(symbol)
        return real(self, symbol)

    monkeypatch.setattr(type(point), "input", input_of)
    rows = point.affine([x * c for c in unknowns], unknowns)
    assert rows is not None
    assert all(
        close(point, a, point.value(x) if n == k else point.number(0))
        for n, row in enumerate(rows)
        for k, a in enumerate(row)
    )
    assert len(asked) < 20 * len(unknowns)


@pytest.mark.parametrize("expression", [u**2, u * v, 1 / u, sp.sin(u), sp.Abs(u), sp.sqrt(1 + u**2), u**3 - u])
def test_what_is_not_affine_has_no_row(point: Point, expression: sp.Expr) -> None:
    assert point.affine([u, expression], [u, v]) is None


def test_affine_after_cancelling(point: Point) -> None:
    rows = point.affine([(u**2 + u * v) / (u + v), u**2 / u], [u, v])
    one, zero = point.number(1), point.number(0)
    assert rows is not None
    assert all(close(point, a, b) for row in rows for a, b in zip(row, (one, zero, zero), strict=True))
