"""Accelerations and reactions at one state, in numbers, where they would be too long in symbols.

With the coefficients E of d'Alembert's principle at the state, and d/dt (a·q' + a_t) = a·q'' + c,

    M q'' + E_0 = Σ λ a ,        a·q'' = −c

are linear equations for q'' and λ. Lagrange's equations, with the derivatives of T at the same state, check them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import solution
from lagrange.algebra.exact.prime_field import InadmissibleError, ZeroDivisorError
from lagrange.algebra.forms.jets import NoExpansionError, WorkLimitError
from lagrange.core.diagnostics import ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import t
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.nearby.checks import lagrange_in_numbers
from lagrange.mechanics.nearby.expansions import Expansions
from lagrange.mechanics.nearby.limits import CHECKED_REMAINDER, SHOWN_DIGITS
from lagrange.mechanics.nearby.linear_equations import first_order
from lagrange.mechanics.nearby.reference import ReferenceState, reference
from lagrange.problem.model import Problem

NOT_POSSIBLE = (ProblemError, NoExpansionError, WorkLimitError, ZeroDivisorError, InadmissibleError)
"""What is raised where a state does not exist, or an expression has no derivatives there."""


@record
class StateInNumbers:
    """What happens at one state.

    state          coordinates and velocities, by symbol
    accelerations  by symbol
    multipliers    by name of the constraint; without those of redundant ones
    agrees         whether Lagrange's equations hold with these
    """

    state: Mapping[sp.Symbol, sp.Expr]
    accelerations: Mapping[sp.Symbol, sp.Expr]
    multipliers: Mapping[str, sp.Expr]
    agrees: bool


def at_state(configuration: Configuration, near: ReferenceState) -> StateInNumbers | None:
    """Accelerations and multipliers at a state; None where they are not determined. Raises NotCoveredError."""
    slots = configuration.slots
    rows = [configuration.rows[k] for k in near.used]
    in_rows = {s for row in rows for a in (*row.coefficients, row.drift) for s in a.free_symbols}
    if t in in_rows or configuration.variable_masses or not configuration.constrained.is_pfaffian:
        return None
    about = Expansions(slots, near.values)
    n, zero = about.size, about.reals.number(0)
    linear = first_order(configuration, about, [about.number(v) for v in slots.velocities])
    forms = [linear.rows[k] for k in near.used]
    table = [[*linear.mass[k], *(-form[k] for form in forms)] for k in range(n)]
    table += [[*form, *(zero for _ in forms)] for form in forms]
    right = [-e for e in linear.balance] + [-linear.misfit[k] for k in near.used]
    accelerations = solution(about.reals, table, right)
    other = solution(about.reals, table, right, [about.reals.number(1)] * len(table))
    if accelerations is None or other is None or accelerations != other:  # what stays free would differ
        return None
    left = lagrange_in_numbers(configuration, about, [about.number(v) for v in slots.velocities], accelerations[:n])
    loads = [sum((m * form[k] for m, form in zip(accelerations[n:], forms, strict=True)), zero) for k in range(n)]
    scale = max([1, *map(abs, (*left, *loads))])
    agrees = all(abs(a - b) < CHECKED_REMAINDER * scale for a, b in zip(left, loads, strict=True))
    names = [row.name for row in rows]
    return StateInNumbers(
        {s: near.values[s] for s in (*slots.coordinates, *slots.velocities)},
        {s: shown_number(x) for s, x in zip(slots.accelerations, accelerations[:n], strict=True)},
        {name: shown_number(x) for name, x in zip(names, accelerations[n:], strict=True)},
        agrees,
    )


def has_numbers(problem: Problem) -> bool:
    """Whether all parameters have values, and no function is left open."""
    return all(p.value is not None for p in problem.parameters) and not problem.functions


def start_in_numbers(problem: Problem, configuration: Configuration) -> StateInNumbers | None:
    """What happens at t = 0; None where parameters have no value, or `initial` does not determine the state."""
    if not problem.initial or not has_numbers(problem):
        return None
    slots = configuration.slots
    parameters = {p.symbol: p.value for p in problem.parameters if p.value is not None}
    known = {*slots.coordinates, *slots.velocities}
    stated = {i.symbol: i.value for i in problem.initial if i.symbol in known}
    try:
        near = reference(configuration, stated, parameters)
        left_open = [slots.coordinates[k] for k in near.placed if slots.coordinates[k] not in stated]
        left_open += [slots.velocities[k] for k in near.independent if slots.velocities[k] not in stated]
        return None if left_open else at_state(configuration, near)
    except NOT_POSSIBLE:
        return None


def check_state(state: StateInNumbers, what: str) -> Check:
    """Lagrange's equations at the state, with the derivatives of T in numbers."""
    return Check(f"the {what} in numbers satisfy Lagrange's equations", state.agrees, "in numbers: T differentiated")


def shown_number(x: Any) -> sp.Expr:
    """A number with as many digits as are shown; one that is a remainder of rounding is zero."""
    return sp.S.Zero if abs(x) < CHECKED_REMAINDER else sp.Float(x, SHOWN_DIGITS)
