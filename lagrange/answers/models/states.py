"""The equations of motion of a changed system at one random state, in numbers.

At a random state of a prime field (or a real one, where there are roots) every part of `mechanics` is a number: g_ij
and ∂g_ij/∂q_l from the vectors J_i, so that a changed system costs a few sums and nothing has to be derived
symbolically. Each equation becomes a row over (multipliers, accelerations, 1), as in `comparison`, and an answer
follows from the changed system if its rows lie in the space of the changed rows. That is exact arithmetic: what agrees
at one such state does so everywhere, except with probability 10^-24, and is confirmed at states that share no random
number with the first.

The groups of terms of one physical origin in the derived equations.

In E_k they are: what each applied force contributes, and all of a kind together; what each particle and each rotation
contributes, and each product of velocities; the velocity terms, those of a frame's motion, and the coupling with one
other acceleration. A group that is missing, has the wrong sign or a factor is named in the words of mechanics.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError
from lagrange.algebra.exact.linear_algebra import NumberRow, RowSpace
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.answers.models.forces import name_of
from lagrange.answers.models.mechanics import (
    AppliedForceKind,
    ForceShare,
    Inertia,
    Mechanics,
    VariedQuasiEquations,
    called,
)
from lagrange.core.records import record
from lagrange.core.symbols import Slots, partial
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.comparison import System, affine_rows

Matrix = list[list[Any]]


def _accelerated(configuration: Configuration) -> tuple[sp.Expr, ...]:
    """Constraints with constant coefficients, Σ a_i q_i' = 0, in the accelerations."""
    accelerations = configuration.slots.accelerations
    return tuple(sp.Add(*map(sp.Mul, row.coefficients, accelerations)) for row in configuration.rows)


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

    def space(self, rows: Sequence[NumberRow], mechanics: Mechanics | None = None) -> RowSpace:
        """The row space of some equations and the constraints, which may be others in a changed system."""
        constraints = self.constraints
        if mechanics is not None and (
            mechanics.is_steady or mechanics.configuration.rows != self.system.configuration.rows
        ):
            constraints = affine_rows(self.point, _accelerated(mechanics.configuration), self.unknowns)
        return RowSpace(self.point.arithmetic, [*constraints, *rows])

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
        """The contribution of a part to each E_k, shape (n, len(unknowns) + 1)."""
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


# Groups


_ZERO, _SIGN, _TWICE, _HALF = sp.S.Zero, sp.S.NegativeOne, sp.Integer(2), sp.Rational(1, 2)


@record
class TermGroup:
    """A group of terms.

    name     of the mistake
    what     the group in a sentence
    rows     its share of each E_k at a state; a zero row where it has none
    factors  those that people give it by mistake
    """

    name: str
    what: str
    rows: Callable[[ModelState], list[NumberRow]]
    factors: tuple[sp.Expr, ...] = (_ZERO, _SIGN, _TWICE, _HALF)

    def said(self, factor: sp.Expr, coordinate: sp.Symbol) -> tuple[str, str]:
        """What to say of it in the equation of a coordinate, and where to look."""
        how = {
            _ZERO: f"{self.what} is left out",
            _SIGN: f"the sign of {self.what} is wrong",
            _TWICE: f"{self.what} is counted twice",
            _HALF: f"only half of {self.what} is there",
            -_TWICE: f"{self.what} is counted twice, with the wrong sign,",
            -_HALF: f"only half of {self.what} is there, with the wrong sign,",
        }[factor]
        return f"{how} in the equation of {coordinate}", self.what


