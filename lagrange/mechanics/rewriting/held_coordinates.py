"""Coordinates that constraints hold, each by itself or several together, eliminated from the equations of motion.

Equations of motion with everything eliminated that constraints give: coordinates held fixed, r = R, and other
velocities.

A ball in a bowl keeps r = R, and rolling gives its spin, (R − r) φ' + r ψ' = 0: this leaves an equation in φ alone.

Coordinates that several constraints together hold, and the laws of motion for their constant values.

Two wheels on the road hold the height and the tilt of a car: δy = δφ = 0 although neither constraint says so alone. In
general the forces of the road contain φ, φ' and the moment of inertia; for φ = 0 Newton's law and the law of angular
momentum are linear equations with constant coefficients, N_A = (m g c + F h)/(b + c).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.zero_test import is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign, Unspecified, partial, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import EquationsOfMotion, WithEliminatedRates, closed
from lagrange.mechanics.results import InCoordinates, Solution


def without_given_rates(view: InCoordinates) -> WithEliminatedRates | None:
    """The equations of motion with the velocities substituted that constraints on velocities give.

    For a ball that rolls in a bowl, (R − r) φ' + r ψ' = 0, this is 7 (R − r) φ'' + 5 g sin φ = 0. None if a
    coordinate remains whose velocity was substituted, or where the equations become no shorter.
    """
    motion = view.motion
    if motion is None or motion.closed is not None or not motion.final or view.in_speeds is not None:
        return None
    coordinates, rows = view.configuration.slots.coordinates, view.configuration.rows
    used = [r for r in rows if r.finite is None and r.nonlinear is None]
    given = [coordinates[d] for d in motion.elimination.dependent if any(r.coefficients[d] != 0 for r in used)]
    freed = closed(motion, given).closed if used else None
    if freed is None or any(e.expression.has(q) for e in freed.equations for q in given):
        return None
    before, after = (sum(count_operations(e.expression) for e in es) for es in (motion.final, freed.equations))
    return freed if after < before else None


def held_values(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates that a constraint fixes by itself, r = R, each with its value; rates and accelerations are 0."""
    slots = configuration.slots
    moving = {*slots.coordinates, *slots.prescribed, t}
    values: dict[sp.Symbol, sp.Expr] = {}
    for f in configuration.finite_constraints:
        occurring = f.free_symbols & moving
        if len(occurring) != 1 or not occurring <= {*slots.coordinates}:
            continue
        [q] = occurring
        slope = partial(f, q)
        if slope.is_nonzero and not slope.has(q):
            values |= {q: sp.expand(q - f / slope), prime(q): sp.S.Zero, prime(q, 2): sp.S.Zero}
    return values


def given_rates(configuration: Configuration) -> dict[sp.Symbol, sp.Expr]:
    """The constant rates that a moving constraint gives by itself: φ = Ω t turns at Ω, without acceleration."""
    coordinates = {*configuration.slots.coordinates}
    rates: dict[sp.Symbol, sp.Expr] = {}
    for f in configuration.finite_constraints:
        turning = f.free_symbols & coordinates
        if t not in f.free_symbols or len(turning) != 1 or f.free_symbols & {*configuration.slots.prescribed}:
            continue
        [q] = turning
        slope = partial(f, q)
        rate = -textbook_form(f.diff(t) / slope) if slope.is_nonzero and not slope.has(q) else t
        if not rate.has(t, q):
            rates |= {prime(q): rate, prime(q, 2): sp.S.Zero}
    return rates


