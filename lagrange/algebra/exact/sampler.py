"""Generic points of the surface that the geometric constraints cut out.

Ranks, Frobenius' condition and verdicts are statements about points with f_1 = ... = f_m = 0; off that surface they
can be wrong: with z = 0, the form dx + y z du is dx. The constraints are solved one after the other, exactly, over a
random prime field (`triangular`, `solved_blocks`), and where that fails by Newton's iteration in real numbers of
eighty digits (`real_points`). Where both fail there are no points, and the question is undecided.

A point lies on either branch of a square root, at random. Points are numbered: the first ones are kept, with all
values computed at them, so that one random point serves all the expressions of a problem.

The signs that a value depends on, whether sample points have met them all, and real points where signs change.

Roots √A_1, ..., √A_k whose radicands are independent modulo squares define one irreducible variety: what is zero at
one generic point of it is zero everywhere, with every choice of signs (Kummer). They are independent as soon as no
product of some of the A_i has been a square at every point tried, that is, as soon as the Legendre symbols at several
points, as vectors over F_2, have rank k. What the rank falls short of (√(x²), √A √B √(A B), nested roots) are ambiguous
signs: the canonical root is ±R with a sign that changes at random from point to point. |a|, sign(a) and `Sign` symbols
have a sign that can be read at the point; all patterns of these that occur must have been met.

In real numbers |a| = a holds where a > 0, and random points may all lie there: |x − 1000| = 1000 − x for all small x.
Before something is called zero for all real values, the places where its signs change are therefore sought by the
secant rule along random lines q + s v, with one symbol moving or all of them,

    s_{n+1} = s_n − a(s_n) (s_n − s_{n−1})/(a(s_n) − a(s_{n−1})),

and points on either side are tried. A sign that changes only in a small region, |x² + y² − 1/100|, is met at an
extremum of a, to which parabolas through three points lead.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import count, islice
from random import Random
from typing import Any, TypeVar

import sympy as sp

from lagrange.algebra.exact.expression_graph import DivisionByZeroError, Graph, Nodes, Op
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.limits import (
    DRAWS,
    FARTHEST_WALL,
    FIELDS,
    FIRST_WIDE_POINT,
    KEPT_POINTS,
    LINES_PER_WALL,
    MOST_MISSING_POINTS,
    MOST_TRIES,
    NEWTON_STARTS,
    PARABOLA_ROUNDS,
    POINTS_PER_FIELD,
    REAL_DRAWS,
    REDRAWS,
    SECANT_STEPS,
    SPREAD,
    SPREAD_ON_SURFACE,
    WIDE_SPREAD,
)
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.points_needed import (
    MOST_COMBINED_SIGNS,
    POINTS_PER_SIGN_PATTERN,
    ZERO_DIVISIONS,
    ZERO_DIVISIONS_WITH_SIGNS,
)
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


# Sign regions


def points_beside_walls(start: RealPoint, wall: int, symbols: Sequence[sp.Symbol]) -> Iterator[Point]:
    """Points on either side of places where the node `wall` is zero, near lines through a point.

    symbols  those that may be moved; only those of the node are
    """
    moving = [s for s in symbols if start.graph.symbols[wall] & start.graph.bit(s)]
    # Single symbols first: |x − 1000| changes its sign along x, and the other symbols keep their usual size.
    lines = [[s] for s in moving[:LINES_PER_WALL]]
    if len(moving) > 1:
        lines.append(moving)
    for line in lines:
        yield from _beside(start, wall, {s: start.random() for s in line})
    yield from _towards_extremum(start, wall, moving)


def _towards_extremum(start: RealPoint, wall: int, symbols: Sequence[sp.Symbol]) -> Iterator[Point]:
    """The point, moved to where parabolas have their vertices, one symbol after the other."""
    point: Point = start
    h = start.number(1, 100)
    for _ in range(PARABOLA_ROUNDS):
        for symbol in symbols:
            direction = {symbol: start.number(1)}
            try:
                below, here, above = (_moved(point, direction, s).at(wall) for s in (-h, start.number(0), h))
                curvature = below - 2 * here + above
                if curvature:
                    point = _moved(point, direction, h * (below - above) / (2 * curvature))
            except InadmissibleError:
                continue
        yield point


def _beside(start: RealPoint, wall: int, direction: dict[sp.Symbol, Any]) -> Iterator[Point]:
    try:
        place = _zero_along(start, wall, direction)
    except InadmissibleError:
        return
    if place is None:
        return
    # Close enough that no other sign changes in between as a rule, far enough for values to be no zeros.
    step = (1 + abs(place)) / 1000
    for s in (place - step, place + step):
        try:
            yield _moved(start, direction, s)
        except InadmissibleError:
            continue


def _zero_along(start: RealPoint, wall: int, direction: dict[sp.Symbol, Any]) -> Any:
    """The parameter at which the node vanishes along a line, or None."""
    s, last = start.number(0), start.number(1, 7)
    value, last_value = (_moved(start, direction, x).at(wall) for x in (s, last))
    for _ in range(SECANT_STEPS):
        if abs(value) < start.number(1, 10**12):
            return s
        if value == last_value:
            return None
        s, last = s - value * (s - last) / (value - last_value), s
        value, last_value = _moved(start, direction, s).at(wall), value
    return s if abs(value) < start.number(1, 10**6) else None


def _moved(start: Point, direction: dict[sp.Symbol, Any], s: Any) -> Point:
    """The point at parameter s of the line. Raises InadmissibleError far away, or for a wrong sign."""
    if abs(s) > FARTHEST_WALL:
        raise InadmissibleError
    values = {symbol: start.input(symbol) + s * v for symbol, v in direction.items()}
    if any(symbol.is_nonnegative and value <= 0 for symbol, value in values.items()):
        raise InadmissibleError
    return start.with_values(values)


class Branches:
    """The signs that some nodes depend on.

    ambiguous  how many signs of roots cannot be read at a point
    walls      nodes that change their sign where one of the signs changes
    """

    def __init__(
        self,
        graph: Nodes,
        nodes: Sequence[int],
        draw: Callable[[], FieldPoint],
        ranks: dict[tuple[int, ...], int] | None = None,
    ) -> None:
        """The signs on which some nodes depend; `ranks` has those of radicands that were looked at before."""
        ranks = {} if ranks is None else ranks
        needed = [n for n in graph.needed(nodes) if n in graph.branching]
        self._graph = graph
        self._readable = [n for n in needed if graph.operations[n] != Op.ROOT]
        symbols = 0
        for n in nodes:
            symbols |= graph.symbols[n]
        self._signs: list[sp.Symbol] = [s for s, bit in graph.bits.items() if isinstance(s, Sign) and bit & symbols]
        radicands = {graph.data[n][0] for n in needed if graph.operations[n] == Op.ROOT}
        # The criterion is about radicands that are rational at the point; a root within a root stays ambiguous.
        plain = sorted(n for n in radicands if not graph.branching.intersection(graph.order(n)))
        if (place := tuple(plain)) not in ranks:
            ranks[place] = _independent(plain, draw)
        self.ambiguous = len(radicands) - ranks[place]
        changing = [graph.data[n][0] for n in self._readable]
        self.walls = [*changing, *(sorted(radicands) if self.ambiguous else ())]
        self._patterns: dict[int, None] = {}
        self._met = 0

    @property
    def signs(self) -> int:
        """How many signs there are, of both kinds."""
        return self.ambiguous + len(self._readable) + len(self._signs)

    def meet(self, point: Point) -> None:
        """Count a point."""
        self._met += 1
        negative = [self._is_negative_at(point, n) for n in self._readable]
        negative += [point.input(s) != point.number(1) for s in self._signs]
        self._patterns[sum(bit << n for n, bit in enumerate(negative))] = None

    def _is_negative_at(self, point: Point, node: int) -> bool:
        """Whether the argument of |a| or sign(a) is negative."""
        if self._graph.operations[node] == Op.SIGN:
            return bool(point.at(node) != point.number(1))
        return bool(point.at(node) != point.at(self._graph.data[node][0]))

    @property
    def met(self) -> int:
        """How many points have been counted."""
        return self._met

    @property
    def each_met(self) -> bool:
        """Whether every sign that can be read has been met both ways, though not with every other one."""
        readable = len(self._readable) + len(self._signs)
        # A bit is set once its sign differs from that in the first pattern.
        changed = 0
        for p in self._patterns:
            changed |= p ^ next(iter(self._patterns))
        return changed == (1 << readable) - 1

    def complete(self, at_least: int) -> bool:
        """Whether the points met suffice: every pattern has occurred, and each ambiguous sign by chance."""
        # Readable signs are seen to have been met; ambiguous ones are met by chance, with twenty points for each
        # combination.
        most = POINTS_PER_SIGN_PATTERN << min(self.signs, MOST_COMBINED_SIGNS)
        if self._met >= max(most, at_least):
            return True
        if self._met < at_least or (
            self.ambiguous and self._met < POINTS_PER_SIGN_PATTERN << min(self.ambiguous, MOST_COMBINED_SIGNS)
        ):
            return False
        return self._all_patterns_met()

    def _all_patterns_met(self) -> bool:
        readable = len(self._readable) + len(self._signs)
        patterns = list(self._patterns)
        if len(patterns) == 1 << readable:
            return True
        # Signs may depend on one another, |x| on |x y| |y|: what occurs is an affine space over F_2.
        dimension = _rank([p ^ patterns[0] for p in patterns])
        return self._met >= POINTS_PER_SIGN_PATTERN + readable and len(patterns) == 1 << dimension


def _independent(radicands: Sequence[int], draw: Callable[[], FieldPoint]) -> int:
    """The rank of the Legendre symbols of the radicands at several points."""
    # The Legendre symbol is multiplicative: a product of radicands that is a square everywhere is a row relation mod 2.
    vectors: list[int] = []
    best = 0
    for _ in range(POINTS_PER_SIGN_PATTERN + len(radicands)):
        if best == len(radicands):
            break
        point = draw()
        try:
            negative = [point.field.sign(point.at(n)) == -1 for n in radicands]
        except InadmissibleError:
            continue
        vectors.append(sum(bit << n for n, bit in enumerate(negative)))
        best = _rank(vectors)
    return best


def _rank(vectors: Sequence[int]) -> int:
    """The rank over F_2 of rows given as the bits of integers."""
    basis: list[int] = []
    for v in vectors:
        for b in basis:
            v = min(v, v ^ b)
        if v:
            basis.append(v)
    return len(basis)
