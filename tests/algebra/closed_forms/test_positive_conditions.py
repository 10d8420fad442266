"""Conditions under which several expressions are positive, against signs at random values of the parameters."""

from __future__ import annotations

from random import Random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.positive_conditions import (
    NeverPositiveError,
    conditions_for,
    positive_part,
    sign_on,
    where_positive,
)

a, b, c = sp.symbols("a b c", positive=True)
x = sp.Symbol("x", real=True)


@pytest.mark.parametrize(
    ("expressions", "number"),
    [
        ((a + b,), 0),
        ((x - 2 * a, x - 4 * a), 1),  # the second implies the first
        ((a - b, (a - b) * c), 1),
        ((a - b, b - c), 2),
    ],
)
def test_the_conditions_are_those_of_the_signs(expressions: tuple[sp.Expr, ...], number: int) -> None:
    found = conditions_for(expressions, ())
    assert found is not None
    assert len(found) == number
    random = Random(1)
    for _ in range(40):
        there = {s: sp.Rational(random.randint(1, 30), random.randint(1, 9)) for s in (a, b, c, x)}
        positive = all(e.xreplace(there) > 0 for e in expressions)
        assert all(positive_part(k).xreplace(there) > 0 for k in found) == positive


@pytest.mark.parametrize("expressions", [(a - b, b - a), (-a,), (a - b, 2 * b - 2 * a)])
def test_what_is_never_positive(expressions: tuple[sp.Expr, ...]) -> None:
    with pytest.raises(NeverPositiveError):
        conditions_for(expressions, ())
    assert where_positive([-a], ()) == ()


def test_alternatives_without_those_that_imply_another() -> None:
    [only] = where_positive([x - 2 * a, x - 4 * a], ())
    assert sp.expand(positive_part(only) - (x - 2 * a)) == 0


def test_the_sign_where_others_are_positive() -> None:
    assert sign_on(c * (a - b), [a - b]) == 1
    assert sign_on(b - a, [a - b]) == -1
    assert sign_on(a - b, []) is None
    assert sign_on(sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1, []) == 0
