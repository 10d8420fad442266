"""Wrong speeds, times and distances of a motion with a constant acceleration: which changed problem has them?

Where the energy of a coordinate q is ½ M q'² + c q with constant M and c, its acceleration A is constant, and each of

    v² = v_0² + 2 A (q − q_0) ,     q − q_0 = v_0 t + ½ A t²

gives the A that a stated speed, time or place implies. It is compared with the equations of each changed problem, as a
stated acceleration would be. A time that is the distance divided by the final velocity, or that lacks the ½, is named
as such.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import (
    DivisionByZeroError,
    InadmissibleError,
    NoPointError,
    UnsupportedError,
    is_zero,
)
from lagrange.answers.references import ReferenceCandidate
from lagrange.answers.results.starts import of_changed_problems
from lagrange.core.records import record
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.questions.results import Asked


@record
class Uniform:
    """A motion with a constant acceleration from q_0 with v_0."""

    coordinate: sp.Symbol
    start: sp.Expr
    velocity: sp.Expr
    acceleration: sp.Expr


def explained_uniform(
    claim: sp.Expr, asked: Asked, others: Sequence[Asked], candidates: Sequence[ReferenceCandidate]
) -> str:
    """The changed problem that gives a wrong value, in a sentence; empty if none is found."""
    motion = next(filter(None, (_uniform(a) for a in (asked, *others) if a.choice == asked.choice)), None)
    if motion is None:
        return ""
    try:
        if asked.question.quantity == t and (place := _place(asked, motion)) is not None:
            way, end = (
                place - motion.start,
                sp.sqrt(motion.velocity**2 + 2 * motion.acceleration * (place - motion.start)),
            )
            if motion.velocity == 0 and is_zero(claim**2 - way / motion.acceleration) is True:
                return "the way is taken as A t^2, and with a constant acceleration A from rest it is A t^2/2"
            if is_zero(claim**2 - (way / end) ** 2) is True:
                return "the way is divided by the velocity at its end, and the velocity changes"
        stated = _acceleration(claim, asked, motion)
        if stated is None or is_zero(stated - motion.acceleration) is not False:
            return ""
        for candidate in candidates:
            q = motion.coordinate
            if q in candidate.configuration.slots.coordinates:
                return next(_of_models(stated, q, candidate), "")
    except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError, ValueError):
        pass
    return ""


def _uniform(asked: Asked) -> Uniform | None:
    initial = {s.symbol: s.value for s in asked.initial}
    for integral in asked.integrals:
        whole = sp.expand(integral.expression)
        rates = sorted((s for s in whole.free_symbols if s.name.endswith("'")), key=str)
        if integral.factor != 1 or len(rates) != 1:
            continue
        [v] = rates
        q = base(v)
        inertia, pull = 2 * whole.coeff(v, 2), whole.coeff(v, 0).diff(q)
        constant = not (inertia.has(v, q) or pull.has(v, q)) and whole.coeff(v, 1) == 0
        if constant and inertia != 0 and pull != 0 and q in initial and v in initial:
            return Uniform(q, initial[q], initial[v], -pull / inertia)
    return None


def _place(asked: Asked, motion: Uniform) -> sp.Expr | None:
    """The value of q at which the question is asked; None if `when` is no such place."""
    for c in asked.question.when:
        difference = sp.expand(c.lhs - c.rhs)
        slope = difference.coeff(motion.coordinate)
        rest = sp.expand(difference - slope * motion.coordinate)
        if slope != 0 and slope.is_number and not rest.has(motion.coordinate, prime(motion.coordinate)):
            return -rest / slope
    return None


def _acceleration(claim: sp.Expr, asked: Asked, motion: Uniform) -> sp.Expr | None:
    """The A for which a stated value would be right; None if the question is of another kind."""
    q, v = motion.coordinate, prime(motion.coordinate)
    quantity, place = asked.question.quantity, _place(asked, motion)
    at_turn = any(sp.expand(c.lhs - c.rhs) in (v, -v) for c in asked.question.when)
    if place is not None and quantity in (v, v**2):
        square = claim**2 if quantity == v else claim
        return (square - motion.velocity**2) / (2 * (place - motion.start))
    if place is not None and quantity == t:
        return 2 * (place - motion.start - motion.velocity * claim) / claim**2
    if at_turn and quantity == q:
        return -(motion.velocity**2) / (2 * (claim - motion.start))
    if at_turn and quantity == t:
        return -motion.velocity / claim
    return None


def _of_models(stated: sp.Expr, q: sp.Symbol, candidate: ReferenceCandidate) -> Iterator[str]:
    models = candidate.models
    if models.mechanics is None:
        return
    yield from of_changed_problems(prime(q, 2) - stated, models)
