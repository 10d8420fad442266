"""Statements that hold for the motion from the initial state of the file, and not for every motion.

A normal force as a function of the position alone, N = m g (3 cos θ − 2 cos α), follows with the energy that the motion
has from the start, E(q, q') = E(q_0, q'_0). This relation is linear in some parameter that occurs in no constraint,
mostly g or a stiffness: replaced by its value from the relation, in the statement and in the equations of motion, it
leaves position and velocity free, and both are compared as ever, exactly.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.core.diagnostics import ProblemError
from lagrange.core.symbols import base, prime, t
from lagrange.mechanics.dynamics.comparison import Standing, System, compare

if TYPE_CHECKING:
    from lagrange.mechanics.results import InCoordinates, Solution

FROM_THE_START = "it holds for the motion from the given initial state"


def relation_from_start(solution: Solution, view: InCoordinates) -> sp.Expr | None:
    """What vanishes in every state after the initial one: the energy less its first value. None: not known."""
    from lagrange.mechanics.questions.states import MotionView, initial_state

    if not solution.problem.initial or view.dynamics is None or view.conserved is None or solution.law is None:
        return None
    integral = next((i for i in view.conserved.integrals if i.constant is True and i.quantity.value == "energy"), None)
    if integral is None:
        return None
    place = MotionView(view.dynamics, view.conserved, solution.law)
    try:
        initial = initial_state(place, solution.problem, [v.configuration for v in solution.views])
    except ProblemError:
        return None
    value = integral.expression.xreplace({t: sp.S.Zero, **initial})
    return None if value.free_symbols & {*place.moving} else integral.expression - value


def holds_from_start(
    claims: Sequence[sp.Expr], written: Sequence[sp.Expr], relation: sp.Expr, system: System, forces: Collection[str]
) -> bool:
    """Whether claims in the coordinates of a system hold for the motion from the initial state.

    written   the same as the answer has them: about a reaction, or an energy, or with a parameter of the initial state
    relation  what vanishes in every state after the initial one
    forces    the names of reactions

    Other equations must hold in every state.
    """
    slots = system.configuration.slots
    known = (e.free_symbols for e in system.equations)
    of_start = relation.free_symbols.difference({t, *slots.coordinates, *slots.velocities}, *known)
    if any(e.free_symbols.isdisjoint(of_start) and not _may_depend_on_start(e, forces) for e in written):
        return False
    rule = _rule(relation, system)
    if not rule:
        return False
    on_the_way = replace(system, equations=tuple(e.xreplace(rule) for e in system.equations))
    try:
        result = compare([e.xreplace(rule) for e in claims], on_the_way)
    except DivisionByZeroError:
        return False
    bad = {Standing.CONTRADICTS, Standing.NOT_LINEAR}
    return result is not None and not bad & {*result.standings}


def _may_depend_on_start(e: sp.Expr, forces: Collection[str]) -> bool:
    if any(s.name in forces for s in e.free_symbols):
        return True
    rates = {s for s in e.free_symbols if base(s) != s}
    return bool(rates) and all(s == prime(base(s)) for s in rates)


def _rule(relation: sp.Expr, system: System) -> dict[sp.Symbol, sp.Expr]:
    """A parameter in which the relation is linear, and its value from it; empty if there is none."""
    slots, rows = system.configuration.slots, system.configuration.rows
    bound = {t, *slots.coordinates, *slots.velocities, *slots.accelerations, *system.multipliers}
    bound = bound.union(*(e.free_symbols for r in rows for e in (*r.coefficients, r.drift)))
    bound = bound.union(*(e.free_symbols for e in system.configuration.finite_constraints))
    in_motion = set().union(*(e.free_symbols for e in system.equations))
    for p in sorted((relation.free_symbols & in_motion) - bound, key=lambda s: (s.name != "g", s.name)):
        slope = sp.diff(relation, p)
        if p not in slope.free_symbols and slope != 0:
            return {p: -relation.xreplace({p: sp.S.Zero}) / slope}
    return {}
