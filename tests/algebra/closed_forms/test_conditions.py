"""Conditions in their shortest form: each must say the same as those given, at random parameters."""

from __future__ import annotations

import random
from collections.abc import Sequence
from random import Random

import pytest
import sympy as sp

from lagrange.algebra.closed_forms.conditions import (
    NeverPositiveError,
    conditions_for,
    further_conditions,
    only_excludes_equality,
    positive_part,
    where_positive,
)
from lagrange.algebra.closed_forms.signs import SignCondition, sign_on

m, g, k, R, l, P, H, c = sp.symbols("m g k R l P H c", positive=True)
OPERATORS = {"≥": "__ge__", ">": "__gt__", "≤": "__le__", "<": "__lt__"}


def condition(lhs: sp.Expr, relation: str, rhs: sp.Expr) -> SignCondition:
    return SignCondition(sp.sympify(lhs), relation, sp.sympify(rhs))


def holds(conditions: Sequence[SignCondition], at: dict[sp.Symbol, sp.Rational]) -> bool:
    for x in conditions:
        a, b = x.lhs.xreplace(at), x.rhs.xreplace(at)
        if not (a != b if x.relation == "≠" else bool(getattr(a, OPERATORS[x.relation])(b))):
            return False
    return True


ring = condition(4 * m**2 * g**2 + 3 * k**2 * R**2, "≥", 8 * m * g * k * R)
ring_with_length = condition(4 * m**2 * g**2 + 4 * k**2 * R**2, "≥", 8 * m * g * k * R + k**2 * l**2)
pulls = condition(k * R, "≥", m * g)
length = (H**2 + 1 - 25 * H**2 / (5 * H - g) ** 2) / (2 * H)

CASES = [
    ([ring, pulls], [condition(k * R, "≥", 2 * m * g)]),
    ([ring_with_length, pulls], [condition(2 * k * R, "≥", 2 * m * g + k * l)]),
    ([condition(k * l, ">", 2 * P), condition(k**2 * l**2 + 3 * P**2, ">", 4 * k * l * P)], [condition(k * l, ">", 3 * P)]),
    ([condition(sp.Abs(m * g / (k * R)), "≤", 1)], [condition(k * R, "≥", m * g)]),
    ([condition(k * R * m, "≥", k * l * m + m**2 * g), condition(R, "≥", l)], [condition(k * R, "≥", g * m + k * l)]),
    ([condition(k * R, "≥", m * g), condition(k * R, "≠", m * g)], [condition(k * R, ">", m * g)]),
    ([condition(m, ">", 2 * k), condition(m, "≠", k)], [condition(m, ">", 2 * k)]),
    (
        [condition(sp.Abs(length), "≤", 1), condition(5 * H, "≥", g)],
        [condition(H * g + 10 * H, "≥", 5 * H**2 + g), condition(5 * H**2, "≥", H * g + g)],
    ),
    ([condition(k**3 + l**3, ">", 3 * k * l**2), condition(k, ">", l)], None),
    ([condition(c + k * l**2, ">", l * P)], None),
    # A factor of known sign, in front of one that has a sign too.
    (
        [condition(k + 3, ">", c), condition(sp.expand((k + 3 - c) * (k + 3 - c + l * k)), "≥", 0)],
        [condition(k + 3, ">", c)],
    ),
    # Two products with a factor that can have one sign only.
    (
        [
            condition(sp.expand((k + l - c) * (k + P)), "≥", 0),
            condition(sp.expand((k + l - c) * (P - m)), "≥", 0),
            condition(c, "≠", k + l),
        ],
        [condition(k + l, ">", c), condition(P, "≥", m)],
    ),
    ([condition(k + l, "≥", m + g), condition(m + g, "≠", k + l)], [condition(k + l, ">", m + g)]),
    # |N/D| ≤ 1 where D has a sign.
    ([condition(sp.Abs(k / (2 * (k - m))), "≤", 1), condition(k, ">", m)], [condition(k, "≥", 2 * m)]),
    ([condition(sp.Abs(k / (2 * (k - m))), "≤", 1), condition(m, ">", k)], [condition(2 * m, "≥", 3 * k)]),
]  # fmt: skip


