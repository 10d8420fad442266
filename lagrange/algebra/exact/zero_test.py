"""Is it zero? What is the rank? Do two systems agree? Answered exactly, or "undecided", and never guessed.

An expression is evaluated at random points of a random prime field, on the surface of the geometric constraints. A
rational function of the exact class (`expression_graph`) that does not vanish at one such point is not zero. One of
degree d that vanishes is zero, up to the probabilities that

    the point is a zero of it:       d/2^88; in angles, which are among 2^54 points of the circle or more, d/2^53;
    the prime divides all of it:     2^-46 for every 88 bits of its coefficients.

The points of one question share their prime: two of them square the first probability and leave the second
(`points_needed`). Where values depend on signs (`sampler`), the points must meet all of them:

    zero at all points: zero;   at none: not zero;   at some: real numbers of eighty digits decide.

Opaque functions (atan, log, ...) may hide identities: all derivatives must vanish, and real values too. `None` means
undecided and never False. References: Schwartz 1980, Zippel 1979; Gonnet 1984 and 1986 for roots and transcendental
functions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import islice
from typing import TypeAlias, TypeVar

import sympy as sp

from lagrange.algebra.exact.expression_graph import OPAQUE, DivisionByZeroError, UnsupportedError
from lagrange.algebra.exact.field_points import FieldPoint
from lagrange.algebra.exact.limits import DERIVATIVE_DEPTH, MOST_KEPT_NODES
from lagrange.algebra.exact.points import Point
from lagrange.algebra.exact.points_needed import (
    AGREEMENT_POINTS,
    AGREEMENT_POINTS_WITH_SIGNS,
    AGREEMENT_REAL_POINTS,
    FEW_SIGNS,
    MOST_POINTS_FOR_FEW_SIGNS,
    POINTS_FOR_MANY_SIGNS,
    REAL_POINTS_WHERE_SIGNS_DIFFER,
    STARTS_PER_WALL,
    WALLS_VISITED,
    ZERO_POINTS,
    ZERO_POINTS_AFTER_ROOTS,
    ZERO_REAL_POINTS,
)
from lagrange.algebra.exact.prime_field import (
    Fields,
    InadmissibleError,
    PrimeField,
    ZeroDivisorError,
    process_fields,
    reconstructed,
)
from lagrange.algebra.exact.real_points import RealPoint
from lagrange.algebra.exact.sampler import Branches, NoPointError, Sampler, points_beside_walls
from lagrange.core.effort import remembered

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
    "agreed",
    "are_equal",
    "has_real_point",
    "is_zero",
    "kept_surface",
    "process_fields",
    "rank",
    "reconstructed",
]


T = TypeVar("T")
Rows: TypeAlias = "sp.MatrixBase | Sequence[Sequence[sp.Expr]]"


class Surface(Sampler):
    """The generic points of the geometric constraints, and what holds at them. Arguments: see `Sampler`."""

    def is_zero(self, expression: sp.Expr) -> bool | None:
        """Whether an expression is zero everywhere on the surface. None: undecided.

        Raises DivisionByZeroError when a denominator is zero everywhere.
        """
        return self._is_zero(sp.sympify(expression, strict=True), DERIVATIVE_DEPTH)

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

    def _rank(self, nodes: list[int], width: int) -> int | None:
        def at(point: Point) -> int:
            values = [point.at(n) for n in nodes]
            return point.rank([values[n : n + width] for n in range(0, len(values), width)])

        # Without points in a field there are real ones only: the same rank at all of them, or undecided.
        if not self.exact:
            return _common_rank(self.sampled(at, ZERO_REAL_POINTS))
        # A minor that vanishes by chance lowers a rank; nothing raises it. So the largest is right, and where it cannot
        # be larger no other point is needed.
        marks = self.graph.marked(nodes)
        largest = min(width, len(nodes) // width)
        ranks, branches = self.on_all_branches(nodes, at, lambda rank: rank < largest or bool(marks))
        if not branches.signs and not marks & OPAQUE:
            return max(ranks)
        # Where all branches in the field have the same rank, real points only confirm it (as in `agreed`).
        same = len(set(ranks)) == 1 and not marks & OPAQUE
        real = _common_rank(self.sampled(at, AGREEMENT_REAL_POINTS if same else ZERO_REAL_POINTS, real=True))
        return real if real in ranks else None

    def _is_zero(self, e: sp.Expr, derivatives: int) -> bool | None:
        if e == 0:
            return True
        try:
            node = self.graph.node(e)
            verdict = self._vanishes(node) if self.exact else self._vanishes_really(node, ())
        except (UnsupportedError, NoPointError):
            return None
        except _HangsOnDerivativesError:
            # On a surface ∂f/∂q = 0 would have to hold along it only, and the symbols are not independent there.
            if derivatives == 0 or self.constraints:
                return None
            symbols = sorted(e.free_symbols, key=str)
            return True if all(self._is_zero(e.diff(s), derivatives - 1) for s in symbols) else None
        return verdict

    def _vanishes(self, node: int) -> bool | None:
        """Whether a node is zero on the surface."""

        def at(point: Point) -> bool:
            return bool(point.arithmetic.vanishes(point.at(node)))

        # The first value that is not zero ends the search: without signs it is a proof.
        zeros, branches = self.on_all_branches([node], at, lambda zero: zero)
        opaque = bool(self.graph.marks[node] & OPAQUE)
        # Roots whose sign cannot be read, √(x²), are random in the field. Real points know the sign, and may refute.
        if all(zeros):
            return not branches.ambiguous or self._vanishes_really(node, branches.walls) is not False
        if not branches.signs and not opaque:
            return False
        really = self._vanishes_really(node, branches.walls)
        if really is False:
            return False
        # atan and log are random functions in the field: not zero there may still be an identity, such as log(x y) =
        # log x + log y. Differentiation removes them, and real values fix the constant.
        if opaque:
            if really:
                raise _HangsOnDerivativesError
            return None
        # Zero on some branches of the field and at all real points: the canonical roots took a branch that real numbers
        # do not have. Zero on none of them although the reals agree: a contradiction, hence undecided.
        zeros, _ = self.on_all_branches([node], at, lambda _: True)
        if any(zeros):
            return really
        return False if really is None else None

    def on_all_branches(
        self,
        nodes: Sequence[int],
        at: Callable[[Point], T],
        go_on: Callable[[T], bool],
        prepare: Callable[[Point], Point] = lambda point: point,
        enough: Callable[[Branches], bool] = lambda _: False,
    ) -> tuple[list[T], Branches]:
        """The results of `at` at points that meet all signs of the nodes, or until `go_on` returns False.

        prepare  applied to each point first (the velocities that constraints admit): signs are read at its result
        enough   whether the points met suffice although they have not met all signs

        Raises DivisionByZeroError, NoPointError, UnsupportedError.
        """
        # Square roots put points on one of several components of the surface: two points are too few to meet them.
        branches = Branches(self.graph, nodes, self._new_point, self._ranks_of_roots)
        least = ZERO_POINTS_AFTER_ROOTS if self.has_roots else ZERO_POINTS

        def met(point: Point) -> T:
            moved = prepare(point)
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
        """Whether a node vanishes at real points, including points near sign changes (`walls`).

        False is certain, True to sixty digits; None: there are no such points.
        """

        def at(point: Point) -> bool:
            return isinstance(point, RealPoint) and point.vanishes(node)

        try:
            if not all(islice(self.results(at, real=True), ZERO_REAL_POINTS)):
                return False
            # Random reals are between 10^-6 and 10^5 at best; a sign that changes elsewhere must be sought.
            for wall in walls[:WALLS_VISITED]:
                for number in range(STARTS_PER_WALL):
                    start = self.real_point(number)
                    for point in points_beside_walls(start, wall, self.loose_symbols(wall)):
                        if not _holds(at, point):
                            return False
        except NoPointError:
            return None
        return True


class _HangsOnDerivativesError(Exception):
    """The value is zero at real points; the derivatives must decide whether it is zero everywhere."""


def kept_surface(constraints: Iterable[sp.Expr] = (), coordinates: Iterable[sp.Symbol] = ()) -> Surface:
    """A surface that is kept as long as the allowance lasts, with its points and what was worked out at them.

    A number of which a field needs a root would restrict the fields of all questions, and so would many expressions
    fill the memory: then a new one is taken.
    """
    key = kept_surface, tuple(constraints), tuple(coordinates)
    surface: Surface | None = remembered().get(key)
    if surface is None or surface.graph.squares or len(surface.graph.operations) > MOST_KEPT_NODES:
        surface = remembered()[key] = Surface(*key[1:])
    return surface


def is_zero(expression: sp.Expr, surface: Surface | None = None) -> bool | None:
    """`Surface.is_zero`, by default on no surface."""
    return (surface or kept_surface()).is_zero(expression)


def vanishes(expression: sp.Expr) -> bool:
    """Whether an expression is zero for certain; what divides by zero is not."""
    try:
        return is_zero(expression) is True
    except DivisionByZeroError:
        return False


def are_equal(a: sp.Expr, b: sp.Expr, surface: Surface | None = None) -> bool | None:
    """`Surface.are_equal`, by default on no surface."""
    return (surface or kept_surface()).are_equal(a, b)


def rank(rows: Rows, surface: Surface | None = None) -> int | None:
    """`Surface.rank`, by default on no surface."""
    return (surface or kept_surface()).rank(rows)


def has_real_point(surface: Surface) -> bool:
    """Whether a real point of a surface was found; by Newton's iteration, so that True is certain."""
    try:
        surface.real_point()
    except NoPointError:
        return False
    return True


