"""What a choice knows only through its velocities, put into its equations of motion.

A choice keeps y, and R φ' = y' is all that is known of φ: the virtual displacement δφ is eliminated through it, but the
equation that is left still has φ'' in it. The constraints that have such velocities are solved for them and
differentiated,

    q_e' = B q_c' + b ,      q_e'' = d/dt (B q_c' + b) ,

and both are put in. Where B, b and the equations are free of the q_e themselves, what is left is an equation in the
chosen coordinates alone. Where it is not (a spiral spring turned by φ), those constraints complete the equations.
Nothing is put in where a finite relation that could not be solved holds a q_e: it would be solved in name only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

import sympy as sp

from lagrange.algebra.fourier.common_factor import is_acceleration
from lagrange.algebra.fourier.textbook import Factor, Textbook, textbook_form
from lagrange.core.symbols import prime
from lagrange.mechanics.constraints.displacements import TooLongError, eliminate
from lagrange.mechanics.constraints.kinematics import Configuration, Row
from lagrange.mechanics.dynamics.equations import Closed, EquationOfMotion, EquationsOfMotion, divided

M = TypeVar("M", bound=EquationsOfMotion)

_NOTHING = Factor(sp.S.One, ())

LONGEST = 200
"""Operations of the velocities that are still put in."""
MOST_LONGER = 3
"""How many times as long as before the equations may become."""


def closed(motion: M, through_rates: Sequence[sp.Symbol]) -> M:
    """The equations of motion with the velocities and accelerations of the coordinates `through_rates` put in.

    They stay as they are where the constraints on velocities do not give these velocities, each by the others, or
    would make the equations much longer.
    """
    configuration = motion.configuration
    used = [r for r in configuration.rows if _mentions(r, configuration, through_rates)]
    velocities = _velocities(configuration, used, through_rates)
    if not velocities:
        return motion
    slots = configuration.slots
    still = [textbook_form(slots.time_derivative(v).xreplace(velocities)) for v in velocities.values()]
    rule = {**velocities, **{prime(v): a for v, a in zip(velocities, still, strict=True)}}
    equations = tuple(_put_in(e, rule, motion.principle.textbook) for e in motion.equations)
    if _length(equations) > MOST_LONGER * _length(motion.equations) + LONGEST:
        return motion
    rows = [r for r in configuration.rows if r not in used]
    if any(not e.expression.free_symbols.isdisjoint(through_rates) for e in equations):
        rows = list(configuration.rows)
    return replace(motion, closed=Closed(velocities, rule, equations, tuple(r.name for r in used), tuple(rows)))


def _mentions(row: Row, configuration: Configuration, through_rates: Sequence[sp.Symbol]) -> bool:
    """Whether such a coordinate or its velocity occurs in a constraint."""
    found = row.velocity_form(configuration.slots).free_symbols | (
        row.finite.free_symbols if row.finite is not None else set()
    )
    return any(q in found or prime(q) in found for q in through_rates)


def _velocities(
    configuration: Configuration, rows: Sequence[Row], through_rates: Sequence[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr]:
    """Their velocities by those of the chosen coordinates; empty where the constraints do not give just these."""
    if not through_rates or any(r.finite is not None or r.nonlinear is not None for r in rows):
        return {}
    slots = configuration.slots
    places = [slots.coordinates.index(q) for q in through_rates]
    try:
        solved = eliminate(rows, len(slots.coordinates), configuration.states, places, LONGEST)
    except TooLongError:
        return {}
    if set(solved.dependent) != set(places):
        return {}
    rates = {
        slots.velocities[d]: sp.Add(
            *(b * slots.velocities[k] for b, k in zip(row, solved.independent, strict=True)), drift
        )
        for d, row, drift in zip(solved.dependent, solved.solution, solved.drift, strict=True)
    }
    return {prime(q): rates[prime(q)] for q in through_rates}


def _put_in(equation: EquationOfMotion, rule: dict[sp.Symbol, sp.Expr], textbook: Textbook) -> EquationOfMotion:
    """The equation in textbook form; as it was where nothing is put in."""
    before = equation.expression
    if before.free_symbols.isdisjoint(rule):
        return replace(equation, factor=_NOTHING, reversed=False)
    ring = textbook.ring
    after = divided(textbook, equation.coordinate, ring.from_sympy(before.xreplace(rule)))
    scale = (-1 if after.reversed else 1) / after.factor.expression
    expression = after.expression
    for a in sorted((s for s in expression.free_symbols if is_acceleration(s)), key=str):
        shares = [before.diff(a), *(before.diff(e) * value.diff(a) for e, value in rule.items() if is_acceleration(e))]
        parts = sp.Add(*(textbook.form(ring.from_sympy(s * scale)) for s in shares if s != 0))
        if parts.count_ops() < expression.diff(a).count_ops():  # each share in factors of its own
            expression = expression.xreplace({a: sp.S.Zero}) + parts * a
    return replace(after, expression=expression)


def _length(equations: Sequence[EquationOfMotion]) -> int:
    return sum(int(e.expression.count_ops()) for e in equations)
