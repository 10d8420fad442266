"""Comparison of two systems of equations: do they have the same solutions?

Equations of motion are affine in the unknowns (accelerations, multipliers). At a random state on the constraint
surface, with velocities that satisfy the constraints, each becomes a row [A | b]. An equation follows from a system if
its row lies in the row space of the system's rows and of the second derivatives of the constraints; two systems agree
if each follows from the other. This accepts any rearrangement, any nonzero factor and any linear combination.
Multipliers are columns like the others; where they may be eliminated, their columns are projected out.

Rows are evaluated exactly at random points. A contradiction is certain where there are no branches; how certain it is
that an equation follows is explained in `zero_test`: it depends on the prime that all points of a question share, and
little on their number. A result that differs from point to point is "undecided".
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from enum import Enum, auto
from functools import cached_property
from typing import Any, TypeVar

import sympy as sp

from lagrange.algebra.exact.linear_algebra import NumberRow, RowSpace
from lagrange.algebra.exact.zero_test import NoPointError, Point, UnsupportedError, agreed
from lagrange.core.records import record
from lagrange.core.symbols import symbols_in
from lagrange.mechanics.constraints.constrained_system import is_pfaffian
from lagrange.mechanics.constraints.kinematics import Configuration
from lagrange.mechanics.dynamics.limits import MOST_STATES_KEPT

T = TypeVar("T")


class Standing(Enum):
    """The relation of one equation to a system."""

    FOLLOWS = auto()
    CONSTRAINT = auto()  # it follows from the constraints alone, or is an identity
    REDUNDANT = auto()  # it follows already from earlier equations
    CONTRADICTS = auto()
    NOT_LINEAR = auto()  # in the accelerations


_RIGHT = (Standing.FOLLOWS, Standing.REDUNDANT)


@record
class EquationComparison:
    """The standing of each equation, and the number of independent equations that are missing."""

    standings: tuple[Standing, ...]
    missing: int

    @property
    def agree(self) -> bool:
        """Whether the two systems have the same solutions."""
        bad = {Standing.CONTRADICTS, Standing.NOT_LINEAR}
        return self.missing == 0 and not bad & set(self.standings)


@record
class System:
    """A system of equations of motion: each of `equations` is zero.

    multipliers  unknowns in addition to the accelerations: λ_j of the constraints, unknown forces
    """

    configuration: Configuration
    equations: tuple[sp.Expr, ...]
    multipliers: tuple[sp.Symbol, ...] = ()

    @property
    def accelerated_constraints(self) -> tuple[sp.Expr, ...]:
        """d/dt of the velocity form of each constraint."""
        return self.configuration.accelerated_constraints

    def moving(self, point: Point, symbols: Iterable[sp.Symbol]) -> Point:
        """The `state` at a point of the configuration: the same one for all answers, with what was evaluated there."""
        kept = self._moving.get(id(point))
        if kept is None:
            if len(self._moving) >= MOST_STATES_KEPT:
                self._moving.clear()
            kept = self._moving[id(point)] = point, random_state(point, self.configuration, symbols)
        return kept[1]

    @cached_property
    def _moving(self) -> dict[int, tuple[Point, Point]]:
        """The point with each id, and its state; an id is that of one point as long as the point is held."""
        return {}

    def rows(self, moving: Point, free: Sequence[sp.Symbol]) -> list[NumberRow]:
        """The rows of the constraints and equations at a state, over (free, multipliers, accelerations, 1)."""
        known = self._rows.get(id(moving))
        if known is None or known[0] is not moving:
            unknowns = (*self.multipliers, *self.configuration.slots.accelerations)
            derived = (*self.accelerated_constraints, *self.equations)
            if len(self._rows) >= MOST_STATES_KEPT:
                self._rows.clear()
            nothing = [moving.number(0)] * (len(unknowns) + 1)
            rows = [nothing if row is None else row for row in moving.affine_each(derived, unknowns)]
            known = self._rows[id(moving)] = moving, rows
        return [[*(moving.number(0) for _ in free), *row] for row in known[1]]

    @cached_property
    def _rows(self) -> dict[int, tuple[Point, list[NumberRow]]]:
        return {}

    def spaces(self, moving: Point, known: Sequence[NumberRow], free: int) -> tuple[RowSpace, RowSpace, int]:
        """The row spaces of `known`, the rows at a state, and of the constraints among them, and the number of
        independent equations in them; kept with the state unless an answer has unknown forces of its own."""
        kept = self._spaces.get(id(moving))
        if free or kept is None or kept[0] is not moving:
            constraints = known[: len(self.accelerated_constraints)]
            needed = _rank_without(moving, [*known], free + len(self.multipliers))
            kept = moving, (RowSpace(moving.arithmetic, known), RowSpace(moving.arithmetic, constraints), needed)
            if free:
                return kept[1]
            if len(self._spaces) >= MOST_STATES_KEPT:
                self._spaces.clear()
            self._spaces[id(moving)] = kept
        return kept[1]

    @cached_property
    def _spaces(self) -> dict[int, tuple[Point, tuple[RowSpace, RowSpace, int]]]:
        return {}


def compare(answer: Sequence[sp.Expr], system: System, free: Sequence[sp.Symbol] = ()) -> EquationComparison | None:
    """Compare the equations `answer` (each zero) with a system. None: undecided.

    free  unknown forces that only the answer contains; they are eliminated from it

    Raises DivisionByZeroError if the answer divides by an expression that is exactly zero.
    """
    every = (*answer, *system.equations, *system.accelerated_constraints)
    symbols = symbols_of(every)
    compared = agreed(
        system.configuration.states,
        lambda moving: _compared(moving, answer, system, free),
        every,
        lambda comparison: Standing.CONTRADICTS in comparison.standings,
        lambda point: system.moving(point, symbols),
    )
    if compared is None or len(answer) < 2 or not any(e.has(sp.Abs, sp.sign) for e in every):
        return compared
    if Standing.CONTRADICTS not in compared.standings:
        return compared
    # The first contradiction decided: of m y'' = m g − c y'² and m y'' = m g + c y'² each is false for one sense.
    standings = [
        Standing.CONTRADICTS if s in _RIGHT and _contradicts(e, system, free) else s
        for e, s in zip(answer, compared.standings, strict=True)
    ]
    return replace(compared, standings=tuple(standings))


def _contradicts(equation: sp.Expr, system: System, free: Sequence[sp.Symbol]) -> bool:
    alone = compare([equation], system, free)
    return alone is not None and alone.standings == (Standing.CONTRADICTS,)


def compare_really(
    answer: Sequence[sp.Expr], system: System, free: Sequence[sp.Symbol], values: Mapping[sp.Symbol, sp.Float]
) -> EquationComparison | None:
    """The same at states with real values, where some symbols have values of eighty digits. None: undecided."""
    configuration = system.configuration
    symbols = symbols_of((*answer, *system.equations, *system.accelerated_constraints))

    def at(point: Point) -> EquationComparison:
        moving = random_state(point, configuration, symbols)
        given = {s: point.arithmetic.float(v) for s, v in values.items()}
        return _compared(moving.with_values(given), answer, system, free)

    try:
        first, second = configuration.states.sampled(at, 2, real=True)
    except (NoPointError, UnsupportedError):
        return None
    return first if first == second else None


def agreed_in_motion(
    configuration: Configuration,
    evaluate: Callable[[Point], T],
    expressions: Sequence[sp.Expr],
) -> T | None:
    """The value of `evaluate` at random states of motion, if all agree (`agreed`). Raises DivisionByZeroError."""
    symbols = symbols_of(expressions)
    states = configuration.states
    return agreed(states, evaluate, expressions, lambda _: False, lambda p: random_state(p, configuration, symbols))


def symbols_of(expressions: Iterable[sp.Expr]) -> tuple[sp.Symbol, ...]:
    """The symbols of several expressions, in a fixed order."""
    return tuple(sorted(set().union(*(symbols_in(e) for e in expressions)), key=lambda s: s.name))


def random_state(point: Point, configuration: Configuration, symbols: Iterable[sp.Symbol]) -> Point:
    """The point of `configuration.states` with velocities that satisfy A q' + a_t = 0 and are random otherwise.

    All `symbols` have their values afterwards, so that points made from it share them.
    """
    slots, rows = configuration.slots, configuration.rows
    for s in symbols:
        point.input(s)
    if not is_pfaffian(rows):
        return point  # its velocities satisfy the constraints already
    velocities: list[Any] = [point.random() for _ in slots.velocities]
    if rows:
        a = [point.values(r.coefficients) for r in rows]
        minus = [point.arithmetic.reduce(-point.value(r.drift)) for r in rows]
        solution = point.solution(a, minus, velocities)
        if solution is None:
            raise ContradictionError
        velocities = solution
    return point.with_values(dict(zip(slots.velocities, velocities, strict=True)))


class ContradictionError(Exception):
    """No velocity satisfies the constraints. `classify` has already refused such systems."""


def affine_rows(point: Point, expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> list[list[Any]]:
    """The coefficients of the unknowns and the constant of each expression, shape (m, len(unknowns) + 1).

    The expressions are derived equations, which are affine in accelerations and multipliers.
    """
    rows = point.affine(expressions, unknowns)
    assert rows is not None
    return rows


def follow(
    configuration: Configuration,
    claims: Sequence[sp.Expr],
    known: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
) -> bool | None:
    """Whether expressions that vanish follow from others, all affine in the unknowns. None: undecided.

    Raises DivisionByZeroError.
    """

    def at(moving: Point) -> bool:
        rows = affine_rows(moving, (*known, *claims), unknowns)
        return bool(moving.rank(rows) == moving.rank(rows[: len(known)]))

    return agreed_in_motion(configuration, at, (*known, *claims))


def _compared(
    moving: Point, answer: Sequence[sp.Expr], system: System, free: Sequence[sp.Symbol]
) -> EquationComparison:
    eliminated = len(free) + len(system.multipliers)
    unknowns = (*free, *system.multipliers, *system.configuration.slots.accelerations)
    known = system.rows(moving, free)
    affine = moving.affine_each(answer, unknowns)
    zero = [moving.number(0)] * (len(unknowns) + 1)
    rows = [zero if row is None else row for row in affine]
    constraints = known[: len(system.accelerated_constraints)]
    all_known, bound, needed = system.spaces(moving, known, len(free))
    spaces = _Spaces(moving, constraints, all_known, bound)
    standings = [
        Standing.NOT_LINEAR if linear is None else spaces.standing(row, len(free))
        for row, linear in zip(rows, affine, strict=True)
    ]
    _judge_free(moving, standings, rows, spaces.known, len(free))
    counted = [r for r, s in zip(rows, standings, strict=True) if s in _COUNTED]
    reached = _rank_without(moving, [*constraints, *counted], eliminated)
    return EquationComparison(tuple(standings), max(0, needed - reached))


_COUNTED = (Standing.FOLLOWS, Standing.CONSTRAINT, Standing.REDUNDANT)


class _Spaces:
    """The row spaces of the derived equations, of the constraints, and of these with the answer so far."""

    def __init__(self, point: Point, constraints: Sequence[NumberRow], known: RowSpace, bound: RowSpace) -> None:
        self._vanishes = point.arithmetic.vanishes
        self.known = known
        self._constraints = bound
        self._answered = RowSpace(point.arithmetic, constraints)

    def standing(self, row: NumberRow, free: int) -> Standing:
        """The standing of one row of an answer, given the earlier ones."""
        adds = self._answered.add(row)
        if any(not self._vanishes(x) for x in row[:free]):
            return Standing.FOLLOWS  # judged together with the others, once the free unknowns are eliminated
        if row not in self.known:
            return Standing.CONTRADICTS
        if row in self._constraints:
            return Standing.CONSTRAINT
        return Standing.FOLLOWS if adds else Standing.REDUNDANT


def _rank_without(point: Point, rows: list[list[Any]], eliminated: int) -> int:
    """The number of independent equations after eliminating the first unknowns."""
    head = [row[:eliminated] for row in rows]
    return point.rank(rows) - (point.rank(head) if eliminated else 0)


def _judge_free(
    point: Point,
    standings: list[Standing],
    rows: list[list[Any]],
    known: RowSpace,
    free: int,
) -> None:
    """Mark equations with free unknowns as contradicting if a combination without these unknowns contradicts."""
    if not free:
        return
    using = [n for n, row in enumerate(rows) if any(not point.arithmetic.vanishes(x) for x in row[:free])]
    chosen = [rows[n] for n in using]
    if not chosen:
        return
    transposed = [list(column) for column in zip(*(row[:free] for row in chosen), strict=True)]
    for combination in point.nullspace(transposed, len(chosen)):
        row = [
            point.arithmetic.reduce(sum(c * r[k] for c, r in zip(combination, chosen, strict=True)))
            for k in range(len(chosen[0]))
        ]
        if row not in known:
            for n, c in zip(using, combination, strict=True):
                if not point.arithmetic.vanishes(c):
                    standings[n] = Standing.CONTRADICTS
