"""Equations of motion as equations of the first order, still in symbols.

In coordinates q, which may be bound by constraints, y = (q, q') and

    M q'' − Aᵀ λ = f ,     A q'' = b .

The constraints are differentiated until accelerations occur, so that a motion satisfies them if its beginning does, up
to what an integration loses. With `stabilised` α, for a finite relation g = 0 and for a constraint φ = 0 on velocities,

    A q'' = b − 2α dg/dt − α² g ,     A q'' = b − α φ :

what is lost dies out like exp(−α t). Reference: J. Baumgarte, Stabilization of constraints and
integrals of motion (1972).

In quasi-velocities y = (q, u), with q' = B u + b and the equations of motion for u'; constraints on velocities hold by
themselves.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Slots, prime
from lagrange.mechanics.constraints.kinematics import Row
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations


@record
class FirstOrder:
    """What is integrated.

    slots        what moves
    speeds       q', or quasi-velocities, shape (p,)
    rates        q' in q, the speeds and t, shape (n,)
    unknowns     the rates of the speeds, then the multipliers, shape (p + m,)
    matrix       shape (p + m, p + m)
    right        shape (p + m,): matrix · unknowns = right
    constraints  what vanishes along the motion: g and dg/dt of finite relations, φ of other constraints
    """

    slots: Slots
    speeds: tuple[sp.Symbol, ...]
    rates: tuple[sp.Expr, ...]
    unknowns: tuple[sp.Symbol, ...]
    matrix: tuple[tuple[sp.Expr, ...], ...]
    right: tuple[sp.Expr, ...]
    constraints: tuple[sp.Expr, ...]

    @property
    def state(self) -> tuple[sp.Symbol, ...]:
        """The components of y, shape (n + p,)."""
        return (*self.slots.coordinates, *self.speeds)


def in_coordinates(motion: Motion, stabilised: float = 0) -> FirstOrder:
    """The equations in coordinates and velocities; constraints that follow from others are left out."""
    form = motion.matrices
    slots, rows = form.configuration.slots, form.configuration.rows
    used = [n for n in range(len(rows)) if n not in motion.equations.elimination.unused]
    zeros = (sp.S.Zero,) * len(used)
    upper = [
        (*mass, *(-form.constraint_matrix[n][k] for n in used)) for k, mass in enumerate(form.mass)
    ]  # M q'' − Aᵀ λ
    lower = [(*form.constraint_matrix[n], *zeros) for n in used]
    bound = [form.constraint_vector[n] - _pull(rows[n], slots, stabilised) for n in used]
    return FirstOrder(
        slots=slots,
        speeds=slots.velocities,
        rates=slots.velocities,
        unknowns=(*slots.accelerations, *(motion.multipliers[rows[n].name] for n in used)),
        matrix=(*upper, *lower),
        right=(*form.force, *bound),
        constraints=tuple(_conditions(rows, slots)),
    )


def _pull(row: Row, slots: Slots, stabilised: float) -> sp.Expr:
    """2α dg/dt + α² g, or α φ."""
    if not stabilised:
        return sp.S.Zero
    rate = row.velocity_form(slots)
    return stabilised * rate if row.finite is None else 2 * stabilised * rate + stabilised**2 * row.finite


def _conditions(rows: Sequence[Row], slots: Slots) -> list[sp.Expr]:
    return [e for r in rows for e in (r.finite, r.velocity_form(slots)) if e is not None]


def in_speeds(equations: QuasiEquations) -> FirstOrder:
    """The equations in coordinates and quasi-velocities."""
    quasi = equations.quasi
    slots = quasi.configuration.slots
    unknowns = tuple(prime(s) for s in quasi.symbols)
    at_rest = dict.fromkeys(unknowns, sp.S.Zero)
    return FirstOrder(
        slots=slots,
        speeds=quasi.symbols,
        rates=tuple(quasi.shown(quasi.rates[v]) for v in slots.velocities),
        unknowns=unknowns,
        matrix=tuple(tuple(e.diff(a) for a in unknowns) for e in equations.expressions),
        right=tuple(-e.xreplace(at_rest) for e in equations.expressions),
        constraints=quasi.configuration.finite_constraints,
    )
