"""Is it zero? What is the rank? Answered exactly, or "undecided" and never guessed.

An expression is evaluated at random points of a random prime field, on the surface of the geometric
constraints. A rational function of the exact class (`evaluation`) that does not vanish at one such point is
not zero. One of degree d that vanishes is zero, but for the chances that

    the point is a zero of it:       d/2^88; in angles, which are among 2^54 points of the circle or more, d/2^53;
    the prime divides all of it:     2^-46 for every 88 bits of its coefficients.

The points of one question share their prime: two of them square the first chance and leave the second. Where values
depend on signs (`branches`), the points must meet all of them, twenty points for each combination at most:

    zero at all points: zero;   at none: not zero;   at some: what real numbers of eighty digits say.

Opaque functions (atan, log, ...) may hide identities: all derivatives must vanish, and real values too.
`None` means undecided and never False. References: Schwartz 1980, Zippel 1979; Gonnet 1984 and 1986 for
roots and transcendental functions.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import islice
from typing import TypeAlias, TypeVar

import sympy as sp

from lagrange.algebra.exact.branches import Branches
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.graph import OPAQUE, DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.prime_field import (
    Fields,
    InadmissibleError,
    PrimeField,
    ZeroDivisorError,
    process_fields,
    reconstructed,
)
from lagrange.algebra.exact.reals import RealPoint
from lagrange.algebra.exact.sampler import NoPointError, Sampler
from lagrange.algebra.exact.walls import points_beside_walls

__all__ = [
    "DivisionByZeroError",
    "FieldPoint",
    "Fields",
    "InadmissibleError",
    "NoPointError",
    "Point",
    "PrimeField",
    "RealPoint",
    "Surface",
    "UnsupportedError",
    "ZeroDivisorError",
    "are_equal",
    "has_real_point",
    "is_zero",
    "process_fields",
    "rank",
    "reconstructed",
]

_POINTS = 2
_POINTS_WHERE_ROOTS_WERE_TAKEN = 10
_REAL_POINTS = 12
_DERIVATIVES = 4
_MOST_WALLS = 6
_STARTS = 4

T = TypeVar("T")
Rows: TypeAlias = "sp.MatrixBase | Sequence[Sequence[sp.Expr]]"


class Surface(Sampler):
    """The generic points of the geometric constraints, and what holds at them. Arguments: see `Sampler`."""

    def is_zero(self, expression: sp.Expr) -> bool | None:
        """Whether an expression is zero everywhere on the surface. None: undecided.

        Raises DivisionByZeroError when a denominator is zero everywhere.
        """
        return self._is_zero(sp.sympify(expression, strict=True), _DERIVATIVES)

    def are_equal(self, a: sp.Expr, b: sp.Expr) -> bool | None:
        """Whether two expressions are equal everywhere on the surface, as `is_zero`."""
        return self.is_zero(sp.Add(a, sp.Mul(-1, b)))

    def rank(self, rows: Rows) -> int | None:
        """The rank of a matrix, shape (m, n), at generic points of the surface. None: undecided.

        Raises DivisionByZeroError.
        """
        table = rows.tolist() if isinstance(rows, sp.MatrixBase) else [list(row) for row in rows]
        entries = [sp.sympify(e, strict=True) for row in table for e in row]
        if not entries:
            return 0
        try:
            nodes = [self.graph.node(e) for e in entries]
            return self._rank(nodes, len(entries) // len(table))
        except (UnsupportedError, NoPointError):
            return None

    def real_values(self, expressions: Sequence[sp.Expr]) -> dict[sp.Symbol, sp.Float]:
        """Random real values of all symbols of some expressions, at which these exist, on the surface.

        Positive symbols have positive values. Raises NoPointError, DivisionByZeroError, UnsupportedError.
        """
        symbols = sorted({s for e in expressions for s in e.free_symbols}, key=str)

        def values(point: Point) -> dict[sp.Symbol, sp.Float]:
            point.values(expressions)
            return {s: sp.Float(point.input(s), 50) for s in symbols}

        return self.sampled(values, 1, real=True)[0]

    def _rank(self, nodes: list[int], width: int) -> int | None:
        def at(point: Point) -> int:
            values = [point.at(n) for n in nodes]
            return point.rank([values[n : n + width] for n in range(0, len(values), width)])

        if not self.exact:
            return _common(self.sampled(at, _REAL_POINTS))
        ranks, branches = self.on_all_branches(nodes, at, lambda _: True)
        if not branches.signs and not self.graph.marked(nodes) & OPAQUE:
            return max(ranks)
        real = _common(self.sampled(at, _REAL_POINTS, real=True))
        return real if real in ranks else None

    def _is_zero(self, e: sp.Expr, derivatives: int) -> bool | None:
        if e == 0:
            return True
        try:
            node = self.graph.node(e)
            found = self._vanishes(node) if self.exact else self._vanishes_really(node, ())
        except (UnsupportedError, NoPointError):
            return None
        except _HangsOnDerivativesError:
            if derivatives == 0 or self.constraints:
                return None
            symbols = sorted(e.free_symbols, key=str)
            return True if all(self._is_zero(e.diff(s), derivatives - 1) for s in symbols) else None
        return found

    def _vanishes(self, node: int) -> bool | None:
        """Whether a node is zero on the surface."""

        def at(point: Point) -> bool:
            return bool(point.arithmetic.vanishes(point.at(node)))

        zeros, branches = self.on_all_branches([node], at, lambda zero: zero)
        opaque = bool(self.graph.marks[node] & OPAQUE)
        if all(zeros):
            return not branches.ambiguous or self._vanishes_really(node, branches.walls) is not False
        if not branches.signs and not opaque:
            return False
        really = self._vanishes_really(node, branches.walls)
        if really is False:
            return False
        if opaque:
            if really:
                raise _HangsOnDerivativesError
            return None
        zeros, _ = self.on_all_branches([node], at, lambda _: True)
        if any(zeros):
            return really
        return False if really is None else None

    def on_all_branches(
        self,
        nodes: Sequence[int],
        at: Callable[[Point], T],
        go_on: Callable[[T], bool],
        there: Callable[[Point], Point] = lambda point: point,
        enough: Callable[[Branches], bool] = lambda _: False,
    ) -> tuple[list[T], Branches]:
        """What `at` says at points that meet all signs of the nodes, or until `go_on` says no.

        there   what is made of a point before (the velocities that constraints admit): signs are read at that
        enough  whether the points met will do although they have not met all signs

        Raises DivisionByZeroError, NoPointError, UnsupportedError.
        """
        branches = Branches(self.graph, nodes, self._new_point)
        least = _POINTS_WHERE_ROOTS_WERE_TAKEN if self.order and self.order.roots else _POINTS

        def met(point: Point) -> T:
            moved = there(point)
            result = at(moved)
            branches.meet(moved)
            return result

        results: list[T] = []
        for result in self.results(met):
            results.append(result)
            if branches.complete(least) or enough(branches) or not go_on(result):
                break
        return results, branches

    def _new_point(self) -> FieldPoint:
        point = self.drawn(self.fields.random.getrandbits(16))
        if point is None:
            raise NoPointError
        return point

    def _vanishes_really(self, node: int, walls: Sequence[int]) -> bool | None:
        """Whether a node vanishes at real points, also beside walls (`walls`), where there are signs.

        False is certain, True to sixty digits; None: there are no such points.
        """

        def at(point: Point) -> bool:
            return isinstance(point, RealPoint) and point.vanishes(node)

        try:
            if not all(islice(self.results(at, real=True), _REAL_POINTS)):
                return False
            for wall in walls[:_MOST_WALLS]:
                for number in range(_STARTS):
                    start = self.real_point(number)
                    for point in points_beside_walls(start, wall, self.loose_symbols(wall)):
                        if not _holds(at, point):
                            return False
        except NoPointError:
            return None
        return True


class _HangsOnDerivativesError(Exception):
    """The value is zero at real points; whether it is everywhere, the derivatives must say."""


def is_zero(expression: sp.Expr, surface: Surface | None = None) -> bool | None:
    """`Surface.is_zero`, by default on no surface."""
    return (surface or Surface()).is_zero(expression)


def are_equal(a: sp.Expr, b: sp.Expr, surface: Surface | None = None) -> bool | None:
    """`Surface.are_equal`, by default on no surface."""
    return (surface or Surface()).are_equal(a, b)


def rank(rows: Rows, surface: Surface | None = None) -> int | None:
    """`Surface.rank`, by default on no surface."""
    return (surface or Surface()).rank(rows)


def has_real_point(surface: Surface) -> bool:
    """Whether a real point of a surface was found; by Newton's iteration, so that True is certain."""
    try:
        surface.real_point()
    except NoPointError:
        return False
    return True


def _holds(at: Callable[[Point], bool], point: Point) -> bool:
    """What is said at a point; True where nothing can be said."""
    try:
        return at(point)
    except InadmissibleError:
        return True


def _common(values: Sequence[int]) -> int | None:
    """The value that all are equal to."""
    return values[0] if len(set(values)) == 1 else None
