"""The state about which a motion is linearized: what `initial` says, and what follows from it by the constraints.

Coordinates that `initial` omits are found from the finite relations by Newton's iteration, which starts at zero;
velocities from A q' + a_t = 0, which must determine them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from lagrange.algebra.exact.limits import NEWTON_STEPS
from lagrange.algebra.exact.linear_algebra import row_reduced, solution
from lagrange.algebra.exact.points_needed import REAL_DIGITS, ZERO_DIGITS
from lagrange.core.diagnostics import Diagnostic, ProblemError
from lagrange.core.records import record
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.nearby.expansions import Expansions, Numbers

CoefficientTable = Sequence[Sequence[Any]]


@record
class ReferenceState:
    """A state in numbers, and which coordinates stand for the others in its neighbourhood.

    values       of parameters, coordinates and velocities
    independent  by index: the coordinates whose velocities are independent; those that `initial` gives come first
    placed       by index: the coordinates that the finite relations leave independent
    used         by index: the rows of constraints that are independent
    """

    values: Numbers
    independent: tuple[int, ...]
    placed: tuple[int, ...]
    used: tuple[int, ...]


def reference(
    configuration: Configuration,
    stated: Mapping[sp.Symbol, sp.Expr],
    parameters: Numbers,
    start: Mapping[sp.Symbol, sp.Expr] | None = None,
) -> ReferenceState:
    """The state that `initial` and the constraints determine. Raises ProblemError where they do not.

    start  where the iteration begins, for coordinates that are not stated; 0 by default
    """
    slots = configuration.slots
    size = len(slots.coordinates)
    values: dict[sp.Symbol, sp.Expr] = dict(parameters)
    for s in (*slots.coordinates, *slots.velocities):
        values[s] = stated.get(s, (start or {}).get(s, sp.S.Zero)).xreplace(parameters)
    loose = [k for k, q in enumerate(slots.coordinates) if q not in stated]
    gradients = _placed(configuration, values, loose)
    about = Expansions(slots, values)
    rows = [[about.value(a) for a in row.coefficients] for row in configuration.rows]
    drifts = [about.value(row.drift) for row in configuration.rows]
    # Columns to be solved for come first: velocities that nothing is said of, of coordinates that nothing is said of.
    order = sorted(range(size), key=lambda k: (slots.velocities[k] in stated, slots.coordinates[k] in stated, k))
    dependent = _columns(about, rows, order)
    used = _columns(about, [list(c) for c in zip(*rows, strict=True)], range(len(rows))) if rows else ()
    independent = tuple(k for k in range(size) if k not in dependent)
    missing = [k for k in independent if slots.velocities[k] not in stated]
    if missing and any(slots.velocities[k] in stated for k in range(size)):
        names = " and ".join(f"`{slots.velocities[k].name}`" for k in missing)
        raise ProblemError(
            Diagnostic(
                "undetermined-motion",
                f"`initial` and the constraints do not determine {names}",
                help=f"give as many velocities as there are degrees of freedom, {len(independent)}: `initial: "
                f"{{{slots.velocities[missing[0]].name}: 0, ...}}`",
            )
        )
    known = [about.number(values[v]) for v in slots.velocities]
    right = [
        -d - sum(a * v for k, (a, v) in enumerate(zip(row, known, strict=True)) if k not in dependent)
        for row, d in zip(rows, drifts, strict=True)
    ]
    solved = solution(about.reals, [[row[k] for k in dependent] for row in rows], right) if dependent else []
    if solved is None:
        raise _contradicted()
    for k, v in zip(dependent, solved, strict=True):
        if slots.velocities[k] in stated and abs(v - known[k]) > sp.Float(10) ** -ZERO_DIGITS:
            raise _contradicted()
        values[slots.velocities[k]] = sp.Float(v, REAL_DIGITS + 5)
    bound = _columns(about, gradients, [*loose, *(k for k in range(size) if k not in loose)]) if gradients else ()
    return ReferenceState(values, independent, tuple(k for k in range(size) if k not in bound), used)


def _columns(about: Expansions, rows: CoefficientTable, order: Sequence[int]) -> tuple[int, ...]:
    """Independent columns, the first ones in an order preferred."""
    return tuple(order[k] for k in row_reduced(about.reals, [[row[k] for k in order] for row in rows])[1])


def _placed(configuration: Configuration, values: dict[sp.Symbol, sp.Expr], loose: Sequence[int]) -> list[list[Any]]:
    """Moves the loose coordinates onto the finite relations; returns the gradients of these, shape (m, n)."""
    slots = configuration.slots
    finite = configuration.finite_constraints
    if not finite:
        return []
    for _ in range(NEWTON_STEPS):
        about = Expansions(slots, values)
        jets = [about.jet(f, 1) for f in finite]
        gradients = [about.gradient(jet) for jet in jets]
        off = [about.at_state(jet) for jet in jets]
        if max(map(abs, off)) < about.reals.number(1, 10 ** (REAL_DIGITS - 8)):
            return gradients
        moved = [[row[k] for k in loose] for row in gradients]
        normal = [[sum(a * b for a, b in zip(r, s, strict=True)) for s in moved] for r in moved]
        y = solution(about.reals, normal, off)
        if y is None or not loose:
            break
        for column, k in enumerate(loose):
            step = sum(row[column] * f for row, f in zip(moved, y, strict=True))
            place = about.number(values[slots.coordinates[k]]) - step
            values[slots.coordinates[k]] = sp.Float(place, REAL_DIGITS + 5)
    raise _contradicted()


def _contradicted() -> ProblemError:
    return ProblemError(
        Diagnostic(
            "initial-off-constraints",
            "no state near the one that `initial` gives satisfies the constraints",
            help="correct `initial`, or leave out the coordinates and velocities that follow from the others",
        )
    )
