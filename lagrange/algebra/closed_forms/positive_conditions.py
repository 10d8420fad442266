"""Under which conditions on the parameters several expressions are positive, each where those before it are.

A condition that another implies is dropped: of e > 2a and e > 4a, with a > 0, the second is kept.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations

import sympy as sp

from lagrange.algebra.closed_forms.limits import LARGEST_FACTORED, LARGEST_SIGNED
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, more_than_zero, sign_of
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.operations import count_operations


class NeverPositiveError(Exception):
    """Some expressions are positive for no values of the parameters."""


def conditions_for(expressions: Iterable[sp.Expr], known: Sequence[sp.Expr]) -> tuple[SignCondition, ...] | None:
    """The conditions under which all expressions are positive; None if they are too long to be of use.

    Raises NeverPositiveError if they cannot be, one being negative where those before it are positive.
    """
    known = list(known)
    conditions = []
    for e in expressions:
        sign = sign_on(e, known)
        if sign in (-1, 0):
            raise NeverPositiveError
        if sign is None:
            condition = more_than_zero(e, known)
            conditions.append(condition)
            known.append(sp.factor(condition.lhs - condition.rhs) * (-1 if condition.relation == "<" else 1))
    if any(count_operations(c.lhs - c.rhs) > LARGEST_FACTORED for c in conditions):
        return None
    kept = _without_weaker(conditions)
    return tuple(SignCondition(shortest_form(c.lhs), c.relation, shortest_form(c.rhs)) for c in kept)


def _without_weaker(conditions: Sequence[SignCondition]) -> list[SignCondition]:
    """The conditions without those implied by another one: of e > 2a and e > 4a, with a > 0, the second.

    Raises NeverPositiveError if two of them exclude each other.
    """
    above = [positive_part(c) for c in conditions]
    if any(sign_of(sp.expand(x + y)) in (-1, 0) for x, y in combinations(above, 2)):
        raise NeverPositiveError
    kept = list(range(len(conditions)))
    for n in range(len(conditions)):
        others = [k for k in kept if k != n]
        if any(sign_of(sp.expand(above[n] - above[k])) in (0, 1) for k in others):
            kept = others
    return [conditions[k] for k in kept]


def positive_part(c: SignCondition) -> sp.Expr:
    """What a condition says to be positive."""
    return (c.lhs - c.rhs) * (-1 if c.relation == "<" else 1)


def where_positive(expressions: Iterable[sp.Expr], known: Sequence[sp.Expr]) -> tuple[SignCondition, ...]:
    """Conditions one of which must hold for one of the expressions to be positive: without those that imply another."""
    conditions: list[SignCondition] = []
    for e in expressions:
        try:
            conditions += conditions_for([e], known) or ()
        except NeverPositiveError:
            continue
    conditions = list(dict.fromkeys(conditions))
    implied = (
        any(sign_of(sp.expand(positive_part(other) - positive_part(c))) == 1 for other in conditions if other != c)
        for c in conditions
    )
    return tuple(c for c, weaker in zip(conditions, implied, strict=True) if not weaker)


def sign_on(e: sp.Expr, known: Sequence[sp.Expr]) -> int | None:
    """The sign of an expression, given others that are positive; None if it is not determined."""
    if e == 0 or is_zero(e):
        return 0
    return sign_of(e, known)


def bases(x: sp.Expr) -> Iterator[tuple[sp.Expr, bool]]:
    """The factors of an expression without their exponents, those under roots among them; whether exponents are odd."""
    for factor in sp.Mul.make_args(sp.factor(x) if count_operations(x) <= LARGEST_SIGNED else x):
        base, exponent = factor.as_base_exp()
        if exponent.is_Rational and not exponent.is_Integer:
            yield from ((f, False) for f, _ in bases(base))
        elif not base.is_number:
            yield base, bool(exponent.is_odd)
