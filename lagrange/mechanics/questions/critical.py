"""The critical value of a parameter: where an equilibrium that exists for every value of it ceases to be stable.

A column is in equilibrium upright under any load P. Asked for P in that position, a book means the load under which it
buckles. The conditions of stability are the signs of minors of V_kj, functions f(P) in which P has at most the second
power; between neighbouring roots of all of them no sign changes. The root at which stability ends, or begins, is the
critical value if it is the only one. Signs and the order of the roots are decided exactly, for all values of the other
parameters, or there is no answer.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cmp_to_key
from itertools import pairwise

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import numerator
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import SignCondition, sign_of
from lagrange.algebra.closed_forms.unit_circle import NotAlgebraicError
from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.stability import SecondVariation, StabilityVerdict
from lagrange.mechanics.questions.results import AnswerBranch

Condition = tuple[sp.Expr, sp.Expr]


class _OpenError(Exception):
    """A sign or an order depends on the parameters."""


def critical_value(
    parameter: sp.Symbol, when: Sequence[Condition], resting: Equilibrium, second: SecondVariation | None
) -> AnswerBranch | None:
    """The value of a parameter at which the equilibrium that `when` names becomes unstable; None if not found."""
    there = [*_branches_where(when, resting)]
    if second is None or len(there) != 1:
        return None
    [(n, state)] = there
    stability = second.verdicts[n]
    if stability.verdict is not StabilityVerdict.CONDITIONAL:
        return None
    wanted = [_positive_where_stable(c) for c in stability.conditions]
    try:
        value = _limit_of_stability(wanted, parameter)
    except _OpenError:
        return None
    return None if value is None else AnswerBranch(parameter, value, (value,), ({**state, parameter: value},))


def _branches_where(when: Sequence[Condition], resting: Equilibrium) -> Iterator[tuple[int, dict[sp.Symbol, sp.Expr]]]:
    """The branches with one point, at which the conditions hold, and the values of the coordinates there."""
    coordinates = resting.configuration.slots.coordinates
    for n, b in enumerate(resting.branches):
        state = {r.lhs: r.rhs for r in b.equations if isinstance(r.lhs, sp.Symbol)}
        if b.left or b.special or len(b.points) != 1 or not {*coordinates} <= state.keys():
            continue
        try:
            if all(is_zero((left - right).xreplace(state)) for left, right in when):
                yield n, {q: state[q] for q in coordinates}
        except (NotAlgebraicError, DivisionByZeroError):
            continue


def _positive_where_stable(c: SignCondition) -> sp.Expr:
    return c.lhs - c.rhs if c.relation in (">", "≥") else c.rhs - c.lhs


def _limit_of_stability(wanted: Sequence[sp.Expr], parameter: sp.Symbol) -> sp.Expr | None:
    """The only positive value at which it changes whether all expressions are positive. Raises _OpenError."""
    roots: list[sp.Expr] = []
    for e in wanted:
        roots += [r for r in _positive_roots(e, parameter) if not any(is_zero(r - known) for known in roots)]
    roots.sort(key=cmp_to_key(_order))
    if not roots:
        return None
    between = [roots[0] / 2, *((a + b) / 2 for a, b in pairwise(roots)), 2 * roots[-1]]
    stable = [all(_sign(e.xreplace({parameter: p})) == 1 for e in wanted) for p in between]
    limits = [r for r, before, after in zip(roots, stable, stable[1:], strict=False) if before != after]
    return limits[0] if len(limits) == 1 else None


def _positive_roots(e: sp.Expr, parameter: sp.Symbol) -> Iterator[sp.Expr]:
    if e.coeff(parameter) in (1, -1) and not (rest := e - e.coeff(parameter) * parameter).has(parameter):
        value = -rest * e.coeff(parameter)  # as it is written: P < K (3/2 − √5/2)/l
        yield from [value] if _sign(value) == 1 else ()
        return
    parts = numerator(e)
    if parts is None or not parts[0].is_polynomial(parameter):
        raise _OpenError
    poly = sp.Poly(parts[0], parameter)
    if poly.degree() == 0:
        return
    if poly.degree() > 2:
        raise _OpenError
    a, b, c = poly.nth(2), poly.nth(1), poly.nth(0)
    if a == 0:
        found = [-c / b]
    else:
        square = sp.factor(b**2 - 4 * a * c)
        if _sign(square) != 1:
            raise _OpenError
        found = [(-b + s * sp.sqrt(square)) / (2 * a) for s in (1, -1)]
    yield from (shortest_form(sp.factor(sp.expand(r))) for r in found if _sign(r) == 1)


def _order(a: sp.Expr, b: sp.Expr) -> int:
    return _sign(a - b)


def _sign(e: sp.Expr) -> int:
    sign = sign_of(sp.factor(sp.expand(e)))
    if sign is None:
        raise _OpenError
    return sign
