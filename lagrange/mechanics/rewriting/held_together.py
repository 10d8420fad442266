"""Coordinates that several constraints together hold, and the laws of motion for their constant values.

Two wheels on the road hold the height and the tilt of a car: δy = δφ = 0 although neither constraint says so alone. In
general the forces of the road contain φ, φ' and the moment of inertia; for φ = 0 Newton's law and the law of angular
momentum are linear equations with constant coefficients, N_A = (m g c + F h)/(b + c).
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.core.operations import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Sign, prime, t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.held_coordinates import held_values

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
    """The coordinates that constraints hold only together, in the file's coordinates; None where there are none.

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
    rows = [[sp.expand(e).diff(u) for u in unknown] for e in laws]
    if any(
        e.has(sp.Abs, Sign, sp.sign) or c.free_symbols & {*unknown} for e, r in zip(laws, rows, strict=True) for c in r
    ):
        return None
    rest = dict.fromkeys(unknown, sp.S.Zero)
    solved = solved_linear(rows, [-e.xreplace(rest) for e in laws], own.configuration.states)
    if solved is None or any(v is None for v in solved):
        return None
    pairs = zip(wanted, solved, strict=False)
    return {name: min(v, sp.factor(v), key=count_operations) for name, v in pairs if v is not None}
