"""First integrals with their values from the initial state.

These are the conserved quantities of the motion and, where they do not suffice, integrals of single equations: with

    q'' = f(q) + g(q) q'^2 ,     w = exp(−2 ∫ g dq) :      d/dt (w q'^2/2 − ∫ w f dq) = 0
    q'' = g(q) q' :                                        d/dt (q' − ∫ g dq) = 0

The first is the work–energy theorem for a force that depends on the square of the velocity, such as friction on
a circle; without g it is that for a force that depends on the position. Each is verified: its rate must vanish with the
equations of motion, exactly.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from itertools import chain

import sympy as sp

from lagrange.algebra.closed_forms.polynomial_roots import factored_quotient
from lagrange.algebra.closed_forms.shortest_form import shortest_form
from lagrange.algebra.closed_forms.signs import sign_of
from lagrange.algebra.exact.zero_test import DivisionByZeroError, vanishes
from lagrange.algebra.forms.antiderivatives import antiderivative
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, prime, t
from lagrange.mechanics.questions.elimination import eliminated
from lagrange.mechanics.questions.limits import LONGEST_EQUATION, LONGEST_INTEGRATED
from lagrange.mechanics.questions.results import AnswerBranch, IntegralKind, UsedIntegral
from lagrange.mechanics.questions.states import Meanings, MotionView, SymbolValues


def integrals(place: MotionView, known: Meanings, initial: SymbolValues) -> tuple[list[UsedIntegral], set[sp.Symbol]]:
    """The integrals whose value is known, and the initial values that others would need."""
    used: list[UsedIntegral] = []
    missing: set[sp.Symbol] = set()
    candidates = chain(
        (
            UsedIntegral(IntegralKind.CONSERVED, known.on_side(i.expression), sp.S.Zero, n)
            for n, i in enumerate(place.conserved.integrals)
            if i.constant is True
        ),
        (extra for extra in _single(place, known) if _is_new(extra.expression, used, place)),
    )
    for integral in candidates:
        value = integral.expression.xreplace({t: sp.S.Zero, **initial})
        free = value.free_symbols & {*place.moving}
        if free:
            missing |= free
        else:
            used.append(replace(integral, value=textbook_form(value)))
    return used, missing


def resting_centres(used: Sequence[UsedIntegral], place: MotionView, initial: SymbolValues) -> list[UsedIntegral]:
    """Σ c q for each integral Σ c q' = 0 with constant c; `equation` is Σ c q'.

    Two bodies that attract each other, from rest: their mass centre does not move.
    """
    slots = place.configuration.slots
    centres = []
    for i in (i for i in used if i.value == 0):
        shares = {q: i.expression.diff(v) for q, v in zip(slots.coordinates, slots.velocities, strict=True)}
        rate = sp.Add(*(c * prime(q) for q, c in shares.items()))
        centre = sp.Add(*(c * q for q, c in shares.items()))
        start = centre.xreplace(dict(initial))
        is_constant = all(c.free_symbols.isdisjoint(place.moving) for c in (*shares.values(), start))
        if is_constant and len(rate.args) > 1 and vanishes(sp.expand(i.expression - rate)):
            centres.append(UsedIntegral(IntegralKind.CENTRE, centre, textbook_form(start), equation=rate))
    return centres


def has_pole(e: sp.Expr, condition: sp.Expr, coordinates: Collection[sp.Symbol]) -> bool:
    """Whether an expression is infinite where a condition on the coordinates holds: −G/(y − x) where y = x.

    A statement that it excludes the condition would be about the model: bodies that meet have no energy there.
    """
    for q in sorted(condition.free_symbols & {*coordinates}, key=str):
        slope = condition.diff(q)
        if slope == 0 or q in slope.free_symbols:
            continue
        place = {q: sp.expand(q - condition / slope)}
        below = (p.base.xreplace(place) for p in e.atoms(sp.Pow) if p.exp.is_negative and q in p.base.free_symbols)
        return any(sp.expand(x) == 0 for x in below)
    return False


def _single(place: MotionView, known: Meanings) -> Iterator[UsedIntegral]:
    """The integrals of equations q'' = a(q, q') of one coordinate."""
    slots = place.configuration.slots
    for q in slots.coordinates:
        a, v = known.accelerations.get(prime(q, 2)), prime(q)
        if a is None or count_operations(a) > LONGEST_INTEGRATED or a.has(Unspecified):
            continue
        if not a.free_symbols.isdisjoint({*place.moving} - {q, v}):
            continue
        integral = _of_square(q, v, a) or _of_first_power(q, v, a) or _of_speed(q, v, a)
        if integral is not None and vanishes(integral.expression.diff(q) * v + integral.expression.diff(v) * a):
            yield integral


def _of_square(q: sp.Symbol, v: sp.Symbol, a: sp.Expr) -> UsedIntegral | None:
    """w q'²/2 − ∫ w f dq."""
    expanded = sp.expand(a)
    if not expanded.is_polynomial(v):
        return None
    powers = dict(zip(*_powers(expanded, v), strict=True))
    if set(powers) - {0, 2}:
        return None
    f, g = powers.get(0, sp.S.Zero), powers.get(2, sp.S.Zero)
    exponent = antiderivative(-2 * g, q)
    if exponent is None:
        return None
    w = sp.exp(exponent) if exponent != 0 else sp.S.One
    w = w.replace(lambda e: isinstance(e, sp.exp) and e.args[0].has(sp.log), lambda e: _power(e.args[0]))
    work = antiderivative(sp.expand(w * f), q)
    if work is None:
        return None
    work = factored_quotient(work) if w != 1 else work
    return UsedIntegral(IntegralKind.WORK, w * v**2 / 2 - work, sp.S.Zero, None, q, w, a)


def _power(exponent: sp.Expr) -> sp.Expr:
    """e^{n log x} as x^n."""
    factors: list[tuple[sp.Expr, sp.Expr]] = []
    rest: list[sp.Expr] = []
    for term in sp.Add.make_args(exponent):
        c, log = term.as_independent(sp.log, as_Add=False)
        if isinstance(log, sp.log) and c.is_Integer:
            factors.append((c, log))
        else:
            rest.append(term)
    return sp.Mul(*(log.args[0] ** c for c, log in factors)) * sp.exp(sp.Add(*rest))


def _of_first_power(q: sp.Symbol, v: sp.Symbol, a: sp.Expr) -> UsedIntegral | None:
    """q' − ∫ g dq."""
    g = sp.cancel(a / v) if a.is_polynomial(v) else None
    if g is None or v in g.free_symbols:
        return None
    work = antiderivative(g, q)
    return None if work is None else UsedIntegral(IntegralKind.IMPULSE, v - work, sp.S.Zero, None, q, sp.S.One, a)


def _of_speed(q: sp.Symbol, v: sp.Symbol, a: sp.Expr) -> UsedIntegral | None:
    """∫ v dv/a − q, where the acceleration depends on the velocity alone: a car with constant power."""
    if q in a.free_symbols or not a.is_rational_function(v):
        return None
    way = antiderivative(sp.cancel(v / a), v)
    return None if way is None else UsedIntegral(IntegralKind.SPEED, way - q, sp.S.Zero, None, q, sp.S.One, a)


def _powers(e: sp.Expr, v: sp.Symbol) -> tuple[list[int], list[sp.Expr]]:
    terms = sp.Poly(e, v).terms()
    return [int(n) for (n,), _ in terms], [c for _, c in terms]


def _is_new(e: sp.Expr, used: Sequence[UsedIntegral], place: MotionView) -> bool:
    """Whether an integral adds information about the velocities to the known ones."""
    configuration = place.configuration
    slots = configuration.slots
    rows = [[i.expression.diff(v) for v in slots.velocities] for i in used]
    rows += [list(r.coefficients) for r in configuration.rows if r.nonlinear is None]
    if not rows:
        return True
    try:
        before = configuration.states.rank(rows)
        after = configuration.states.rank([*rows, [e.diff(v) for v in slots.velocities]])
    except DivisionByZeroError:
        return False
    return before is not None and after is not None and after > before


# -- questions that one integral answers by itself, in whatever state the system is ------------------------------------


@record
class ByIntegral:
    """The integral, and the answers; `verified` if they satisfy the condition exactly."""

    integral: UsedIntegral
    branches: tuple[AnswerBranch, ...]
    verified: bool | None = True


def multiple_of_integral(
    quantity: sp.Expr, called: sp.Expr, integrals: Sequence[UsedIntegral], moving: Collection[sp.Symbol]
) -> ByIntegral | None:
    """The value of a multiple of an integral; None if the quantity is none.

    called  the quantity as the file has it
    """
    for i in integrals:
        if count_operations(i.expression) >= LONGEST_EQUATION:
            continue
        ratio = sp.cancel(quantity / i.expression)
        if ratio.free_symbols.isdisjoint(moving):
            value = shortest_form(ratio * i.value)
            return ByIntegral(i, (AnswerBranch(called, value, (value,)),))
    return None


def parameter_of_integral(
    when: Sequence[sp.Expr],
    parameter: sp.Symbol | None,
    called: sp.Expr,
    integrals: Sequence[UsedIntegral],
    moving: Collection[sp.Symbol],
) -> ByIntegral | None:
    """The parameter for which an integral has a given value; None if the condition mentions no integral."""
    if parameter is None or len(when) != 1 or count_operations(when[0]) >= LONGEST_EQUATION:
        return None
    for i in integrals:
        rest = sp.expand(when[0] - i.expression)
        if not rest.free_symbols.isdisjoint(moving):
            continue
        found = eliminated([rest + i.value], parameter, [parameter], [], called)
        branches = tuple(b for b in found.branches if not (parameter.is_positive and -1 in map(sign_of, b.values)))
        if branches and found.solved and not found.free:
            return ByIntegral(i, branches, found.verified)
    return None
