"""Equations of motion with everything eliminated that constraints give: coordinates held fixed, r = R, and other
velocities.

A ball in a bowl keeps r = R, and rolling gives its spin, (R − r) φ' + r ψ' = 0: this leaves an equation in φ alone.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.core.symbols import Unspecified, partial, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.equations import EquationsOfMotion, WithEliminatedRates, closed
from lagrange.mechanics.results import InCoordinates


def without_given_rates(view: InCoordinates) -> WithEliminatedRates | None:
    """The equations of motion with the velocities substituted that constraints on velocities give.

    For a ball that rolls in a bowl, (R − r) φ' + r ψ' = 0, this is 7 (R − r) φ'' + 5 g sin φ = 0. None where a
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
