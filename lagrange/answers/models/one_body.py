"""Wrong forces of constraints: those of one body by itself.

The tension of the upper rod of a double pendulum is often taken from the balance of the upper mass without the lower
rod, and that of the lower rod as of a pendulum whose support is at rest. So for one body, with its coordinates K,

    E_k = 0   (k ∈ K) ,     d²f_j/dt² = 0 ,     with λ_i = 0 for i ≠ j and q_k'' = 0 for k ∉ K ,

are solved for λ_j and compared with the stated force.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError, is_zero
from lagrange.answers.limits import LONGEST_REACTION_OF_ONE_BODY, MOST_RESTING_COORDINATES
from lagrange.answers.models.mechanics import called
from lagrange.core.symbols import prime

if TYPE_CHECKING:
    from lagrange.answers.references import Reference, ReferenceCandidate


def explained_by_one_body(equation: sp.Expr, candidate: ReferenceCandidate, reference: Reference) -> str:
    """Of which body by itself a stated force is the reaction, in a sentence; empty if of none.

    equation  which vanishes, in the coordinates of the candidate
    """
    forces = [s for s in candidate.multipliers if s in equation.free_symbols]
    full = next((c for c in reference.candidates if not c.choice and {*forces} <= {*c.multipliers}), None)
    if len(forces) != 1 or full is None or (candidate.configuration.rows and candidate.choice):
        return ""
    [force] = forces
    slope = equation.diff(force)
    if slope == 0 or not slope.free_symbols.isdisjoint({force, *candidate.configuration.slots.coordinates}):
        return ""
    stated = -equation.xreplace({force: sp.S.Zero}) / slope
    try:
        for value, said in _alone(force, full):
            alone = candidate.read(value)
            known = {*candidate.configuration.slots.coordinates, *candidate.configuration.slots.velocities}
            if sp.count_ops(alone) > LONGEST_REACTION_OF_ONE_BODY or alone.free_symbols & {*full.multipliers}:
                continue
            moving = {*full.configuration.slots.coordinates, *full.configuration.slots.velocities} - known
            if alone.free_symbols.isdisjoint(moving) and is_zero(stated - alone) is True:
                return said
    except (DivisionByZeroError, NoPointError, UnsupportedError):
        pass
    return ""


def _alone(force: sp.Symbol, full: ReferenceCandidate) -> Iterator[tuple[sp.Expr, str]]:
    """What a reaction would be for each body by itself, in the coordinates of the file, each with a sentence."""
    configuration, system, slots = full.configuration, full.system, full.configuration.slots
    number = full.multipliers.index(force)
    if len(system.equations) < len(slots.coordinates) or number >= len(configuration.rows):
        return
    row, accelerated = configuration.rows[number], system.accelerated_constraints[number]
    used = {p.name: {q for c in p.position.fixed().components for q in c.free_symbols} for p in configuration.points}
    for r in configuration.rotations:
        turning = {q for column in r.axes for c in column.fixed().components for q in c.free_symbols}
        used[r.name] = used.get(r.name, set()) | turning
    for name in used:
        others = set().union(*(u for n, u in used.items() if n != name))
        own = [k for k, q in enumerate(slots.coordinates) if q in used[name] and q not in others]
        if not any(row.coefficients[k] != 0 for k in own) or len(own) > MOST_RESTING_COORDINATES:
            continue
        accelerations = [prime(slots.coordinates[k], 2) for k in own]
        left = [system.equations[k] for k in own] + [accelerated]
        there = set().union(*(e.free_symbols for e in left))
        forgotten = [m for m in full.multipliers if m != force and m in there]
        still = [a for a in slots.accelerations if a not in accelerations and a in there]
        values = _solved(left, [*accelerations, force], [*forgotten, *still])
        if values is None or not (forgotten or still):
            continue
        if any(v != 0 for v in values[:-1]):  # otherwise the body is said to be at rest, which is simpler
            yield values[-1], _said(name, forgotten, still, full, used)


def _solved(
    equations: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol], left_out: Sequence[sp.Symbol]
) -> list[sp.Expr] | None:
    """The unknowns of linear equations in which some symbols are zero; None if they are not determined."""
    reduced = [e.xreplace(dict.fromkeys(left_out, sp.S.Zero)) for e in equations]
    matrix = sp.Matrix([[e.diff(u) for u in unknowns] for e in reduced])
    if not matrix.free_symbols.isdisjoint(unknowns):
        return None
    rest = sp.Matrix([-e.xreplace(dict.fromkeys(unknowns, sp.S.Zero)) for e in reduced])
    whole = matrix.det(method="berkowitz")
    if is_zero(whole) is not False:
        return None
    return [_with_column(matrix, k, rest).det(method="berkowitz") / whole for k in range(len(unknowns))]


def _with_column(matrix: sp.Matrix, k: int, column: sp.Matrix) -> sp.Matrix:
    changed = matrix.copy()
    changed[:, k] = column
    return changed


def _said(
    name: str,
    forgotten: Sequence[sp.Symbol],
    still: Sequence[sp.Symbol],
    full: ReferenceCandidate,
    used: dict[str, set[sp.Symbol]],
) -> str:
    rows = {m: row.name for m, row in zip(full.multipliers, full.configuration.rows, strict=False)}
    parts = []
    if still:
        slots = full.configuration.slots
        moving = {q for q in slots.coordinates if prime(q, 2) in still}
        bodies = [n for n, u in used.items() if n != name and u & moving]
        parts.append(f"as if {' and '.join(map(called, bodies)) or 'the rest'} were not accelerated")
    if forgotten:
        names = " and ".join(f"`{rows.get(m, m.name)}`" for m in forgotten)
        parts.append(f"without the reaction of {names}, which acts on it as well")
    return f"this is the reaction of {called(name)} by itself, {' and '.join(parts)}"
