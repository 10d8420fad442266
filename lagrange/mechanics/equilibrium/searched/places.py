"""Places of rest found numerically, against the list of equilibria in closed form.

An equilibrium is lost in a step of solving: a division by sin θ, a factor that is dropped, a pivot. So parameters are
drawn, and the conditions as they were before any such step,

    Q + Aᵀ λ = 0 ,     f = 0 ,

are solved for q, λ and unknown forces by Newton's method from places spread over a box, which is always the same. Each
zero must satisfy the printed relations and conditions of a branch. One that satisfies none is lost, if it is confirmed
to many digits and the constraints are regular there; then the conditions join the list as unsolved, so that it is
stated to be incomplete wherever it is used.

Finding nothing proves nothing: the search is short. An artefact of the coordinates, a pole of a chart or a place
outside of a range, is not a lost equilibrium, and neither is one where a force has no value.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import chain, product
from random import Random
from typing import Any

import mpmath
import sympy as sp

from lagrange.algebra.closed_forms.signs import SignCondition
from lagrange.algebra.closed_forms.single_equation import Relation
from lagrange.algebra.closed_forms.solution_sets import Branch
from lagrange.algebra.closed_forms.unit_circle import CIRCULAR
from lagrange.mechanics.equilibrium.equilibrium import Equilibrium
from lagrange.mechanics.equilibrium.limits import (
    AGREES,
    DIFFERS,
    FARTHEST,
    MOST_SEARCHED_UNKNOWNS,
    MOST_TURNED,
    SEARCHED_OPERATIONS,
    SEARCHED_STARTS,
    SPREADS,
)
from lagrange.mechanics.equilibrium.searched.newton import (
    DIGITS,
    NoTapeError,
    Tape,
    confirmed,
    numerical_rank,
    random_start,
    random_value,
    with_best,
    zero_near,
)


def with_search(e: Equilibrium) -> Equilibrium:
    """The equilibria with what a search in numbers says of the list; with unsolved conditions where it lacks any."""
    if e.given or any(b.left and not (b.relations or b.conditions) for b in e.branches):
        return e
    try:
        missing = _Search(e).missing()
    except NoTapeError:
        return e
    if not missing:
        return replace(e, all_found=None if missing is None else True)
    left = Branch((), left=tuple(x for x in _conditions(e) if x.free_symbols), occupied=True)
    solution = replace(e.solution, branches=(*e.solution.branches, left))
    idle = (*e.idle, ()) if e.idle else ()
    return replace(e, all_found=False, solution=solution, branches=(*e.branches, left), idle=idle)


def _conditions(e: Equilibrium) -> tuple[sp.Expr, ...]:
    """Q + Aᵀ λ, the laws and the finite constraints: each zero, before anything is multiplied."""
    multipliers = e.multipliers or tuple(row.multiplier for row in e.binding)
    return (*e.balance(multipliers), *e.laws, *e.configuration.finite_constraints)


class _Search:
    """The search for one list."""

    def __init__(self, e: Equilibrium) -> None:
        self.e = e
        self.coordinates = e.configuration.slots.coordinates
        multipliers = e.multipliers or tuple(row.multiplier for row in e.binding)
        self.unknowns = (*self.coordinates, *e.forces, *multipliers)
        self.linear = len(self.unknowns) - len(multipliers)
        self.equations = [x for x in _conditions(e) if x != 0]
        self.rows = [list(row.coefficients) for row in e.binding]
        explained = (*e.poles, *e.outside, *(place.branch for place in e.singular))
        self.listed = [(b, True) for b in e.branches if not b.special] + [(b, False) for b in explained]
        stated = [x for b, _ in self.listed for r in b.equations for x in (r.lhs, r.rhs)]
        stated += [x for b, _ in self.listed for c in b.conditions for x in (c.lhs, c.rhs)]
        used = chain(self.equations, stated, *self.rows)
        self.parameters = sorted({s for x in used for s in x.free_symbols} - {*self.unknowns}, key=str)
        self.symbols = (*self.unknowns, *self.parameters)
        self.tape = Tape(self.equations, self.symbols)

    def missing(self) -> bool | None:
        """Whether a place of rest is missing from the list; None if none was found where some are stated."""
        if not self.equations or len(self.unknowns) > MOST_SEARCHED_UNKNOWNS:
            return None
        random = Random(2)
        any_zero = False
        for spread in SPREADS:
            numbers = [random_value(s, spread, random) for s in self.parameters]
            for tape, place in self._zeros(numbers, random):
                any_zero = True
                if not self._is_listed(place, numbers) and self._is_lost(tape, place, numbers):
                    return True
        return False if any_zero or not self.e.branches else None

    def _zeros(self, numbers: Sequence[float], random: Random) -> Iterator[tuple[Tape, list[float]]]:
        """Different zeros, each with the equations that it satisfies; half of the work for the equations alone."""
        seen: list[list[float]] = []
        share = SEARCHED_OPERATIONS // (2 * len(SPREADS))
        for tapes in ([self.tape] * SEARCHED_STARTS, self._divided):
            spent = 0
            for tape in tapes:
                before = tape.carried_out

                def f(x: Sequence[float], tape: Tape = tape) -> list[float]:
                    return tape.values([*x, *numbers])

                angles = self.e.solution.letters.angles
                places = [random_start(u, self.coordinates, angles, random) for u in self.unknowns]
                start = with_best(f, places, self.linear)
                place = zero_near(f, start, FARTHEST)
                spent += tape.carried_out - before
                if place is not None and not self._is_far(place) and not any(_is_same(place, p) for p in seen):
                    seen.append(place)
                    yield tape, place
                if spent > share:
                    break

    @cached_property
    def _divided(self) -> list[Tape]:
        """The equations with one more: that something vanishes by which a step of solving may divide.

        Equilibria that fill a surface hide the line on it that a division by sin θ loses. A coordinate is 0, an angle a
        multiple of π/2, a pivot or a denominator of what is stated vanishes.
        """
        angles = self.e.solution.letters.angles
        more: list[sp.Expr] = []
        for q in self.coordinates:
            more += [q - k * sp.pi / 2 for k in (0, 1, 2, -1)] if q in angles else [q]
        below = [sp.fraction(r.rhs)[1] for b in self.e.branches for r in b.relations]
        more += [x for x in (*self.e.elimination.pivots, *below) if x.free_symbols & {*self.coordinates}]
        return [Tape([*self.equations, x], self.symbols) for x in dict.fromkeys(more)]

    def _is_listed(self, place: Sequence[Any], numbers: Sequence[float], agrees: float = 1e-6) -> bool:
        """Whether a branch has the place, to so many digits, or another one that differs by full turns."""
        if any(self._has(b, conditioned, place, numbers, agrees) for b, conditioned in self.listed):
            return True
        turned_at_all = any(q in self.e.solution.letters.angles for q in self.coordinates)
        for turns in product((0, 1, -1), repeat=min(len(self._mixed), MOST_TURNED * turned_at_all)):
            turned = list(place)
            for n, turn in zip(self._mixed, turns, strict=False):
                turned[n] += 2 * turn * mpmath.pi
            residual = self.tape.values([*turned, *numbers], DIGITS) if any(turns) else [mpmath.inf]
            if max(map(abs, residual)) < max(agrees, 1e-7) and any(
                self._has(b, conditioned, turned, numbers, agrees) for b, conditioned in self.listed
            ):
                return True
        return False

    @cached_property
    def _mixed(self) -> list[int]:
        """The coordinates that do not occur in sines and cosines alone, by number: turns of several may cancel."""
        return [n for n, q in enumerate(self.coordinates) if q not in self._turning]

    def _is_far(self, place: Sequence[float]) -> bool:
        """Whether an angle among these is more than one turn away: one turn from −3π is −π, which is stated as π."""
        angles = self.e.solution.letters.angles
        return any(abs(place[n]) > 2.9 * math.pi for n in self._mixed if self.coordinates[n] in angles)

    def _is_lost(self, tape: Tape, guess: Sequence[float], numbers: Sequence[float]) -> bool:
        """Whether the place is certainly a place of rest, and certainly in no branch."""

        exact = [mpmath.mpf(x) for x in numbers]  # l² of a float is rounded to 16 digits

        def f(x: Sequence[Any]) -> list[Any]:
            return tape.values([*x, *exact], DIGITS)

        place = confirmed(f, guess)
        if place is None or self._is_outside(place, numbers):
            return False
        with mpmath.workdps(60):
            try:
                return self._is_regular(place, numbers) and not self._is_listed(place, numbers, AGREES)
            except (ValueError, ArithmeticError):
                return False

    def _is_regular(self, place: Sequence[Any], numbers: Sequence[float]) -> bool:
        """Whether the constraints have the rank there that they have elsewhere."""
        if not self.rows:
            return True
        tape, width = Tape([a for row in self.rows for a in row], self.symbols), len(self.coordinates)
        beside = [a + 0.3 * mpmath.cos(n) for n, a in enumerate(place)]
        ranks = []
        for x in (place, beside):
            flat = tape.values([*x, *numbers], DIGITS)
            ranks.append(numerical_rank([flat[n : n + width] for n in range(0, len(flat), width)]))
        return ranks[0] == ranks[1]

    def _is_outside(self, place: Sequence[Any], numbers: Sequence[float]) -> bool:
        """Whether a coordinate is outside of its range, or at its end; also one that the choice has replaced."""
        own = self.e.configuration
        known = dict(zip(own.slots.coordinates, place, strict=False))
        known |= dict(zip(self.parameters, numbers, strict=True))
        values = {s: sp.Float(v) for s, v in known.items()}
        for q, limits in (*own.ranges.items(), *own.bounded):
            low, value, high = (x.xreplace(values) for x in (limits.low, q, limits.high))
            if low.is_number and value.is_number and high.is_number and not low + 1e-9 < value < high - 1e-9:
                return True
        return False

    @cached_property
    def _tapes(self) -> Mapping[int, tuple[Tape, Tape]]:
        """The relations and the conditions of each branch."""
        return {
            id(b): (
                Tape([x for r in b.equations for x in (r.lhs, r.rhs)], self.symbols),
                Tape([c.lhs - c.rhs for c in b.conditions], self.symbols),
            )
            for b, _ in self.listed
        }

    def _has(self, b: Branch, conditioned: bool, place: Sequence[Any], numbers: Sequence[float], agrees: float) -> bool:
        """Whether the relations of a branch hold at a place, and its conditions; also where they have no value."""
        relations, conditions = self._tapes[id(b)]
        given = [mpmath.mpf(x) for x in (*place, *numbers)]
        try:
            sides = relations.values(given, DIGITS)
        except (ValueError, ArithmeticError):
            return False
        if not all(self._agree(r, *pair, agrees) for r, pair in zip(b.equations, _pairs(sides), strict=True)):
            return False
        try:
            differences = conditions.values(given, DIGITS) if conditioned else []
        except (ValueError, ArithmeticError):
            return True
        return all(_may_hold(c, d, agrees) for c, d in zip(b.conditions, differences, strict=False))

    def _agree(self, r: Relation, left: Any, right: Any, agrees: float) -> bool:
        """Whether the sides of a relation are equal, angles up to full turns."""
        difference = left - right
        if r.lhs in self._periods:  # with s = h θ beside it, θ = 0 stands for θ = 2π as well
            turn = 2 * mpmath.pi * self._periods[r.lhs]
            difference -= turn * mpmath.nint(difference / turn)
        return bool(abs(difference) <= agrees * (1 + abs(left)))

    @cached_property
    def _periods(self) -> dict[sp.Symbol, Any]:
        """The coordinates that occur in sines and cosines, each with its period in turns."""
        angles = self.e.solution.letters.angles
        ratios = {q: q / angles[q].measure for q in self.coordinates if q in angles}
        return {q: mpmath.mpf(int(ratio)) for q, ratio in ratios.items() if ratio.is_Integer}

    @cached_property
    def _turning(self) -> frozenset[sp.Symbol]:
        """The coordinates that occur in sines and cosines alone."""
        turning = set()
        for q in self._periods:
            waves = {f: sp.S.One for x in self.equations for f in x.atoms(*CIRCULAR) if q in f.free_symbols}
            if not any(q in x.xreplace(waves).free_symbols for x in self.equations):
                turning.add(q)
        return frozenset(turning)


def _is_same(place: Sequence[float], other: Sequence[float]) -> bool:
    return max(abs(a - b) for a, b in zip(place, other, strict=True)) < 1e-4


def _pairs(values: Sequence[Any]) -> Iterator[tuple[Any, Any]]:
    return zip(values[::2], values[1::2], strict=True)


def _may_hold(c: SignCondition, difference: Any, agrees: float) -> bool:
    """Whether a condition holds, or fails by too little to be sure: θ ≠ 0 fails where θ is 0 to the digits known."""
    if c.relation == "≠":
        return bool(abs(difference) > agrees)
    if abs(difference) < DIFFERS:
        return True
    return c.relation != "=" and (difference > 0) == (c.relation in ("≥", ">"))
