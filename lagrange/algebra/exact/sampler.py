"""Generic points of the surface that geometric constraints cut out.

Ranks, Frobenius conditions and verdicts are statements about points with f_1 = ... = f_m = 0; off that
surface they can be wrong: with z = 0, the form dx + y z du is dx. The constraints are solved one after the
other, exactly, over a random prime field (`triangular`, `blocks`); what cannot be solved so, by Newton's
iteration in real numbers of eighty digits (`projection`). Where both fail there are no points, and the
question is undecided.

A point is on either branch of a square root, at random. Points have numbers: the first ones are kept, with
all values that were computed at them, so that one random point serves all the expressions of a problem.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import count, islice
from random import Random
from typing import TypeVar

import sympy as sp

from lagrange.algebra.exact.evaluation import Graph
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.graph import DivisionByZeroError, Op
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import Fields, InadmissibleError, ZeroDivisorError, process_fields
from lagrange.algebra.exact.projection import newton_point
from lagrange.algebra.exact.reals import RealPoint, Reals
from lagrange.algebra.exact.triangular import DRAWS, Order, contradiction, triangular_order
from lagrange.core.symbols import Sign, t

T = TypeVar("T")
AnyPoint = TypeVar("AnyPoint", bound=Point)

_FIELDS = 8
_POINTS_IN_A_FIELD = 4
_KEPT = 40
_REAL_DRAWS = 30
_NEWTON_STARTS = 8
_REDRAWS = 60
_SPREAD = 2
_WIDE_SPREAD = 12
_FIRST_WIDE_POINT = 6
_SPREAD_ON_A_SURFACE = 1
_MOST_NUMBERS_WITHOUT_POINT = 3
_ZERO_DIVISIONS = 4
_ZERO_DIVISIONS_OF_BRANCHES = 40


class NoPointError(Exception):
    """No admissible point was found."""


class Sampler:
    """The generic points with f = 0 for all constraints; without constraints, of the whole space.

    constraints  expressions in coordinates, t and parameters, each to be zero; no velocities
    coordinates  what they are solved for if possible
    fields       where the random prime fields come from (tests pass seeded ones)

    Symbols that the constraints do not fix, velocities and accelerations among them, have random values.
    """

    def __init__(
        self,
        constraints: Sequence[sp.Expr] = (),
        coordinates: Sequence[sp.Symbol] = (),
        *,
        fields: Fields | None = None,
    ) -> None:
        self.constraints = tuple(constraints)
        self.coordinates = tuple(coordinates)
        self.fields = fields or process_fields()
        self._points: dict[int, FieldPoint | None] = {}
        self._real_points: dict[int, RealPoint | None] = {}
        self._squares: frozenset[int] = frozenset()

    @cached_property
    def order(self) -> Order | None:
        """The constraints in triangular order, or None when no such order was found."""
        return triangular_order(self.constraints, self.coordinates, self._unconstrained)

    @cached_property
    def graph(self) -> Graph:
        """The nodes of all expressions that were evaluated on the surface."""
        graph = Graph(self.order.rules if self.order else None)
        self._fixed = graph.mask({s for f in self.constraints for s in f.free_symbols})
        return graph

    @property
    def exact(self) -> bool:
        """Whether points have residues (else they are real, if there are any)."""
        return self.order is not None

    def contradictory(self) -> tuple[int, ...]:
        """A smallest set of constraints (their places) that exclude one another, or () if none was found."""
        return () if self.exact else contradiction(self.constraints, self.coordinates, self._unconstrained)

    def point(self, number: int = 0) -> Point:
        """The point of this number: over a prime field, or real if the constraints cannot be solved in one.

        Raises NoPointError.
        """
        if self.order is None:
            return self.real_point(number)
        if self._squares != self.graph.squares:
            self._squares = self.graph.squares
            self._points.clear()
        return _kept(self._points, number, self.drawn)

    def real_point(self, number: int = 0) -> RealPoint:
        """A point with real values of eighty digits, with signs as the symbols say. Raises NoPointError."""
        return _kept(self._real_points, number, self._drawn_real)

    def points(self, first: int = 0) -> Iterator[Point]:
        """Points without end. Raises NoPointError when no more are found."""
        while True:
            yield self.point(first)
            first += 1

    def drawn(self, number: int = 0) -> FieldPoint | None:
        """A new point over a field; equal numbers modulo 32 give the same field."""
        field = self.fields.field(number // _POINTS_IN_A_FIELD % _FIELDS, self.graph.squares)
        return self.order.drawn(lambda: FieldPoint(self.graph, field, number), DRAWS) if self.order else None

    def results(self, evaluate: Callable[[Point], T], *, real: bool = False) -> Iterator[T]:
        """What `evaluate` gives at one point after the other, but those where it raises InadmissibleError.

        Raises DivisionByZeroError when a denominator vanishes at all points, NoPointError when too many fail,
        UnsupportedError.
        """
        zeros: dict[int, int] = {}
        failures = missing = 0
        for number in count():
            try:
                yield self._admissible(evaluate, number, real)
                failures, zeros = 0, {}
            except ZeroDivisorError as error:
                failures += 1
                if error.node is not None and number < failures:
                    zeros[error.node] = zeros.get(error.node, 0) + 1
                    _report_division(self.graph, error.node, zeros[error.node])
            except InadmissibleError:
                failures += 1
            except NoPointError:
                missing += 1
            if failures > DRAWS or missing >= _MOST_NUMBERS_WITHOUT_POINT:
                raise NoPointError

    def sampled(self, evaluate: Callable[[Point], T], number: int = 2, *, real: bool = False) -> list[T]:
        """The first so many `results`."""
        return list(islice(self.results(evaluate, real=real), number))

    def _admissible(self, evaluate: Callable[[Point], T], number: int, real: bool) -> T:
        """The result at one point, symbols under a root that does not exist being drawn again."""
        point = self.real_point(number) if real else self.point(number)
        for _ in range(_REDRAWS):
            try:
                result = evaluate(point)
            except ZeroDivisorError:
                raise
            except InadmissibleError as error:
                symbols = self._loose(point, error.node)
                if not symbols:
                    raise
                point = point.redrawn(symbols)
                continue
            self._keep(number, point)
            return result
        raise InadmissibleError

    def loose_symbols(self, node: int) -> list[sp.Symbol]:
        """The symbols of a node that the constraints leave free."""
        loose = self.graph.symbols[node] & ~self._fixed
        return [s for s, bit in self.graph.bits.items() if bit & loose and not isinstance(s, Sign)]

    def _loose(self, point: Point, node: int | None) -> list[sp.Symbol]:
        """The symbols of a node that can be drawn again: not on the surface, not under a root that exists."""
        if node is None:
            return []
        graph = self.graph
        fixed = self._fixed
        for n in graph.branching:
            # A root of more symbols may wait: that of A B exists once those of A and of B do.
            if point.has_value(n) and graph.symbols[n].bit_count() <= graph.symbols[node].bit_count():
                fixed |= graph.symbols[n]
        loose = graph.symbols[node] & ~fixed
        return [s for s, bit in graph.bits.items() if bit & loose and not isinstance(s, Sign)]

    def _keep(self, number: int, point: Point) -> None:
        if isinstance(point, FieldPoint) and number in self._points:
            self._points[number] = point
        elif isinstance(point, RealPoint) and number in self._real_points:
            self._real_points[number] = point

    def _unconstrained(self, graph: Graph) -> FieldPoint:
        return FieldPoint(graph, self.fields.field(0, graph.squares))

    def _drawn_real(self, number: int) -> RealPoint | None:
        spread = self._spread(number)

        def fresh() -> RealPoint:
            return RealPoint(self.graph, self._reals, number, spread)

        point = self.order.drawn(fresh, _REAL_DRAWS) if self.order else None
        if point is None and self._order_by_parameters:
            point = self._order_by_parameters.drawn(fresh, _REAL_DRAWS)
        if point is not None:
            return point
        starts = (fresh() for _ in range(_NEWTON_STARTS))
        return next((p for p in starts if newton_point(p, self.constraints, self.coordinates)), None)

    def _spread(self, number: int) -> int:
        """How far real values reach. Only later points are wide: they are for signs that change far away."""
        if self.constraints:
            return _SPREAD_ON_A_SURFACE
        return _WIDE_SPREAD if number >= _FIRST_WIDE_POINT and number % 2 else _SPREAD

    @cached_property
    def _order_by_parameters(self) -> Order | None:
        """Another order, with rods as long as they have to be: random lengths may not fit together."""
        symbols = {s for f in self.constraints for s in f.free_symbols}
        parameters = sorted(symbols - {*self.coordinates, t}, key=str)
        if self.order is None or not parameters:
            return None
        return triangular_order(self.constraints, (*parameters, *self.coordinates), self._unconstrained)

    @cached_property
    def _reals(self) -> Reals:
        return Reals(Random(self.fields.random.getrandbits(128)))


def _kept(known: dict[int, AnyPoint | None], number: int, draw: Callable[[int], AnyPoint | None]) -> AnyPoint:
    if number not in known:
        found = draw(number)
        if number < _KEPT:
            known[number] = found
    else:
        found = known[number]
    if found is None:
        raise NoPointError
    return found


def _report_division(graph: Graph, node: int, times: int) -> None:
    """A denominator that vanished at several points, on all branches if it has any, is zero."""
    if times < (_ZERO_DIVISIONS_OF_BRANCHES if graph.marks[node] else _ZERO_DIVISIONS):
        return
    data = graph.data[node]
    if graph.operations[node] in (Op.POWER, Op.ROOT):
        raise DivisionByZeroError(graph.expressions[data[0]])
    if graph.operations[node] == Op.TAN:
        raise DivisionByZeroError(sp.cos(graph.expressions[data[0]]))
    raise DivisionByZeroError(graph.expressions[node])