def _holds(at: Callable[[Point], bool], point: Point) -> bool:
    """The answer at a point; True where the point is inadmissible."""
    try:
        return at(point)
    except InadmissibleError:
        return True


def _common_rank(values: Sequence[int]) -> int | None:
    """The common value of all, or None."""
    return values[0] if len(set(values)) == 1 else None


def agreed(
    surface: Surface,
    evaluate: Callable[[Point], T],
    expressions: Iterable[sp.Expr],
    settles: Callable[[T], bool] = lambda _: False,
    prepare: Callable[[Point], Point] = lambda point: point,
) -> T | None:
    """The result of `evaluate` at random points of a surface, if all agree; None if they do not: undecided.

    expressions  those that it evaluates
    settles      whether one real point with this result is enough, as a counterexample is
    prepare      applied to each point before it is evaluated: makes a state of motion of it

    Where the expressions have branches (roots, absolute values) a prime field picks them at random, so that points are
    taken until all signs have been met, and points with real values must agree with them. Where those in the field
    differ among themselves, the real ones decide, as many as it takes to meet the branches. Raises DivisionByZeroError.
    """
    try:
        nodes = [surface.graph.node(e) for e in expressions]
        # Without marks all points are alike, and three that agree decide; more where the surface may have components.
        if any(surface.graph.marks[n] for n in nodes):
            results = _on_branches(surface, evaluate, nodes, prepare)
        else:
            number = ZERO_POINTS_AFTER_ROOTS if surface.has_roots else AGREEMENT_POINTS
            results = surface.sampled(lambda p: evaluate(prepare(p)), number)
            if _unanimous(results) or not surface.has_roots:
                return _common(results)
        # In the field a root takes either sign at random. Where results differ, the answer depends on the branch, and
        # only real points are on the right one.
        same = _unanimous(results)
        number = AGREEMENT_REAL_POINTS if same else REAL_POINTS_WHERE_SIGNS_DIFFER
        real = []
        for result in islice(surface.results(lambda p: evaluate(prepare(p)), real=True), number):
            if settles(result):
                return result
            real.append(result)
        return _common([*real, *(results if same else [])])
    except (NoPointError, UnsupportedError):
        return None


