"""Vectors as components in an orthonormal triad: the fixed i, j, k, or one that turns.

A triad is given by its directions (rows: the unit vectors in i, j, k) and by its angular velocity ω = Σ ω_k q_k',
linear in the velocities, in its own components. With it

    ∂a/∂q_k = (∂a_n/∂q_k) e_n + ω_k × a ,      da/dt = (da_n/dt) e_n + ω × a ,

so that vectors in a turning triad stay as short as on paper: a = (r'' - r φ'^2) e_r + (r φ'' + 2 r' φ') e_phi.
Two vectors of one triad are combined there; a fixed one and a turning one meet in the turning triad for a dot
product, and in the fixed one for a sum.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import sympy as sp

from lagrange.core.records import record
from lagrange.core.symbols import Slots, UnitVector, derivative, partial, prime, t

Components = tuple[sp.Expr, sp.Expr, sp.Expr]


@record
class Triad:
    """Three orthonormal right-handed unit vectors.

    names       of e_1, e_2, e_3
    directions  shape (3, 3); row n is e_n in i, j, k; None for the fixed triad itself
    turning     pairs (q_k, ω_k): the angular velocity is Σ ω_k q_k', each ω_k in components of this triad; q_k may
                be t, for a triad that is driven
    """

    names: tuple[str, str, str]
    directions: sp.ImmutableMatrix | None = None
    turning: tuple[tuple[sp.Symbol, Components], ...] = ()

    @property
    def units(self) -> tuple[UnitVector, UnitVector, UnitVector]:
        """The unit vectors as symbols."""
        a, b, c = (UnitVector(n) for n in self.names)
        return a, b, c


FIXED = Triad(("i", "j", "k"))
"""The triad that does not turn."""

UNITS = {unit.name: unit for unit in FIXED.units}
"""i, j, k as symbols, by name."""


@record
class Vector:
    """Components in a triad."""

    components: Components
    triad: Triad = FIXED

    @classmethod
    def zero(cls, triad: Triad = FIXED) -> Vector:
        """The vector 0."""
        return cls((sp.S.Zero, sp.S.Zero, sp.S.Zero), triad)

    @property
    def is_zero(self) -> bool:
        """Whether all components are written as 0."""
        return all(c == 0 for c in self.components)

    def __add__(self, other: Vector) -> Vector:
        if other.is_zero:
            return self
        if self.is_zero:
            return other
        a, b = (self, other) if self.triad == other.triad else (self.fixed(), other.fixed())
        return Vector(_three(x + y for x, y in zip(a.components, b.components, strict=True)), a.triad)

    def __neg__(self) -> Vector:
        return self.map(lambda c: -c)

    def __sub__(self, other: Vector) -> Vector:
        return self + (-other)

    def __mul__(self, factor: sp.Expr) -> Vector:
        return self.map(lambda c: factor * c)

    __rmul__ = __mul__

    def __truediv__(self, divisor: sp.Expr) -> Vector:
        return self.map(lambda c: c / divisor)

    def map(self, function: Callable[[sp.Expr], sp.Expr]) -> Vector:
        """The vector with `function` applied to each component."""
        return Vector(_three(function(c) for c in self.components), self.triad)

    def fixed(self) -> Vector:
        """The same vector in i, j, k."""
        if self.triad.directions is None:
            return Vector(self.components, FIXED)
        rows = self.triad.directions
        return Vector(_three(sum((c * rows[n, m] for n, c in enumerate(self.components)), sp.S.Zero) for m in range(3)))

    def along(self, triad: Triad) -> Vector:
        """The same vector in components of another triad."""
        if triad == self.triad:
            return self
        inertial = self.fixed()
        if triad.directions is None:
            return inertial
        rows = triad.directions
        parts = (sum((rows[n, m] * inertial.components[m] for m in range(3)), sp.S.Zero) for n in range(3))
        return Vector(_three(parts), triad)

    def dot(self, other: Vector) -> sp.Expr:
        """The scalar product."""
        a, b = _common(self, other)
        return sp.Add(*(x * y for x, y in zip(a.components, b.components, strict=True)))

    def cross(self, other: Vector) -> Vector:
        """The vector product."""
        a, b = _common(self, other)
        return Vector(_cross(a.components, b.components), a.triad)

    def norm(self) -> sp.Expr:
        """The length, sqrt(a·a)."""
        return sp.sqrt(self.dot(self))

    def partial(self, symbol: sp.Symbol) -> Vector:
        """The partial derivative by a coordinate: the components change, and the triad turns."""
        changed = self.map(lambda c: partial(c, symbol))
        for q, w in self.triad.turning:
            if q == symbol:
                changed = changed + Vector(_cross(w, self.components), self.triad)
        return changed

    def time_derivative(self, slots: Slots) -> Vector:
        """The total time derivative."""
        return self._derivative(slots.time_derivative, {*slots.coordinates, *slots.prescribed, t})

    def frozen_derivative(self, slots: Slots) -> Vector:
        """∂/∂t with configuration and velocities frozen."""
        return self._derivative(slots.frozen_derivative, {*slots.prescribed, t})

    def _derivative(self, scalar: Callable[[sp.Expr], sp.Expr], moving: set[sp.Symbol]) -> Vector:
        changed = self.map(scalar)
        for q, w in self.triad.turning:
            if q in moving:
                rate = sp.S.One if q == t else prime(q)
                changed = changed + Vector(_cross(w, self.components), self.triad) * rate
        return changed

    def change(self, rate: Callable[[sp.Symbol], sp.Expr]) -> Vector:
        """Its change where every symbol changes by `rate`: Σ (∂a_n/∂s) rate(s) e_n + Σ rate(q_k) ω_k × a."""
        changed = self.map(lambda c: derivative(c, rate))
        for q, w in self.triad.turning:
            if rate(q) != 0:
                changed = changed + Vector(_cross(w, self.components), self.triad) * rate(q)
        return changed

    def xreplace(self, rule: dict[sp.Basic, sp.Basic]) -> Vector:
        """The vector with symbols replaced, in i, j, k if its triad is changed by that."""
        if self.triad.directions is None or not (self.triad.directions.free_symbols & set(rule)):
            return self.map(lambda c: c.xreplace(rule))
        return self.fixed().map(lambda c: c.xreplace(rule))

    def as_sum(self) -> sp.Expr:
        """Σ component · unit vector, for printing."""
        return sp.Add(*(c * e for c, e in zip(self.components, self.triad.units, strict=True)))


def _three(parts: Iterable[sp.Expr]) -> Components:
    a, b, c = parts
    return a, b, c


def _cross(a: Components, b: Components) -> Components:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _common(a: Vector, b: Vector) -> tuple[Vector, Vector]:
    """Both in one triad: the turning one, if the other is fixed."""
    if a.triad == b.triad:
        return a, b
    if a.triad.directions is None:
        return a.along(b.triad), b
    if b.triad.directions is None:
        return a, b.along(a.triad)
    return a.fixed(), b.fixed()
