"""Constraints in differential form, and the generic points at which they hold.

Each constraint imposes a linear condition on the displacements, Σ a_i dq_i + a_t dt = 0: one row of (A | a_t), shapes
A (m, n) and a_t (m,). The coordinates and their rows form one value, because every question of rank, exactness or zero
refers to places where the constraints hold: the *surface* of the finite relations f(q, t) = 0 or, where A depends on
the velocities, the *states* (q, q', t) whose velocities satisfy all rows. Off the surface the answers can be wrong:
with z = 0 the form dx + y z du is dx.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable
from functools import cached_property

import sympy as sp

from lagrange.algebra.exact.zero_test import Surface
from lagrange.core.records import record
from lagrange.core.symbols import Slots, multiplier, t


@record
class Row:
    """One constraint in the coordinates of a configuration, as a condition on displacements.

    A Pfaffian form Σ a_i dq_i + a_t dt = 0 has a_i and a_t that depend on q and t. Where a constraint φ(q, q', t) = 0
    is not linear in the velocities, a_i = ∂φ/∂q_i' depend on them too, Σ a_i δq_i = 0 is Chetaev's rule, and

        a_t = φ − Σ a_i q_i'        so that Σ a_i q_i' + a_t = φ, as in a Pfaffian form.

    coefficients  shape (n,)
    drift         a_t
    finite        f(q, t), if the constraint is the finite relation f = 0; None for a constraint on velocities
    nonlinear     φ, if it is not linear in the velocities
    """

    name: str
    coefficients: tuple[sp.Expr, ...]
    drift: sp.Expr
    finite: sp.Expr | None = None
    nonlinear: sp.Expr | None = None

    @classmethod
    def by_chetaev(cls, name: str, function: sp.Expr, slots: Slots) -> Row:
        """The row of a constraint φ(q, q', t) = 0 that is not linear in the velocities."""
        coefficients = tuple(function.diff(v) for v in slots.velocities)
        powers = (a * v for a, v in zip(coefficients, slots.velocities, strict=True))
        return cls(name, coefficients, sp.Add(function, *(-p for p in powers)), nonlinear=function)

    @property
    def form(self) -> tuple[sp.Expr, ...]:
        """The coefficients of all differentials, including dt, shape (n + 1,)."""
        return (*self.coefficients, self.drift)

    def moves_with(self, slots: Slots) -> sp.Symbol | None:
        """A parameter that may be zero, and without which it would contain no time: the velocity u of a surface."""
        parts = self.form if self.finite is None else (*self.form, self.finite)
        moving = {*slots.coordinates, *slots.velocities, *slots.prescribed, t}
        for p in sorted((s for s in self.drift.free_symbols - moving if s.is_zero is None), key=str):
            resting = [e.xreplace({p: sp.S.Zero}) for e in (self.drift, *parts)]
            if resting[0] == 0 and not any(t in e.free_symbols for e in resting):
                return p
        return None

    @property
    def multiplier(self) -> sp.Symbol:
        """λ with the constraint's name as index, C_x for the component C.x."""
        return multiplier(self.name.replace(".", "_"))

    @property
    def is_identity(self) -> bool:
        """Whether it is written 0 = 0."""
        return self.drift == 0 and all(a == 0 for a in self.coefficients)

    def velocity_form(self, slots: Slots) -> sp.Expr:
        """Σ a_i q_i' + a_t, or φ."""
        if self.nonlinear is not None:
            return self.nonlinear
        terms = (a * v for a, v in zip(self.coefficients, slots.velocities, strict=True))
        return sp.Add(*terms, self.drift)


def is_pfaffian(rows: Iterable[Row]) -> bool:
    """Whether all constraints are linear in the velocities."""
    return all(r.nonlinear is None for r in rows)


@record
class ConstrainedSystem:
    """Coordinates and the constraints between them.

    slots  the coordinates, their velocities and accelerations, the prescribed motions
    rows   the constraints that these coordinates still have to satisfy
    """

    slots: Slots
    rows: tuple[Row, ...]

    @property
    def size(self) -> int:
        """The number of coordinates, n."""
        return len(self.slots.coordinates)

    @property
    def finite_constraints(self) -> tuple[sp.Expr, ...]:
        """The finite relations f(q, t) = 0 among the rows."""
        return tuple(r.finite for r in self.rows if r.finite is not None)

    @property
    def geometric(self) -> tuple[Row, ...]:
        """The rows that are finite relations."""
        return tuple(r for r in self.rows if r.finite is not None)

    @property
    def is_pfaffian(self) -> bool:
        """Whether all constraints are linear in the velocities."""
        return is_pfaffian(self.rows)

    @cached_property
    def surface(self) -> Surface:
        """The generic points where the finite relations hold."""
        return Surface(self.finite_constraints, self.slots.coordinates)

    @cached_property
    def admitted_states(self) -> Surface:
        """The generic points (q, q', t) where the finite relations hold and the velocities satisfy all rows."""
        relations = (*self.finite_constraints, *(r.velocity_form(self.slots) for r in self.rows))
        return Surface(relations, (*self.slots.coordinates, *self.slots.velocities))

    @cached_property
    def states(self) -> Surface:
        """Where the forms have their ranks: the surface, or the admitted states where forms depend on velocities."""
        return self.surface if self.is_pfaffian else self.admitted_states

    @cached_property
    def rank(self) -> int | None:
        """The rank of A at generic states; None if undecided."""
        return self.states.rank([r.coefficients for r in self.rows]) if self.rows else 0

    @cached_property
    def accelerated_constraints(self) -> tuple[sp.Expr, ...]:
        """d/dt of the velocity form of each row."""
        return tuple(self.slots.time_derivative(r.velocity_form(self.slots)) for r in self.rows)

    def with_rows(self, rows: Iterable[Row]) -> ConstrainedSystem:
        """The same coordinates under other constraints."""
        new = tuple(rows)
        return self if new == self.rows else ConstrainedSystem(self.slots, new)

    def without(self, names: Collection[str]) -> ConstrainedSystem:
        """The system without the constraints of these names."""
        return self.with_rows(r for r in self.rows if r.name not in names)