def _on_branches(
    surface: Surface, evaluate: Callable[[Point], T], nodes: list[int], prepare: Callable[[Point], Point]
) -> list[T]:
    """The results at points that meet all signs, or until two of them differ.

    Of many signs each is met both ways, but not each with every other one: a term of a sum depends on its own.
    """
    if not surface.exact:
        return surface.sampled(lambda p: evaluate(prepare(p)), REAL_POINTS_WHERE_SIGNS_DIFFER)
    before: list[T] = []

    def go_on(result: T) -> bool:
        before.append(result)
        return _unanimous(before)

    results, _ = surface.on_all_branches(nodes, evaluate, go_on, prepare, _are_enough)
    if _unanimous(results) and len(results) < AGREEMENT_POINTS_WITH_SIGNS:
        results += surface.sampled(lambda p: evaluate(prepare(p)), AGREEMENT_POINTS_WITH_SIGNS - len(results))
    return results


def _are_enough(branches: Branches) -> bool:
    if branches.signs <= FEW_SIGNS:
        return branches.met >= MOST_POINTS_FOR_FEW_SIGNS
    return branches.met >= POINTS_FOR_MANY_SIGNS or (branches.met >= AGREEMENT_POINTS_WITH_SIGNS and branches.each_met)


def _common(results: list[T]) -> T | None:
    return results[0] if _unanimous(results) else None


def _unanimous(results: list[T]) -> bool:
    return all(f == results[0] for f in results)
