"""A wrong equation of motion with a force of a constraint that belongs to another situation: N = m g cos(α) on a wedge.

In the coordinates of the file the equations are E_k = Σ_j λ_j a_jk. Who writes M X'' = −N sin α with N = m g cos α, as
if nothing were accelerated, and takes friction to be absent, has a combination of these with

    λ_j = λ_j⁰   from   E_k = Σ_j λ_j a_jk   with q'' = q' = 0 ,      or λ_j = 0 ,

without the constraints themselves, which with these forces cannot be satisfied. That is tested at random states: is the
row of the equation in the space of the E_k with these numbers for λ_j?
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import RowSpace
from lagrange.algebra.exact.zero_test import DivisionByZeroError, InadmissibleError, NoPointError, UnsupportedError
from lagrange.answers.limits import MOST_TAKEN_FORCES
from lagrange.answers.models.mechanics import called
from lagrange.answers.models.states import ModelState
from lagrange.answers.references import Reference, ReferenceCandidate
from lagrange.core.symbols import base
from lagrange.document.math_writer import text


def with_taken_forces(equation: sp.Expr, reference: Reference) -> str:
    """With which forces of constraints an equation would be right, in a sentence; empty if with none.

    equation  which vanishes, in coordinates of the file or of a choice that the file has as well
    """
    for c in reference.candidates:
        if c.choice or not c.configuration.rows or len(c.multipliers) < len(c.configuration.rows):
            continue
        slots = c.configuration.slots
        known = {*slots.coordinates, *slots.prescribed}
        others = reference.moving - {q.name for q in known}
        if {base(s).name for s in equation.free_symbols} & others or not equation.free_symbols & {*slots.accelerations}:
            continue
        try:
            states = c.models.states([equation])
            for said, values in _taken(c):
                if all(follows_with_forces(equation, values, at) for at in states):
                    return said
        except (NoPointError, UnsupportedError, DivisionByZeroError, InadmissibleError):
            continue
    return ""


def _taken(c: ReferenceCandidate) -> Iterator[tuple[str, dict[sp.Symbol, sp.Expr]]]:
    """Values of the forces of constraints: each as at rest or zero, not all zero."""
    rows = c.configuration.rows
    own = [(row, force) for row, force in zip(rows, c.multipliers, strict=False)]
    if len(own) > MOST_TAKEN_FORCES:
        return
    still = dict.fromkeys((*c.configuration.slots.accelerations, *c.configuration.slots.velocities), sp.S.Zero)
    at_rest = {}
    for _, force in own:
        alone = [e.xreplace(still) for e in c.system.equations]
        fixing = [e for e in alone if force in e.free_symbols and e.free_symbols.isdisjoint({*c.multipliers} - {force})]
        found = {
            sp.expand(-e.xreplace({force: sp.S.Zero}) / e.diff(force)) for e in fixing if not e.diff(force).has(force)
        }
        at_rest[force] = found.pop() if len(found) == 1 else None
    options = [(force, [v for v in (at_rest[force], sp.S.Zero) if v is not None]) for _, force in own]
    for values in product(*(several for _, several in options)):
        if all(v == 0 for v in values):
            continue
        taken = {force: value for (force, _), value in zip(options, values, strict=True)}
        parts = []
        for row, force in own:
            what = f"the reaction of {called(row.name)}"
            parts.append(
                f"{what} left out" if taken[force] == 0 else f"{what} taken as at rest, {text(abs_of(taken[force]))}"
            )
        yield f"it is right with {' and '.join(parts)}, but that force depends on the accelerations", taken


def abs_of(value: sp.Expr) -> sp.Expr:
    """The same without a leading minus sign: the size of a force is meant."""
    return -value if value.could_extract_minus_sign() else value


def follows_with_forces(equation: sp.Expr, values: dict[sp.Symbol, sp.Expr], at: ModelState) -> bool:
    """Whether an equation follows from the E_k with these forces, at one state, and needs them."""
    row = at.row(equation)
    if row is None:
        return False
    columns = [at.unknowns.index(force) for force in values]
    numbers = [at.point.value(v) for v in values.values()]
    rows = [_put_in(r, columns, numbers, at) for r in at.derived]
    free = [_put_in(r, columns, [at.point.number(0)] * len(columns), at) for r in at.derived]
    arithmetic = at.point.arithmetic
    return row in RowSpace(arithmetic, rows) and row not in RowSpace(arithmetic, free)


def _put_in(row: Sequence[Any], columns: Sequence[int], numbers: Sequence[Any], at: ModelState) -> list[Any]:
    """A row with numbers for some unknowns."""
    changed = [*row]
    for j, number in zip(columns, numbers, strict=True):
        changed[-1] = at.point.arithmetic.reduce(changed[-1] + changed[j] * number)
        changed[j] = at.point.number(0)
    return changed