def where_held(e: sp.Expr, held: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """An expression with `held_values` substituted, unless it has unspecified functions, whose arguments are kept."""
    return e if e.has(Unspecified) or not e.free_symbols & {*held} else textbook_form(e.xreplace(dict(held)))


# -- A conserved quantity without the velocities that constraints give -------------------------------------------------
#
# Where a choice of coordinates keeps kinematic constraints, ẋ + R θ̇ = 0, its equations of motion end without θ̇. The
# energy ½ m ẋ² + ½ I θ̇² is then ½ (m + I/R²) ẋ²: a quadratic form in the velocities that remain, whose coefficients
# are
# collected. Where the coordinate itself occurs, as in a potential, both stay.


def in_remaining_velocities(e: sp.Expr, motion: EquationsOfMotion) -> sp.Expr:
    """The expression with the eliminated velocities substituted, collected where that is shorter."""
    closed = motion.closed
    if closed is None or e.has(Unspecified) or not e.free_symbols & {*closed.velocities}:
        return e
    if any(prime(q) in closed.velocities and e.has(q) for q in motion.configuration.slots.coordinates):
        return e
    substituted = e.xreplace(dict(closed.velocities))
    remaining = [v for v in motion.configuration.slots.velocities if v not in closed.velocities]
    at_rest = substituted.xreplace(dict.fromkeys(remaining, sp.S.Zero))
    moving = sp.expand(substituted - at_rest)
    if not moving.is_polynomial(*remaining):
        return substituted
    terms = sp.Poly(moving, *remaining).terms()
    powers = (sp.Mul(*(v**n for v, n in zip(remaining, exponents, strict=True))) for exponents, _ in terms)
    kinetic = (_shorter(c) * p for p, (_, c) in zip(powers, terms, strict=True))
    collected = sp.Add(*kinetic, at_rest)
    return min(substituted, collected, key=count_operations)


def _shorter(coefficient: sp.Expr) -> sp.Expr:
    return min(sp.factor(coefficient), sp.factor_terms(coefficient), key=count_operations)


# Held together


Values = dict[sp.Symbol, sp.Expr]


@record
class HeldTogether:
    """What constraints hold, and the forces there.

    values  of the coordinates, constants
    rule    the same, with their velocities and accelerations, which are zero
    forces  by the symbol in which the page writes each
    """

    values: Mapping[sp.Symbol, sp.Expr]
    rule: Mapping[sp.Symbol, sp.Expr]
    forces: Mapping[sp.Symbol, sp.Expr]


def held_together(solution: Solution) -> HeldTogether | None:
    """The coordinates that constraints hold only together, in the file's coordinates; None if there are none.

    Their values are those of the initial state; angles of which that says nothing are zero if the constraints allow it.
    """
    own, law = solution.own, solution.law
    if law is None or law.newton.bodies is None or own.motion is None or solution.choices:
        return None
    coordinates = _held(own.configuration)
    if not coordinates or {*coordinates} <= {*held_values(own.configuration)}:
        return None
    values = _values(solution, coordinates)
    if values is None:
        return None
    rule = values | {prime(q): sp.S.Zero for q in values} | {prime(q, 2): sp.S.Zero for q in values}
    forces = _forces(solution, rule)
    return None if forces is None else HeldTogether(values, rule, forces)


def _held(configuration: Configuration) -> list[sp.Symbol]:
    """The coordinates whose displacement the constraints keep zero: (0 ... 1 ... 0) is in the span of their rows."""
    slots = configuration.slots
    if any(r.nonlinear is not None or r.drift != 0 for r in configuration.rows):
        return []
    rows = [list(r.coefficients) for r in configuration.rows]
    size = len(slots.coordinates)
    held = []
    try:
        before = configuration.states.rank(rows) if rows else None
        for n, q in enumerate(slots.coordinates):
            alone = [sp.Integer(k == n) for k in range(size)]
            if before is not None and configuration.states.rank([*rows, alone]) == before:
                held.append(q)
    except DivisionByZeroError:
        return []
    return held


def _values(solution: Solution, held: list[sp.Symbol]) -> Values | None:
    """Constant values that satisfy all finite constraints on the coordinates that are held."""
    configuration = solution.own.configuration
    given = {v.symbol: v.value for v in solution.problem.initial}
    angles = {b.angle for b in solution.problem.bodies if isinstance(b.angle, sp.Symbol)}
    values: Values = {q: given[q] for q in held if q in given} | {q: sp.S.Zero for q in held if q in angles - {*given}}
    others = {*configuration.slots.coordinates, *configuration.slots.velocities, t} - {*held}
    about = [f for f in configuration.finite_constraints if not f.free_symbols & others]
    for f in about:
        there = f.xreplace(values)
        left = [q for q in held if q not in values and q in there.free_symbols]
        if len(left) == 1 and there.diff(left[0]).is_nonzero and not there.diff(left[0]).has(left[0]):
            values |= {left[0]: sp.expand(left[0] - there / there.diff(left[0]))}
    if len(values) < len(held) or any(is_zero(f.xreplace(values)) is not True for f in about):
        return None
    return {q: values[q] for q in held}


def _forces(solution: Solution, rule: Values) -> Values | None:
    """The forces of constraint from the laws of motion; None where these do not determine them, or are not linear."""
    law, own = solution.law, solution.own
    assert law is not None
    assert law.newton.bodies is not None
    laws = [(c.inertia - c.right).xreplace(rule) for b in law.newton.bodies for c in b.laws]
    wanted = [r.force for r in law.newton.reactions]
    unknown = [*wanted, *(a for a in own.configuration.slots.accelerations if a not in rule)]
    laws = [e for e in laws if e != 0]
    rows = [_coefficients(e, unknown) for e in laws]
    if any(e.has(sp.Abs, Sign, sp.sign) for e in laws) or any(r is None for r in rows):
        return None
    rest = dict.fromkeys(unknown, sp.S.Zero)
    solved = solved_linear(
        [r for r in rows if r is not None], [-e.xreplace(rest) for e in laws], own.configuration.states
    )
    if solved is None or any(v is None for v in solved):
        return None
    pairs = zip(wanted, solved, strict=False)
    return {name: min(v, sp.factor(v), key=count_operations) for name, v in pairs if v is not None}


def _coefficients(e: sp.Expr, unknown: Sequence[sp.Symbol]) -> list[sp.Expr] | None:
    """The coefficients of unknowns, shape (len(unknown),), in one walk over the terms; None if e is not linear."""
    shares: dict[sp.Expr, list[sp.Expr]] = {u: [] for u in unknown}
    for term in sp.Add.make_args(sp.expand(e)):
        occurring = term.free_symbols & shares.keys()
        if not occurring:
            continue
        coefficient, rest = term.as_independent(*occurring, as_Add=False)
        if rest not in shares:
            return None
        shares[rest].append(coefficient)
    return [sp.Add(*share) for share in shares.values()]
