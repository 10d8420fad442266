"""The equations of motion of a changed system at one random state, in numbers.

At a random state of a prime field (or a real one, where there are roots) every part of `mechanics` is a number: g_ij
and ∂g_ij/∂q_l from the vectors J_i, so that a changed system costs a few sums and nothing has to be derived
symbolically. Each equation becomes a row over (multipliers, accelerations, 1), as in `comparison`, and an answer
follows from the changed system if its rows lie in the space of the changed rows. That is exact arithmetic: what agrees
at one such state does so everywhere, except with probability 10^-24, and is confirmed at states that share no random
number with the first.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import sympy as sp

from lagrange.algebra.exact.linear_algebra import NumberRow, RowSpace
from lagrange.algebra.exact.zero_test import DivisionByZeroError, InadmissibleError, Point
from lagrange.answers.models.mechanics import ForceShare, Inertia, Mechanics
from lagrange.answers.models.variation import VariedQuasiEquations
from lagrange.core.symbols import Slots, partial
from lagrange.mechanics.dynamics.comparison import System, affine_rows

Matrix = list[list[Any]]


class ModelState:
    """A random state of a system, with the rows of its equations and of changed ones.

    point     with velocities that satisfy the constraints
    unknowns  the multipliers, then the accelerations
    """

    def __init__(self, point: Point, system: System) -> None:
        self.point = point
        self.system = system
        self.slots: Slots = system.configuration.slots
        self.unknowns = (*system.multipliers, *self.slots.accelerations)
        self.constraints = affine_rows(point, system.accelerated_constraints, self.unknowns)
        self.derived = affine_rows(point, system.equations, self.unknowns)
        self._numbers: dict[tuple[object, ...], tuple[Matrix, list[Matrix]]] = {}
        self._shares: dict[Inertia | ForceShare, list[NumberRow]] = {}

    @cached_property
    def rates(self) -> list[Any]:
        """q_i', and 1 for time."""
        return [*self.point.values(self.slots.velocities), self.point.number(1)]

    @cached_property
    def right(self) -> RowSpace:
        """The row space of the derived equations and the constraints."""
        return self.space(self.derived)

    def space(self, rows: Sequence[NumberRow]) -> RowSpace:
        """The row space of some equations and the constraints."""
        return RowSpace(self.point.arithmetic, [*self.constraints, *rows])

    def row(self, equation: sp.Expr) -> NumberRow | None:
        """The row of an equation; None if it is not affine in the unknowns, or not defined here."""
        try:
            rows = self.point.affine([equation], self.unknowns)
        except (InadmissibleError, DivisionByZeroError):
            return None
        return None if rows is None else rows[0]

    def rows(self, mechanics: Mechanics) -> list[NumberRow]:
        """The rows of E_k of a system, one for each coordinate that it keeps."""
        reduce = self.point.arithmetic.reduce
        total = self._reactions(mechanics)
        parts: tuple[Inertia | ForceShare, ...] = (*mechanics.inertias, *mechanics.forces)
        for part in parts:
            for k, row in enumerate(self.share(part)):
                total[k] = [reduce(a + b) for a, b in zip(total[k], row, strict=True)]
        return [total[k] for k in mechanics.kept]

    def quasi_rows(self, mechanics: Mechanics, quasi: VariedQuasiEquations) -> list[NumberRow]:
        """The rows of the equations in quasi-velocities; their reactions do no work, and are not in them."""
        reduce, less = self.point.arithmetic.reduce, self._number(quasi.factor - 1)
        partials = [self.point.values(row) for row in quasi.partials]
        whole = self.rows(mechanics)
        inertia = [self._sum([row[k] for row in map(self.share, quasi.parts)]) for k in range(len(whole))]
        rows = []
        for s, kinetic in enumerate(affine_rows(self.point, quasi.kinetic, self.unknowns)):
            share = [p[s] for p in partials]
            all_, own = self._combined(share, whole), self._combined(share, inertia)
            rows.append([reduce(w + less * (a - b)) for w, a, b in zip(all_, own, kinetic, strict=True)])
        return rows

    def _sum(self, rows: Sequence[NumberRow]) -> NumberRow:
        return [self.point.arithmetic.reduce(sum(column)) for column in zip(*rows, strict=True)]

    def _combined(self, factors: Sequence[Any], rows: Sequence[NumberRow]) -> NumberRow:
        """Σ_k f_k row_k."""
        return self._sum([[f * x for x in row] for f, row in zip(factors, rows, strict=True)])

    def share(self, part: Inertia | ForceShare) -> list[NumberRow]:
        """What a part adds to each E_k, shape (n, len(unknowns) + 1)."""
        known = self._shares.get(part)
        if known is None:
            known = self._inertia(part) if isinstance(part, Inertia) else self._force(part)
            self._shares[part] = known
        return known

    def _reactions(self, mechanics: Mechanics) -> list[NumberRow]:
        """−Σ λ_j a_jk."""
        width, n = len(self.unknowns) + 1, len(self.slots.coordinates)
        rows = [[self.point.number(0)] * width for _ in range(n)]
        if len(mechanics.kept) == n:
            for j, row in enumerate(mechanics.configuration.rows):
                for k in range(n):
                    rows[k][j] = self.point.arithmetic.reduce(-self.point.value(row.coefficients[k]))
        return rows

    def _force(self, force: ForceShare) -> list[NumberRow]:
        factor = self._number(-force.factor)
        unknown = any(not s.free_symbols.isdisjoint(self.unknowns) for s in force.shares)
        if unknown:
            rows = affine_rows(self.point, force.shares, self.unknowns)
        else:
            blank = [self.point.number(0)] * len(self.unknowns)
            rows = [[*blank, self.point.value(s)] for s in force.shares]
        return self._scaled(rows, factor)

    def _inertia(self, part: Inertia) -> list[NumberRow]:
        """g_kj q_j'' + ġ_kj q_j' − ½ ∂g_ij/∂q_k q_i' q_j', with the factors of a model."""
        n = len(self.slots.coordinates)
        g, slopes = self._products(part)
        reduce = self.point.arithmetic.reduce
        rates = [self.point.number(0) if i in part.still else v for i, v in enumerate(self.rates)]
        of_pair = {pair: self._number(f) for pair, f in part.pairs}
        product, gradient, explicit = map(self._number, (part.product, part.gradient, part.explicit))
        mixed, squared, factor = map(self._number, (part.mixed, part.squared, part.factor))
        half = self.point.number(1, 2)
        moving = part.moving

        def times(i: int, j: int, value: Any) -> Any:
            f = of_pair.get((i, j) if i <= j else (j, i))
            return value if f is None else value * f

        rows = []
        for k in range(n):
            row = [self.point.number(0)] * (len(self.unknowns) + 1)
            offset = len(self.unknowns) - n
            sums: dict[bool | None, Any] = {True: 0, False: 0, None: 0}
            if k in moving:
                for j in moving:
                    if j < n and j not in part.still:
                        row[offset + j] = reduce(times(k, j, g[k][j]) * factor)
                    for l in range(n + 1):
                        if slopes[l][k][j] != 0:
                            same = None if l == j == n else l == j
                            value = times(k, j, slopes[l][k][j]) * rates[l] * rates[j] * product
                            sums[same] += reduce(value * explicit if l == n else value)
            for i in moving:
                for j in moving:
                    if slopes[k][i][j] != 0:
                        value = times(i, j, slopes[k][i][j]) * rates[i] * rates[j] * gradient
                        sums[i == j] -= reduce(value * half)
            row[-1] = reduce((sums[None] + sums[True] * squared + sums[False] * mixed) * factor)
            rows.append(row)
        return rows

    def _products(self, part: Inertia) -> tuple[Matrix, list[Matrix]]:
        """g_ij and ∂g_ij/∂q_l, for l up to and including time."""
        known = self._numbers.get(part.geometry)
        if known is None:
            known = self._numbers[part.geometry] = self._evaluated(part)
        return known

    def _evaluated(self, part: Inertia) -> tuple[Matrix, list[Matrix]]:
        value, reduce = self.point.value, self.point.arithmetic.reduce
        n, size = len(self.slots.coordinates), len(part.columns)
        weights = [value(w) for w in part.weights]
        axes = [a for a in range(3) if part.weights[a] != 0]
        columns = [[value(c) for c in column] for column in part.columns]
        zero = self.point.number(0)

        def product(i: int, j: int) -> Any:
            return reduce(sum((weights[a] * columns[i][a] * columns[j][a] for a in axes), zero))

        g = [[product(i, j) for j in range(size)] for i in range(size)]
        slopes = []
        for l in range(n + 1):
            bent = [[value(self._slope(c, l)) if c != 0 else zero for c in column] for column in part.columns]
            half = [
                [reduce(sum((weights[a] * bent[i][a] * columns[j][a] for a in axes), zero)) for j in range(size)]
                for i in range(size)
            ]
            slopes.append([[reduce(half[i][j] + half[j][i]) for j in range(size)] for i in range(size)])
        return g, slopes

    def _slope(self, component: sp.Expr, index: int) -> sp.Expr:
        """∂/∂q_l, and ∂/∂t for the last index."""
        coordinates = self.slots.coordinates
        if index < len(coordinates):
            return partial(component, coordinates[index])
        return self.slots.frozen_derivative(component)

    def _number(self, factor: sp.Expr) -> Any:
        if factor.is_Rational:
            return self.point.number(int(factor.p), int(factor.q))
        return self.point.value(factor)

    def _scaled(self, rows: Sequence[NumberRow], factor: Any) -> list[NumberRow]:
        reduce = self.point.arithmetic.reduce
        return [[reduce(x * factor) for x in row] for row in rows]
