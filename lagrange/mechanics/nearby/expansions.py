"""A system about one state, as Taylor series in small changes of q and q', with numbers of eighty digits.

With ξ and η the small changes of q and q', the positions of mass centres and the axes of bodies are expanded to third
order in ξ, forces and the forms of constraints to first or second order in ξ and η. Nothing is multiplied out or
differentiated in symbols, so that the effort grows with the length of the file, and not with that of the equations of
motion, which for a bicycle fill fifty pages.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random
from typing import Any

import sympy as sp

from lagrange.algebra.exact.points_needed import REAL_DIGITS
from lagrange.algebra.exact.real_points import Reals, symmetric_eigensystem
from lagrange.algebra.forms.jets import BITS, Expansion, Jet, JetRing, constant_term
from lagrange.core.symbols import Slots, t
from lagrange.core.vectors import Vector
from lagrange.mechanics.nearby.limits import ROUNDED_TO_ZERO

Numbers = Mapping[sp.Symbol, sp.Expr]


class RoundedReals(Reals):
    """Real numbers of eighty digits, of which fifty-five are used: what is smaller counts as zero."""

    def vanishes(self, x: Any) -> bool:
        """Whether x is 0."""
        return bool(abs(x) < ROUNDED_TO_ZERO)

    def principal_axes(self, matrix: Sequence[Sequence[Any]]) -> tuple[list[Any], list[list[Any]]]:
        """The principal values of a symmetric matrix (3, 3), and their axes, right-handed, as rows."""
        values, columns = symmetric_eigensystem([list(row) for row in matrix])
        axes = [[columns[i, k] for i in range(3)] for k in range(3)]
        a, b, c = axes
        cross = [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]
        if sum(x * y for x, y in zip(cross, c, strict=True)) < 0:
            axes[2] = [-x for x in c]
        return [values[k] for k in range(3)], axes


class Expansions:
    """Expansions about the state `values`, which has numbers for parameters, coordinates and velocities.

    Variable k is the change of coordinate k, variable n + k that of its velocity.
    """

    def __init__(self, slots: Slots, values: Numbers) -> None:
        self.reals = RoundedReals(Random(0))
        self.ring = JetRing(self.reals)
        self.size = len(slots.coordinates)
        self._values = {**values, t: sp.S.Zero}
        self._symbols = (*slots.coordinates, *slots.velocities)
        self._known: dict[tuple[int, bool], Expansion] = {}
        self._numbers: dict[sp.Expr, Any] = {}

    def number(self, e: sp.Expr) -> Any:
        """The value of a short expression at the state."""
        known = self._numbers.get(e)
        if known is None:
            value = sp.N(e.xreplace(self._values), REAL_DIGITS + 5)
            known = self._numbers[e] = self.reals.float(sp.Float(value, REAL_DIGITS + 5))
        return known

    def value(self, e: sp.Expr) -> Any:
        """The value of a long expression at the state; each distinct part of it is worked out once."""
        return self.at_state(self.jet(e, 0, moving=True))

    def jet(self, e: sp.Expr, order: int, *, moving: bool = False) -> Jet:
        """The Taylor series of an expression of coordinates; of velocities too if `moving`."""
        key = order, moving
        if key not in self._known:
            symbols = self._symbols if moving else self._symbols[: self.size]
            variables = {s: self.ring.variable(k, self.number(s), order) for k, s in enumerate(symbols)}
            variables[t] = self.ring.variable(len(self._symbols), self.reals.number(0), order)
            self._known[key] = Expansion(self.ring, self.number, variables)
        return self._known[key](e)

    def vector(self, v: Vector, order: int, *, moving: bool = False) -> tuple[Jet, Jet, Jet]:
        """The Taylor series of the components of a vector in i, j, k."""
        a, b, c = (self.jet(e, order, moving=moving) for e in v.fixed().components)
        return a, b, c

    def dot(self, a: Sequence[Jet], b: Sequence[Jet]) -> Jet:
        """Σ a b, to the lowest order of all."""
        order = min(len(jet) for jet in (*a, *b)) - 1
        return self.ring.sum_of_products(zip(a, b, strict=True), order)

    def cross(self, a: Sequence[Jet], b: Sequence[Jet]) -> tuple[Jet, Jet, Jet]:
        """a × b."""
        times, less = self.ring.multiply, self.ring.subtract
        x, y, z = (less(times(a[k - 2], b[k - 1]), times(a[k - 1], b[k - 2])) for k in range(3))
        return x, y, z

    def along(self, jet: Jet, rates: Sequence[Any]) -> Jet:
        """Σ ∂_k jet · rates_k, over the coordinates; one order is lost."""
        total = self.ring.constant(self.reals.number(0), len(jet) - 2)
        for k, rate in enumerate(rates):
            if rate:
                total = self.ring.add(total, self.ring.scale(self.ring.derivative(jet, k), rate))
        return total

    def gradient(self, jet: Jet, first: int = 0) -> list[Any]:
        """The derivatives at the state by the coordinates, or by the variables from `first` on."""
        return [jet[1].get(1 << BITS * k, self.reals.number(0)) for k in range(first, first + self.size)]

    def at_state(self, jet: Jet) -> Any:
        """The value at the state."""
        return constant_term(jet) or self.reals.number(0)
