"""Generic points of the surface that the geometric constraints cut out.

Ranks, Frobenius' condition and verdicts are statements about points with f_1 = ... = f_m = 0; off that surface they
can be wrong: with z = 0, the form dx + y z du is dx. The constraints are solved one after the other, exactly, over a
random prime field (`triangular`, `solved_blocks`), and where that fails by Newton's iteration in real numbers of
eighty digits (`real_points`). Where both fail there are no points, and the question is undecided.

A point lies on either branch of a square root, at random. Points are numbered: the first ones are kept, with all
values computed at them, so that one random point serves all the expressions of a problem.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import count, islice
from random import Random
from typing import TypeVar

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, Graph, Op
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.limits import (
    DRAWS,
    FIELDS,
    FIRST_WIDE_POINT,
    KEPT_POINTS,
    MOST_MISSING_POINTS,
    MOST_TRIES,
    NEWTON_STARTS,
    POINTS_PER_FIELD,
    REAL_DRAWS,
    REDRAWS,
    SPREAD,
    SPREAD_ON_SURFACE,
    WIDE_SPREAD,
)
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.points_needed import ZERO_DIVISIONS, ZERO_DIVISIONS_WITH_SIGNS
from lagrange.algebra.exact.prime_field import Fields, InadmissibleError, ZeroDivisorError, process_fields
from lagrange.algebra.exact.real_points import RealPoint, Reals, newton_point
from lagrange.algebra.exact.triangular import SolutionOrder, contradiction, triangular_order
from lagrange.core.symbols import Sign, t

T = TypeVar("T")
AnyPoint = TypeVar("AnyPoint", bound=Point)


class NoPointError(Exception):
    """No admissible point was found."""


class Sampler:
    """The generic points with f = 0 for all constraints; without constraints, of the whole space.

    constraints  expressions in coordinates, t and parameters, each to be zero; no velocities
    coordinates  solved for if possible
    fields       source of the random prime fields (tests pass seeded ones)

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
        self._ranks_of_roots: dict[tuple[int, ...], int] = {}

    @cached_property
    def order(self) -> SolutionOrder | None:
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

    @property
    def has_roots(self) -> bool:
        """Whether points come from square roots, each of which takes a branch of the surface at random."""
        return self.order is not None and self.order.roots > 0

    def contradictory(self) -> tuple[int, ...]:
        """A smallest set of constraints (their places) that exclude one another, or () if none was found."""
        return () if self.exact else contradiction(self.constraints, self.coordinates, self._unconstrained)

    def point(self, number: int = 0) -> Point:
        """The point of this number: over a prime field, or real if the constraints cannot be solved in one.

        Raises NoPointError.
        """
        if self.order is None:
            return self.real_point(number)
        # A new √29, say: fields in which 29 is no square are of no use any more, nor are their points.
        if self._squares != self.graph.squares:
            self._squares = self.graph.squares
            self._points.clear()
        return _kept(self._points, number, self.drawn)

    def real_point(self, number: int = 0) -> RealPoint:
        """A point with real values of eighty digits, of the signs that symbols declare. Raises NoPointError."""
        return _kept(self._real_points, number, self._drawn_real)

    def points(self, first: int = 0) -> Iterator[Point]:
        """Any number of points, one after another. Raises NoPointError when no more are found."""
        while True:
            yield self.point(first)
            first += 1

    def drawn(self, number: int = 0) -> FieldPoint | None:
        """A new point over a field; equal numbers modulo 32 give the same field."""
        field = self.fields.field(number // POINTS_PER_FIELD % FIELDS, self.graph.squares)
        return self.order.drawn(lambda: FieldPoint(self.graph, field, number), DRAWS) if self.order else None

    def results(self, evaluate: Callable[[Point], T], *, real: bool = False) -> Iterator[T]:
        """The results of `evaluate` at one point after the other, except where it raises InadmissibleError.

        Raises DivisionByZeroError when a denominator vanishes at all points, NoPointError when too many fail,
        UnsupportedError.
        """
        zeros: dict[int, int] = {}
        failures = missing = 0
        tries = count()  # at a point, or again with other values of some symbols
        last = 0
        for number in count():
            try:
                yield self._admissible(evaluate, number, real, tries)
                failures, zeros, last = 0, {}, next(tries)
            except ZeroDivisorError as error:
                failures += 1
                # Only a denominator that has vanished at every point so far may be zero; a later failure is chance.
                if error.node is not None and number < failures:
                    zeros[error.node] = zeros.get(error.node, 0) + 1
                    self._report_division(error.node, zeros[error.node])
            except InadmissibleError:
                failures += 1
            except NoPointError:
                missing += 1
            if failures > DRAWS or missing >= MOST_MISSING_POINTS or next(tries) - last > MOST_TRIES:
                raise NoPointError

    def _report_division(self, node: int, times: int) -> None:
        """A denominator that vanished at several points, on all branches if there are any, is zero."""
        # A root of the surface is taken at random too: on one component of a linkage that folds, links stay parallel.
        graph = self.graph
        has_branches = graph.marks[node] or self.has_roots
        if times < (ZERO_DIVISIONS_WITH_SIGNS if has_branches else ZERO_DIVISIONS):
            return
        data = graph.data[node]
        if graph.operations[node] in (Op.POWER, Op.ROOT):
            raise DivisionByZeroError(graph.expressions[data[0]])
        if graph.operations[node] == Op.TAN:
            raise DivisionByZeroError(sp.cos(graph.expressions[data[0]]))
        raise DivisionByZeroError(graph.expressions[node])

    def sampled(self, evaluate: Callable[[Point], T], number: int = 2, *, real: bool = False) -> list[T]:
        """The first so many `results`."""
        return list(islice(self.results(evaluate, real=real), number))

    def _admissible(self, evaluate: Callable[[Point], T], number: int, real: bool, tries: Iterator[int]) -> T:
        """The result at one point, symbols under a root that does not exist being drawn again."""
        # Only the symbols under the missing root are drawn again: k independent roots exist at 2^-k of the points.
        point = self.real_point(number) if real else self.point(number)
        for _ in range(REDRAWS):
            next(tries)
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
        # A symbol of the constraints would leave the surface; one of a root that exists might lose it again.
        loose = graph.symbols[node] & ~fixed
        return [s for s, bit in graph.bits.items() if bit & loose and not isinstance(s, Sign)]

    def _keep(self, number: int, point: Point) -> None:
        # With the symbols that were drawn again: the next expression finds its roots in place.
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

        # The triangular order first: it only takes roots. Newton's iteration is the last resort: it needs all the
        # derivatives in every step, may diverge, and proves nothing beyond the digits that it reached.
        point = self.order.drawn(fresh, REAL_DRAWS) if self.order else None
        if point is None and self._order_by_parameters:
            point = self._order_by_parameters.drawn(fresh, REAL_DRAWS)
        if point is not None:
            return point
        starts = (fresh() for _ in range(NEWTON_STARTS))
        return next((p for p in starts if newton_point(p, self.constraints, self.coordinates)), None)

    def _spread(self, number: int) -> int:
        """How far real values reach. Only later points are wide: they are for signs that change far away."""
        if self.constraints:
            return SPREAD_ON_SURFACE
        return WIDE_SPREAD if number >= FIRST_WIDE_POINT and number % 2 else SPREAD

    @cached_property
    def _order_by_parameters(self) -> SolutionOrder | None:
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
        point = draw(number)
        if number < KEPT_POINTS:
            known[number] = point
    else:
        point = known[number]
    if point is None:
        raise NoPointError
    return point