@pytest.mark.parametrize(("given", "shortest"), CASES, ids=str)
def test_conditions_are_shortened_and_say_the_same(
    given: list[SignCondition], shortest: list[SignCondition] | None
) -> None:
    found = further_conditions(given)
    assert found is not None
    assert [*found] == (given if shortest is None else shortest)
    rng = random.Random(3)
    symbols = sorted({s for x in given for s in (x.lhs - x.rhs).free_symbols}, key=str)
    sides = set()
    for _ in range(150):
        at = {s: sp.Rational(rng.randint(1, 60), rng.randint(1, 20)) for s in symbols}
        sides.add(holds(given, at))
        assert holds(given, at) is holds(found, at)
    assert sides == {True, False}


@pytest.mark.parametrize("low", [sp.cos(4 * sp.pi / 9), sp.sqrt(2) - 1])
def test_the_signs_of_irrational_coefficients(low: sp.Expr) -> None:
    """cos 80° <= P/(k l) <= 1: neither bound follows from the other, nor contradicts it."""
    both = [condition(P, "≥", low * k * l), condition(k * l, "≥", P)]
    found = further_conditions(both)
    assert found is not None
    assert {(c.lhs, c.rhs) for c in found} == {(P, low * k * l), (k * l, P)}


def test_conditions_that_exclude_each_other() -> None:
    assert further_conditions([condition(k, ">", m * g), condition(m * g, ">", 2 * k)]) is None
    assert further_conditions([condition(k, ">", m + g), condition(m, ">", k + l)]) is None
    # x ≥ 0 and x ≤ −1 for x = (k l − 6)/D with D = k + 3 − c, whichever sign D has
    divisor = k + 3 - c
    right, left = sp.expand((k * l - 6) * divisor), sp.expand(-(k * l - 6 + divisor) * divisor)
    given = [condition(right, "≥", 0), condition(left, "≥", 0), condition(c, "≠", k + 3)]
    assert further_conditions(given) is None


def test_what_is_positive_is_not_said_to_differ_from_zero() -> None:
    """Also of conditions that are no polynomials."""
    slope = sp.cos(k) - m * sp.sin(k)
    positive, other = condition(slope, ">", 0), condition(m, ">", g)
    assert further_conditions([condition(slope, "≠", 0), positive]) == (positive,)
    assert further_conditions([other, condition(-slope, "≠", 0), positive]) == (other, positive)
    assert further_conditions([condition(slope, "≥", 0), condition(slope, "≠", 0)]) == (
        condition(sp.cos(k), ">", m * sp.sin(k)),
    )


def test_what_is_known_is_not_repeated() -> None:
    known = [condition(k * R, "≥", 2 * m * g)]
    assert further_conditions([pulls], known) == ()
    strict = condition(k * R, ">", 2 * m * g)
    assert further_conditions([strict, pulls], known) == (strict,)
    assert only_excludes_equality([strict], known)
    assert not only_excludes_equality([condition(k * R, ">", 3 * m * g)], known)


# -- Conditions under which several expressions are positive, against signs at random values of the parameters ---------


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


def test_a_product_is_implied_by_its_factors() -> None:
    """(l - R) (l - 2R) > 0 follows from l > 2R, with both signs of the factors; (l - R) (l - 3R) > 0 does not."""
    beyond = (condition(l, ">", 2 * R),)
    assert conditions_for([sp.expand((l - R) * (l - 2 * R)), l - 2 * R], []) == beyond
    assert conditions_for([sp.expand((R - l) * (2 * R - l)), l - 2 * R], []) == beyond
    assert len(conditions_for([sp.expand((l - R) * (l - 3 * R)), l - 2 * R], []) or ()) == 2
    assert len(conditions_for([sp.expand((l - R) * (l - P)), l - 2 * R], []) or ()) == 2
