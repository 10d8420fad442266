"""Stability where the second variation vanishes, against numbers: V is followed along its valley.

At an equilibrium with drawn parameters let Z be displacements that the constraints admit and along which the second
variation vanishes. For each of many directions s, and a small step ε, the place is sought at which V is stationary
among all places with that displacement along Z,

    ∂V/∂q = Aᵀ λ + Z ν ,     f(q) = 0 ,     Zᵀ (q − q_0) = ε s .

The bottom of the valley there rises with the rate dV/dε = ν·s. A strict minimum needs dV/dε > 0 in all directions, and
a place where V falls excludes one. Two steps, one a tenth of the other, give the order n of V along the direction,
since dV/dε ~ ε^(n−1). Nothing is expanded in powers, no form is factored and no coordinate is eliminated, so that
this has nothing in common with how the lowest terms of V are found (`degenerate`).

V falls in a cone that may be narrow: near the direction of the least rate others are tried, and a statement that V
falls somewhere is undecided where no such direction is found.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import islice
from typing import Any

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.single_equation import Values
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.real_points import RealPoint, newton_point
from lagrange.core.records import all_hold
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import (
    DIRECTIONS_NEAR_THE_LEAST,
    DIRECTIONS_OF_A_VALLEY,
    INTEGER_ORDER,
    MOST_DRAWS,
    NO_RATE,
    POINTS_OF_A_VALLEY,
    STEP_IN_A_VALLEY,
    WIDEST_SPREAD,
)
from lagrange.mechanics.equilibrium.sampled_checks import (
    HOW,
    Samples,
    check_stability,
    claimed,
    definiteness_in_numbers,
)
from lagrange.mechanics.equilibrium.stability import SecondVariation, Stability, StabilityVerdict

Numbers = Sequence[Any]


def check_minima(resting: Equilibrium, second: SecondVariation | None) -> list[Check]:
    """The checks of the stability of the equilibria of one configuration, by the second variation and beyond it."""
    return [*check_stability(resting, second), *check_valleys(resting, second)]


def check_valleys(resting: Equilibrium, second: SecondVariation | None) -> list[Check]:
    """The check of stability where the second variation vanishes; none if nothing rests on terms of higher order."""
    if second is None:
        return []
    valleys = Valleys(Samples(resting))
    verdicts: list[bool | None] = []
    for b, s in zip(resting.branches, second.verdicts, strict=True):
        if s.order != 2 or s.even_powers:
            verdicts += valleys.agreeing(b, s)
        if s.at_limit is not None and s.at_limit.order != 2:
            verdicts += valleys.agreeing_at_limit(b, s)
    if not verdicts:
        return []
    name = "V rises or falls as stated where the second variation vanishes"
    return [Check(name, all_hold(verdicts), HOW, resting.configuration.name)]


class Valleys:
    """The valleys of V at the equilibria of one configuration."""

    def __init__(self, samples: Samples) -> None:
        self.samples = samples
        self.coordinates = samples.slots.coordinates
        self.finite = samples.resting.configuration.finite_constraints

    def agreeing(self, b: Branch, s: Stability) -> list[bool | None]:
        """Whether V rises or falls as is stated, at each point that could be used; none if nothing is stated."""
        if b.special or b.left or len(self.finite) != len(self.samples.rows):
            return []
        if s.verdict is StabilityVerdict.UNDECIDED:
            return []
        verdicts: list[bool | None] = []
        for points in self.samples.series(b):
            left = {True: POINTS_OF_A_VALLEY, False: POINTS_OF_A_VALLEY}
            for point in islice(points, MOST_DRAWS):
                if not any(left.values()):
                    break
                try:
                    stable = claimed(point, b, s)
                    if stable is None or not left[stable]:
                        continue
                    verdict = self._rises(point, s)
                except (InadmissibleError, UnsupportedError, DivisionByZeroError):
                    continue
                left[stable] -= 1
                verdicts.append(None if verdict is None else verdict is stable)
        return verdicts or [None]

    def agreeing_at_limit(self, b: Branch, s: Stability) -> list[bool | None]:
        """The same where a condition of stability is an equality; none if no parameter can be chosen for that."""
        if b.special or b.left or len(b.points) != 1 or len(s.conditions) != 1 or s.at_limit is None:
            return []
        [condition] = s.conditions
        verdicts: list[bool | None] = []
        for number in range(MOST_DRAWS):
            try:
                point = self._at_limit(b.points[0], condition.lhs - condition.rhs, number)
                stable = None if point is None else claimed(point, b, s.at_limit)
                if point is None or stable is None:
                    continue
                rises = self._rises(point, s.at_limit)
            except (InadmissibleError, UnsupportedError, DivisionByZeroError):
                continue
            verdicts.append(None if rises is None else rises is stable)
            if len(verdicts) == POINTS_OF_A_VALLEY:
                break
        return verdicts

    def _at_limit(self, values: Values, difference: sp.Expr, number: int) -> RealPoint | None:
        """An equilibrium with drawn parameters but one, which makes a difference zero; None if none can."""
        drawn = self.samples.point(values, number)
        for letter in sorted(difference.free_symbols - {*self.coordinates}, key=str):
            trial = self.samples.point(values, number)
            if not newton_point(trial, [difference], [letter]) or not trial.value(letter) > 0:
                continue
            point = self.samples.point(values, number, {letter: trial.value(letter)})
            if drawn.arithmetic.vanishes(point.value(difference)):
                return point
        return None

    def _rises(self, point: RealPoint, s: Stability) -> bool | None:
        """Whether V has a strict minimum at a point in all directions tried; None if undecided."""
        basis = self._valley(point)
        if basis is None:
            return False
        if not basis:
            return True
        least: tuple[Any, Numbers] | None = None
        for direction in self._directions(point, len(basis)):
            rate, order = self._rate(point, basis, direction)
            if rate is None:
                return None
            if rate < 0:
                return False
            if order is not None and order < s.order:
                return None
            least = min(least or (rate, direction), (rate, direction), key=lambda pair: pair[0])
        assert least is not None
        for direction in self._near(point, least[1]) if len(basis) > 1 else ():
            rate, _ = self._rate(point, basis, direction)
            if rate is None:
                return None
            if rate < 0:
                return False
        return None if s.verdict is StabilityVerdict.UNSTABLE else True

    def _valley(self, point: RealPoint) -> list[Numbers] | None:
        """The displacements in which the second variation vanishes; None if it takes negative values."""
        table, basis = self.samples.projected(point)
        if definiteness_in_numbers(point, table) == -1:
            return None
        flat = point.nullspace(table, len(table))
        size = range(len(self.coordinates))
        return [[sum(c * row[k] for c, row in zip(v, basis, strict=True)) for k in size] for v in flat]

    def _directions(self, point: RealPoint, size: int) -> Iterator[Numbers]:
        """Unit vectors: both ways of a line, around a circle, and otherwise drawn."""
        if size == 1:
            yield from ([point.number(1)], [point.number(-1)])
        elif size == 2:
            for n in range(DIRECTIONS_OF_A_VALLEY):
                angle = mpmath.mpf(2 * n + 1) * mpmath.pi / DIRECTIONS_OF_A_VALLEY
                yield [point.number(0) + mpmath.cos(angle), point.number(0) + mpmath.sin(angle)]
        for k in range(size if size > 1 else 0):
            for sign in (1, -1):
                yield [point.number(sign * (n == k)) for n in range(size)]
        for _ in range(2 * DIRECTIONS_OF_A_VALLEY if size > 2 else 0):
            yield _unit([point.number(0) + point.reals.random.gauss(0, 1) for _ in range(size)])

    def _near(self, point: RealPoint, direction: Numbers) -> Iterator[Numbers]:
        """Directions about the one of the least rate."""
        for _ in range(DIRECTIONS_NEAR_THE_LEAST):
            spread = point.reals.random.uniform(0, WIDEST_SPREAD)
            yield _unit([x + point.reals.random.gauss(0, spread) for x in direction])

    def _rate(self, point: RealPoint, basis: Sequence[Numbers], direction: Numbers) -> tuple[Any, int | None]:
        """dV/dε at the smaller of two steps, and the order of V; None if the two do not fit together."""
        rates = [self._rate_at(point, basis, direction, scale) for scale in (1, 10)]
        small, large = rates
        if small is None or large is None:
            return None, None
        if max(abs(small), abs(large)) < NO_RATE:
            return mpmath.mpf(0), None
        ratio = large / small if small else mpmath.mpf(-1)
        if ratio <= 0:
            return None, None
        power = mpmath.log10(ratio)
        order = int(mpmath.nint(power))
        return (small, order + 1) if abs(power - order) < INTEGER_ORDER else (None, None)

    def _rate_at(self, point: RealPoint, basis: Sequence[Numbers], direction: Numbers, scale: int) -> Any | None:
        equations, unknowns, names = self._bottom(len(basis))
        step = point.number(scale) * STEP_IN_A_VALLEY
        start = {u: point.value(u) for u in (*self.coordinates, *self.samples.multipliers)}
        place = {name: start[q] for name, q in zip(names.place, self.coordinates, strict=True)}
        along = {z: x for row, v in zip(names.valley, basis, strict=True) for z, x in zip(row, v, strict=True)}
        moved = dict(zip(names.steps, [step * x for x in direction], strict=True))
        slopes = dict.fromkeys(names.slopes, point.number(0))
        point.move({**place, **along, **moved, **slopes})
        reached = newton_point(point, equations, unknowns)
        rate = sum(point.value(v) * x for v, x in zip(names.slopes, direction, strict=True))
        point.move(start)
        return rate if reached else None

    @cached_property
    def _systems(self) -> dict[int, tuple[list[sp.Expr], tuple[sp.Symbol, ...], _Names]]:
        return {}

    def _bottom(self, size: int) -> tuple[list[sp.Expr], tuple[sp.Symbol, ...], _Names]:
        """The equations for the bottom of a valley of so many dimensions, and their unknowns."""
        if size not in self._systems:
            names = _Names(len(self.coordinates), size)
            multipliers = self.samples.multipliers
            equations = [
                force
                - sp.Add(*(m * row[k] for m, row in zip(multipliers, self.samples.rows, strict=True)))
                - sp.Add(*(v * row[k] for v, row in zip(names.slopes, names.valley, strict=True)))
                for k, force in enumerate(self.samples.forces)
            ]
            equations += self.finite
            for row, step in zip(names.valley, names.steps, strict=True):
                moved = zip(row, self.coordinates, names.place, strict=True)
                equations.append(sp.Add(*(z * (q - start) for z, q, start in moved), -step))
            self._systems[size] = (equations, (*self.coordinates, *multipliers, *names.slopes), names)
        return self._systems[size]


class _Names:
    """Symbols for q_0, Z, ε s and ν."""

    def __init__(self, width: int, size: int) -> None:
        self.place = tuple(sp.Dummy(f"start_{k}", real=True) for k in range(width))
        self.valley = tuple(tuple(sp.Dummy(f"z_{j}{k}", real=True) for k in range(width)) for j in range(size))
        self.steps = tuple(sp.Dummy(f"step_{j}", real=True) for j in range(size))
        self.slopes = tuple(sp.Dummy(f"slope_{j}", real=True) for j in range(size))


def _unit(v: Sequence[Any]) -> Numbers:
    length = mpmath.sqrt(sum(x * x for x in v))
    return [x / length for x in v]
