"""First-order equations in symbols: M s' − Aᵀ λ = f, A s' = b, and q' as a function of q, s and t.

In independent coordinates, and in quasi-velocities, there is no A. `state_equations.py` adds what is calculated along
the motion.
"""

from __future__ import annotations

from functools import cached_property

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Slots, partial, prime
from lagrange.mechanics.dynamics.motion import Motion
from lagrange.mechanics.dynamics.quasi_equations import QuasiEquations


@record
class FirstOrderEquations:
    """First-order equations, in symbols.

    slots        the coordinates, and the prescribed motions u(t)
    speeds       s: velocities or quasi-velocities, shape (p,)
    rates        q' in q, s and t, shape (n,)
    mass         M; in quasi-velocities each row is divided by a common factor, so that M need not be symmetric
    force        f
    constraint_matrix  A, without rows that follow from others
    bias         b
    multipliers  λ, shape (m,)
    finite       g of the finite relations g = 0
    velocity_forms     A s + a_t of each row, zero along the motion; empty in quasi-velocities. A constraint that is not
                 linear in the velocities is φ = 0, with A = ∂φ/∂s
    """

    slots: Slots
    speeds: tuple[sp.Symbol, ...]
    rates: tuple[sp.Expr, ...]
    mass: tuple[tuple[sp.Expr, ...], ...]
    force: tuple[sp.Expr, ...]
    constraint_matrix: tuple[tuple[sp.Expr, ...], ...] = ()
    bias: tuple[sp.Expr, ...] = ()
    multipliers: tuple[sp.Symbol, ...] = ()
    finite: tuple[sp.Expr, ...] = ()
    velocity_forms: tuple[sp.Expr, ...] = ()

    @property
    def state(self) -> tuple[sp.Symbol, ...]:
        """The components of y, shape (n + p,)."""
        return (*self.slots.coordinates, *self.speeds)

    @property
    def speed_rates(self) -> tuple[sp.Symbol, ...]:
        """s', shape (p,)."""
        return tuple(prime(s) for s in self.speeds)

    @property
    def unknowns(self) -> tuple[sp.Symbol, ...]:
        """What the linear equations determine: s', then λ, shape (p + m,)."""
        return (*self.speed_rates, *self.multipliers)

    @property
    def matrix(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The rows M, −Aᵀ and A, 0 of the linear equations, shape (p + m, p + m)."""
        a = self.constraint_matrix
        upper = [(*row, *(-each[k] for each in a)) for k, row in enumerate(self.mass)]
        return (*upper, *((*row, *(sp.S.Zero for _ in a)) for row in a))

    @property
    def right(self) -> tuple[sp.Expr, ...]:
        """Their right sides f, b, shape (p + m,)."""
        return (*self.force, *self.bias)

    @cached_property
    def finite_slopes(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """∂g/∂q of each finite relation, with which positions are brought back to it."""
        return tuple(tuple(partial(g, q) for q in self.slots.coordinates) for g in self.finite)

    @property
    def kept(self) -> tuple[sp.Expr, ...]:
        """All that vanishes along the motion: finite relations, then constraints on speeds."""
        return (*self.finite, *self.velocity_forms)


def in_coordinates(dynamics: Motion) -> FirstOrderEquations:
    """The equations in coordinates and velocities."""
    form = dynamics.matrices
    slots, rows = form.configuration.slots, form.configuration.rows
    used = [n for n in range(len(rows)) if n not in dynamics.equations.elimination.unused]
    return FirstOrderEquations(
        slots=slots,
        speeds=slots.velocities,
        rates=slots.velocities,
        mass=form.mass,
        force=form.force,
        constraint_matrix=tuple(form.constraint_matrix[n] for n in used),
        bias=tuple(form.constraint_vector[n] for n in used),
        multipliers=tuple(dynamics.multipliers[rows[n].name] for n in used),
        finite=tuple(rows[n].finite for n in used if rows[n].finite is not None),
        velocity_forms=tuple(rows[n].velocity_form(slots) for n in used),
    )


def in_speeds(equations: QuasiEquations) -> FirstOrderEquations:
    """The equations in coordinates and quasi-velocities, which satisfy the constraints on velocities identically."""
    quasi = equations.quasi
    slots = quasi.configuration.slots
    unknowns = tuple(prime(s) for s in quasi.symbols)
    at_rest = dict.fromkeys(unknowns, sp.S.Zero)
    return FirstOrderEquations(
        slots=slots,
        speeds=quasi.symbols,
        rates=tuple(quasi.shown(quasi.rates[v]) for v in slots.velocities),
        mass=tuple(tuple(e.diff(a) for a in unknowns) for e in equations.expressions),
        force=tuple(-e.xreplace(at_rest) for e in equations.expressions),
        finite=quasi.configuration.finite_constraints,
    )
