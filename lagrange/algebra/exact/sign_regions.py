"""The signs that a value depends on, whether sample points have met them all, and real points where signs change.

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
from typing import Any

import sympy as sp

from lagrange.algebra.exact.expression_graph import Nodes, Op
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.limits import FARTHEST_WALL, LINES_PER_WALL, PARABOLA_ROUNDS, SECANT_STEPS
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.points_needed import MOST_COMBINED_SIGNS, POINTS_PER_SIGN_PATTERN
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.algebra.exact.real_points import RealPoint
from lagrange.core.symbols import Sign


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
