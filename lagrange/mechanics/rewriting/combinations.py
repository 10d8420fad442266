"""How equations stated in another form follow from the equations of motion: as a sum of multiples of them.

A stated equation S = 0 is linear in the accelerations. With the equations of motion E_i = 0 and the constraints that
complete them, C_j = 0, differentiated, the multipliers follow from the coefficients of the accelerations,

    ∂S/∂q'' = Σ_i c_i ∂E_i/∂q'' + Σ_j d_j ∂C_j'/∂q'' ,

and S − Σ c_i E_i − Σ d_j C_j' has to vanish by the constraints on velocities; otherwise nothing is said.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, Surface, is_zero
from lagrange.algebra.fourier.linear_systems import solved_linear
from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.expression_size import count_operations
from lagrange.core.records import record
from lagrange.core.symbols import Unspecified, partial
from lagrange.mechanics.limits import LONGEST_COMBINED, LONGEST_MULTIPLE
from lagrange.mechanics.results import InCoordinates
from lagrange.mechanics.rewriting.quasi_velocities import StatedEquations, squares_by_constraints


@record
class Combination:
    """Multiples of the equations of motion, and of the derivatives of the completing constraints, in their order.

    with_constraints  whether the sum is the stated equation only where the constraints themselves hold
    """

    equations: tuple[sp.Expr, ...]
    constraints: tuple[sp.Expr, ...]
    with_constraints: bool = False

    @property
    def is_one(self) -> bool:
        """Whether it is one of the equations of motion, times a number."""
        used = [m for m in (*self.equations, *self.constraints) if m != 0]
        return len(used) == 1 and used[0].is_number and not any(self.constraints)


def combinations(stated: StatedEquations, view: InCoordinates) -> tuple[Combination, ...]:
    """For each stated equation; none if one of them is no short sum."""
    motion = view.motion
    if motion is None or not stated or any(len(sides) != 2 for sides in stated) or motion.closed is not None:
        return ()
    slots = view.configuration.slots
    equations = [e.expression for e in motion.equations]
    forms = [row.velocity_form(slots) if row.nonlinear is None else row.nonlinear for row in motion.completing]
    derivatives = [slots.time_derivative(f) for f in forms]
    every = [*equations, *derivatives, *(a - b for a, b in stated)]
    if sum(map(count_operations, every)) > LONGEST_COMBINED or any(e.has(Unspecified) for e in every):
        return ()
    found = [_combination(a - b, equations, derivatives, view) for a, b in stated]
    return () if any(c is None for c in found) else tuple(c for c in found if c is not None)


def _combination(
    s: sp.Expr, equations: Sequence[sp.Expr], derivatives: Sequence[sp.Expr], view: InCoordinates
) -> Combination | None:
    accelerations = view.configuration.slots.accelerations
    parts = [*equations, *derivatives]
    if len(parts) != len(accelerations):
        return None
    rows = [[partial(e, a) for e in parts] for a in accelerations]
    try:
        solved = solved_linear(rows, [partial(s, a) for a in accelerations], Surface())
    except DivisionByZeroError:
        return None
    if solved is None or any(x is None for x in solved):
        return None
    squares = squares_by_constraints(view.configuration.rows, view.configuration.slots)
    multiples = [textbook_form(_with_squares(x, squares)) for x in solved if x is not None]
    if any(count_operations(m) > LONGEST_MULTIPLE for m in multiples):
        return None
    rest = s - sp.Add(*(m * e for m, e in zip(multiples, parts, strict=True)))
    needed = is_zero(rest) is not True
    if needed and is_zero(_by_constraints(rest, view)) is not True:
        return None
    return Combination(tuple(multiples[: len(equations)]), tuple(multiples[len(equations) :]), needed)


def _with_squares(e: sp.Expr, squares: Sequence[tuple[sp.Symbol, sp.Expr]]) -> sp.Expr:
    """A quotient with the squares of velocities that constraints give, in its factors as they stand."""
    for velocity, square in squares:
        e = sp.factor(sp.cancel(sp.together(e).xreplace({velocity**2: square})))
    return e


def _by_constraints(e: sp.Expr, view: InCoordinates) -> sp.Expr:
    """An expression, or its numerator, with one velocity substituted by each constraint on velocities."""
    slots = view.configuration.slots
    for velocity, square in squares_by_constraints(view.configuration.rows, slots):
        e = sp.expand(sp.numer(sp.together(e))).xreplace({velocity**2: square})
    rules: dict[sp.Basic, sp.Basic] = {}
    for row in view.configuration.rows:
        if row.nonlinear is not None:
            continue
        form = row.velocity_form(slots).xreplace(rules)
        v = next((x for x in slots.velocities if x not in rules and partial(form, x) != 0), None)
        if v is None:
            continue
        value = -form.xreplace({v: sp.S.Zero}) / partial(form, v)
        rules = {k: w.xreplace({v: value}) for k, w in rules.items()} | {v: value}
    return e.xreplace(rules)