def term_groups(m: Mechanics) -> Iterator[TermGroup]:
    """The groups of a system, the smallest and likeliest first."""

    def share(*parts: object) -> Callable[[ModelState], list[NumberRow]]:
        return lambda at: _sum(at, parts)

    for f in m.forces:
        if f.kind is not AppliedForceKind.QUASI:
            yield TermGroup("force in one equation", name_of(f), share(f))
    for j, row in enumerate(m.configuration.rows):
        what = f"the reaction of {called(row.name)}"
        yield TermGroup("reaction in one equation", what, _reaction(j), (_ZERO, _SIGN, _TWICE, _HALF, -_TWICE, -_HALF))
    weights = m.of_kind(AppliedForceKind.WEIGHT)
    if len(weights) > 1:
        yield TermGroup("weight in one equation", "the weight", share(*weights))
    for kind in (AppliedForceKind.SPRING, AppliedForceKind.DAMPER, AppliedForceKind.FRICTION):
        several = m.of_kind(kind)
        if len(several) > 1:
            word = {
                AppliedForceKind.SPRING: "springs",
                AppliedForceKind.DAMPER: "dampers",
                AppliedForceKind.FRICTION: "friction forces",
            }[kind]
            yield TermGroup("forces in one equation", f"the force of the {word}", share(*several))
    n = len(m.slots.coordinates)
    frame = [_with_velocity(i, n) for i in m.inertias if n in i.moving]
    if frame:
        what = "what the motion of the frame or support contributes"
        yield TermGroup("frame in one equation", what, share(*frame))
    moving = m.inertias
    velocity = _without_accelerations(moving)
    mixed = tuple(replace(i, squared=_ZERO) for i in moving)
    squared = tuple(replace(i, mixed=_ZERO) for i in moving)
    what = "the Coriolis term, with a product of two velocities,"
    yield TermGroup("Coriolis term in one equation", what, _without_accelerations(mixed))
    what = "the centrifugal term, with the square of a velocity,"
    yield TermGroup("centrifugal term in one equation", what, _without_accelerations(squared))
    yield TermGroup("velocity terms in one equation", "the sum of the velocity terms", velocity, (_ZERO, _SIGN))
    gradient = tuple(replace(i, gradient=_ZERO) for i in moving)
    yield TermGroup("dT/dq in one equation", "the term dT/dq", _difference(moving, gradient))
    product = tuple(replace(i, product=_ZERO) for i in moving)
    what = "the part of d/dt of dT/dq' with the rate of the coefficients"
    yield TermGroup("d/dt in one equation", what, _difference(moving, product))
    for i in m.rotations:
        yield TermGroup("rotation in one equation", f"the rotational inertia of {called(i.name)}", share(i), (_ZERO,))
    for p in m.particles if len(m.inertias) > 1 else ():
        yield TermGroup("inertia in one equation", f"the inertia of {called(p.name)}", share(p), (_ZERO, _SIGN))
    for j, v in enumerate(m.slots.velocities):
        for p in m.particles:
            if j in p.moving and len(p.moving) > 1:
                what = f"what {v} contributes to the velocity of {called(p.name)}"
                own = share(_with_velocity(p, j))
                yield TermGroup("velocity in one equation", what, own, (_ZERO, _SIGN))
        if len(m.slots.coordinates) > 1:
            what = f"the inertia that {v}' has"
            yield TermGroup("acceleration in one equation", what, _coupling(moving, j), (_ZERO, _SIGN))


def _sum(at: ModelState, parts: tuple[object, ...]) -> list[NumberRow]:
    reduce = at.point.arithmetic.reduce
    shares = [at.share(p) for p in parts]  # type: ignore[arg-type]
    return [[reduce(sum(x)) for x in zip(*rows, strict=True)] for rows in zip(*shares, strict=True)]


def _reaction(j: int) -> Callable[[ModelState], list[NumberRow]]:
    """The share of the multiplier of one constraint."""

    def rows(at: ModelState) -> list[NumberRow]:
        n, width = len(at.slots.coordinates), len(at.unknowns) + 1
        shares = [[at.point.number(0)] * width for _ in range(n)]
        for k, coefficient in enumerate(at.system.configuration.rows[j].coefficients):
            shares[k][j] = at.point.arithmetic.reduce(-at.point.value(coefficient))
        return shares

    return rows


def _with_velocity(i: Inertia, index: int) -> Inertia:
    """The products of T with one velocity, alone."""
    return i.times({p: _ZERO for p in i.products if index not in p})


def _difference(all_: tuple[Inertia, ...], rest: tuple[Inertia, ...]) -> Callable[[ModelState], list[NumberRow]]:
    def rows(at: ModelState) -> list[NumberRow]:
        reduce = at.point.arithmetic.reduce
        pairs = zip(_sum(at, all_), _sum(at, rest), strict=True)
        return [[reduce(a - b) for a, b in zip(x, y, strict=True)] for x, y in pairs]

    return rows


def _without_accelerations(moving: tuple[Inertia, ...]) -> Callable[[ModelState], list[NumberRow]]:
    def rows(at: ModelState) -> list[NumberRow]:
        blank = [at.point.number(0)] * len(at.unknowns)
        return [[*blank, row[-1]] for row in _sum(at, moving)]

    return rows


def _coupling(moving: tuple[Inertia, ...], j: int) -> Callable[[ModelState], list[NumberRow]]:
    """The term with q_j'' in the equations of the other coordinates."""

    def rows(at: ModelState) -> list[NumberRow]:
        offset = len(at.unknowns) - len(at.slots.coordinates)
        shown = []
        for k, row in enumerate(_sum(at, moving)):
            blank = [at.point.number(0)] * len(row)
            if k != j:
                blank[offset + j] = row[offset + j]
            shown.append(blank)
        return shown

    return rows
