"""Points with real values of eighty digits, the second opinion; and Newton's iteration onto a constraint surface.

A value above 10^-42 is certainly not zero; one below 10^-60 counts as zero; a value in between is undecidable, and the
point is not used. Zero must therefore come from terms that cancel, never from a small factor: where a product, a power
or an exponential of what is not zero falls below 10^-42, the point is not used either, and e^x is taken only for
|x| < 60, so that rounding stays below 10^-42 too. Square roots and logarithms of negative numbers, |angle| > 10^6 and
powers above 10^4 make a point inadmissible, which bounds the time of every evaluation.

Newton's iteration solves f + (∂f/∂q) Δq = 0 with the smallest Δq,

    Δq = −Jᵀ y,      J Jᵀ y = f,      J = ∂f/∂q of shape (m, n).

The coordinates move, the parameters keep their random values. With redundant constraints J Jᵀ is singular, and any y
will do. Reference: Gauss–Newton for underdetermined systems in any book on numerical analysis.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from math import isfinite
from operator import mul
from random import Random
from typing import Any, Self

import sympy as sp
from mpmath.ctx_mp import MPContext

from lagrange.algebra.exact import points
from lagrange.algebra.exact.expression_graph import DivisionByZeroError, Graph, GraphTerm, UnsupportedError
from lagrange.algebra.exact.limits import (
    FEWEST_ROUGH_STEPS,
    HIGHEST_REAL_POWER,
    LARGEST_REAL_ANGLE,
    LARGEST_REAL_EXPONENT,
    LARGEST_ROUNDED,
    LEAST_ROUGH_PIVOT,
    NEWTON_STEPS,
)
from lagrange.algebra.exact.points import Operation, Point
from lagrange.algebra.exact.points_needed import NONZERO_DIGITS, REAL_DIGITS, ZERO_DIGITS
from lagrange.algebra.exact.prime_field import InadmissibleError, ZeroDivisorError
from lagrange.core.symbols import Bounded, partial

_mp = MPContext()
_mp.dps = REAL_DIGITS
_TINY = _mp.mpf(10) ** -ZERO_DIGITS
_SMALL = _mp.mpf(10) ** -NONZERO_DIGITS


class Reals:
    """Real numbers of eighty digits."""

    exact = False

    def __init__(self, random: Random) -> None:
        self.random = random

    def number(self, numerator: int, denominator: int = 1) -> Any:
        """A rational number."""
        return _mp.mpf(numerator) / denominator

    def float(self, x: sp.Float) -> Any:
        """A number of SymPy's."""
        return _mp.make_mpf(x._mpf_)

    def reduce(self, x: Any) -> Any:
        """The number itself."""
        return x

    def less(self, row: Sequence[Any], factor: Any, other: Sequence[Any]) -> list[Any]:
        """row − factor · other."""
        return [x - factor * y if y else x for x, y in zip(row, other, strict=True)]  # sparse in a large system

    def inverse(self, x: Any) -> Any:
        """1/x. Raises ZeroDivisorError."""
        if self.vanishes(x):
            raise ZeroDivisorError
        return 1 / x

    def vanishes(self, x: Any) -> bool:
        """Whether x is 0. Raises InadmissibleError when it is too small to decide."""
        if abs(x) > _SMALL:
            return False
        if abs(x) < _TINY:
            return True
        raise InadmissibleError

    def root(self, x: Any) -> Any:
        """√x. Raises InadmissibleError, also where x is rounding: 10^-80 has the root 10^-40, which is not zero."""
        if x == 0 or x >= _TINY:
            return _mp.sqrt(x)
        if x > 0:
            raise InadmissibleError
        if self.vanishes(x):
            return _mp.mpf(0)
        raise InadmissibleError

    def sample(self, spread: int = 2) -> Any:
        """A random number of either sign."""
        size = self.positive_sample(spread)
        return size if self.random.getrandbits(1) else -size

    def positive_sample(self, spread: int = 2) -> Any:
        """A random positive number e^s, -spread < s < spread: 0.14 ... 7.4 by default."""
        return _mp.exp(spread * (_mp.mpf(self.random.getrandbits(256)) / 2**255 - 1))


class RealPoint(Point):
    """A point whose values are real numbers, e^-spread ... e^spread where they are free."""

    def __init__(self, graph: Graph, reals: Reals, signs: int = 0, spread: int = 2) -> None:
        super().__init__(graph, reals, signs)
        self.reals = reals
        self.spread = spread
        self.assigned[sp.pi] = +_mp.pi

    def move(self, values: Mapping[sp.Symbol, Any]) -> None:
        """Give symbols other values for good."""
        self.assigned.update(values)
        self._values.clear()

    def vanishes(self, node: int) -> bool:
        """Whether a node is zero; "not zero" is measured by the largest number that went in.

        Raises InadmissibleError.
        """
        sizes = (v for n in self.graph.order(node) if not isinstance(v := self._values[n], tuple))
        return self.is_difference_zero(self.at(node), sizes)

    def is_difference_zero(self, difference: Any, sizes: Iterable[Any]) -> bool:
        """The same of a difference: 0.0004 between numbers of 10^75 may be what rounding has left."""
        size = abs(difference)
        if size > _SMALL * max(1, *map(abs, sizes)):
            return False
        if size < _TINY:
            return True
        raise InadmissibleError

    def set_angle(self, symbol: sp.Symbol, pair: tuple[Any, Any], depth: int) -> None:
        """Give a symbol the value v with (cos, sin)(v/depth) = pair."""
        self.assign(symbol, _mp.atan2(pair[1], pair[0]) * depth)

    def function_key(self, node: int) -> Any:
        """The key in `functions` of the value of an UNSPECIFIED node."""
        name, needs = self.graph.data[node]
        return name, tuple([_rounded(self.at(n)) for n in needs])

    def turned(self, terms: tuple[GraphTerm, ...], n: int, d: int) -> tuple[Any, Any]:
        """Cosine and sine of Σ terms + π n/d."""
        value = self.total(terms) + _mp.pi * n / d
        if abs(value) > LARGEST_REAL_ANGLE:
            raise InadmissibleError
        return _mp.cos(value), _mp.sin(value)

    def total(self, terms: tuple[GraphTerm, ...]) -> Any:
        """Σ terms."""
        return sum((self.at(m) * n / d for m, n, d in terms), _mp.mpf(0))

    def _drawn(self, symbol: sp.Symbol) -> Any:
        if isinstance(symbol, Bounded):
            part = _mp.mpf(self.reals.random.getrandbits(256) + 1) / (2**256 + 1)
            digits = REAL_DIGITS + 5
            low, high = (self.reals.float(sp.Float(end.evalf(digits), digits)) for end in (symbol.low, symbol.high))
            return low + (high - low) * part
        if symbol.is_nonnegative:
            return self.reals.positive_sample(self.spread)
        if symbol.is_nonpositive:
            return -self.reals.positive_sample(self.spread)
        return self.reals.sample(self.spread)

    def _blank(self) -> Self:
        return type(self)(self.graph, self.reals, self.signs, self.spread)


def symmetric_eigensystem(matrix: list[list[Any]]) -> tuple[Any, Any]:
    """The eigenvalues of a symmetric matrix, and a matrix whose columns are orthonormal eigenvectors."""
    values, vectors = _mp.eigsy(_mp.matrix(matrix))
    return values, vectors


def exponential(value: Any) -> Any:
    """e^value. Raises InadmissibleError if it is very large or very small."""
    if abs(value) > LARGEST_REAL_EXPONENT:
        raise InadmissibleError
    return _mp.exp(value)


def _rounded(x: Any) -> int:
    # Equal arguments computed in two ways differ in their last digits, and must still have the same function value.
    if abs(x) > LARGEST_ROUNDED:
        raise InadmissibleError
    return int(_mp.nint(x * 10**NONZERO_DIGITS))


# What each node does: (point, values of the nodes so far, data of the node) -> value.


def _number(point: RealPoint, _: list[Any], data: Any) -> Any:
    return point.reals.number(*data)


def _sum(_: RealPoint, v: list[Any], data: Any) -> Any:
    return _mp.fsum([v[n] for n in data])


def _product(_: RealPoint, v: list[Any], data: Any) -> Any:
    factors = [v[n] for n in data]
    product = _mp.fprod(factors)
    # A form times e^x was called zero at x = −150: smallness is no cancellation.
    if abs(product) < _SMALL and all(abs(f) > _SMALL for f in factors):
        raise InadmissibleError
    return product


def _plain_product(_: RealPoint, v: list[Any], data: Any) -> Any:
    return _mp.fprod([v[n] for n in data])


def _power(point: RealPoint, v: list[Any], data: Any) -> Any:
    base, exponent = v[data[0]], data[1]
    return _bounded(point.reals.inverse(base) if exponent < 0 else base, abs(exponent))


def _root(point: RealPoint, v: list[Any], data: Any) -> Any:
    base, n, d = v[data[0]], data[1], data[2]
    if n < 0:
        base, n = point.reals.inverse(base), -n
    root = point.reals.root(base)
    return _bounded(root if d == 2 else _mp.root(base if base > 0 else 0, d), n)


def _bounded(base: Any, exponent: int) -> Any:
    if exponent > HIGHEST_REAL_POWER:
        raise InadmissibleError
    power = base**exponent
    if abs(power) < _SMALL < abs(base):
        raise InadmissibleError
    return power


def _tangent(point: RealPoint, v: list[Any], data: Any) -> Any:
    cosine, sine = v[data[0]]
    return sine * point.reals.inverse(cosine)


def _exponential(point: RealPoint, _: list[Any], data: Any) -> Any:
    return exponential(point.total(data[0]))


def _hyperbolic_cosine(_: RealPoint, v: list[Any], data: Any) -> Any:
    return (v[data[0]] + 1 / v[data[0]]) / 2


def _hyperbolic_sine(_: RealPoint, v: list[Any], data: Any) -> Any:
    return (v[data[0]] - 1 / v[data[0]]) / 2


def _hyperbolic_tangent(_: RealPoint, v: list[Any], data: Any) -> Any:
    return 1 - 2 / (v[data[0]] ** 2 + 1)


def _growth(point: RealPoint, v: list[Any], data: Any) -> Any:
    base, terms = data
    point.require_positive(v[base])
    return exponential(point.total(terms) * _mp.log(v[base]))


def _function(_: RealPoint, v: list[Any], data: Any) -> Any:
    name, needs = data
    first = v[needs[0]]
    if name == "log" and first <= 0:
        raise InadmissibleError
    if name in ("asin", "acos") and 1 - abs(first) < _TINY:  # beside ±1 rounding is magnified as by a root
        raise InadmissibleError
    return getattr(_mp, name)(*[v[n] for n in needs])


def _unspecified(point: RealPoint, v: list[Any], data: Any) -> Any:
    name, needs = data
    key = (name, tuple([_rounded(v[n]) for n in needs]))
    if key not in point.functions:
        point.functions[key] = point.reals.sample()
    return point.functions[key]


def _absolute(_: RealPoint, v: list[Any], data: Any) -> Any:
    return abs(v[data[0]])


def _signum(point: RealPoint, v: list[Any], data: Any) -> Any:
    x = v[data[0]]
    return point.number(0 if point.reals.vanishes(x) else 1 if x > 0 else -1)


_OPERATIONS: tuple[Operation, ...] = (
    _number,
    points.symbol,
    _sum,
    _product,
    _power,
    _root,
    points.angle,
    points.cosine,
    points.sine,
    _tangent,
    _exponential,
    _hyperbolic_cosine,
    _hyperbolic_sine,
    _hyperbolic_tangent,
    _growth,
    _function,
    _unspecified,
    _absolute,
    _signum,
)
RealPoint.operations = _OPERATIONS

# On the way to a position where several angles vanish their product is soon small, which decides nothing there.
_APPROXIMATE = tuple(_plain_product if operation is _product else operation for operation in _OPERATIONS)


def newton_point(point: RealPoint, constraints: Sequence[sp.Expr], coordinates: Sequence[sp.Symbol]) -> bool:
    """Move the coordinates of a point onto the surface; whether that succeeded. The point is changed."""
    if not constraints:
        return True
    try:
        graph = point.graph
        residual = [graph.node(f) for f in constraints]
        jacobian = [[graph.node(partial(f, q)) for q in coordinates] for f in constraints]
        return _iterate(point, residual, jacobian, coordinates)
    except (InadmissibleError, UnsupportedError, DivisionByZeroError):
        return False


def _iterate(
    point: RealPoint, residual: list[int], jacobian: list[list[int]], coordinates: Sequence[sp.Symbol]
) -> bool:
    values = [point.input(q) for q in coordinates]
    # Far below what counts as zero, and above the rounding of the last step.
    tiny = point.number(1, 10 ** (REAL_DIGITS - 8))
    for _ in range(NEWTON_STEPS):
        trial = point.with_values(dict(zip(coordinates, values, strict=True)))
        trial.operations = _APPROXIMATE
        f = [trial.at(n) for n in residual]
        if max(abs(x) for x in f) < tiny:
            point.move(dict(zip(coordinates, values, strict=True)))
            return True
        J = [[trial.at(n) for n in row] for row in jacobian]
        step = _rough_step(J, f) or _smallest_step(trial, J, f)
        if step is None:
            return False
        values = [x + dx for x, dx in zip(values, step, strict=True)]
    return False


def _rough_step(J: list[list[Any]], f: list[Any]) -> list[Any] | None:
    """The smallest step in numbers of sixteen digits; None where these do not suffice.

    It takes a few steps more, of which each is ten times as fast in a large closed chain. How far the point is from the
    surface is measured in eighty digits all the same.
    """
    m, n = len(J), len(J[0])
    if not FEWEST_ROUGH_STEPS <= m <= n:
        return None
    entries = [[(k, float(x)) for k, x in enumerate(row) if x] for row in J]
    known = [dict(row) for row in entries]
    try:
        work = [
            [*(sum(x * s[k] for k, x in row if k in s) for s in known), float(z)]
            for row, z in zip(entries, f, strict=True)
        ]
        for c in range(m):
            best = max(range(c, m), key=lambda r: abs(work[r][c]))
            if not abs(work[best][c]) > LEAST_ROUGH_PIVOT * sum(x * x for x in known[c].values()):
                return None
            work[c], work[best] = work[best], work[c]
            top = work[c]
            for row in work[c + 1 :]:
                if row[c]:
                    factor = row[c] / top[c]
                    row[c:] = [x - factor * y for x, y in zip(row[c:], top[c:], strict=True)]
        y = [0.0] * m
        for c in reversed(range(m)):
            y[c] = (work[c][m] - sum(x * z for x, z in zip(work[c][c + 1 : m], y[c + 1 :], strict=True))) / work[c][c]
    except (OverflowError, ZeroDivisionError):
        return None
    step = [0.0] * n
    for sparse, z in zip(entries, y, strict=True):
        for k, x in sparse:
            step[k] -= x * z
    return [_mp.mpf(x) for x in step] if all(map(isfinite, step)) else None


def _smallest_step(point: Any, J: list[list[Any]], f: list[Any]) -> list[Any] | None:
    """The smallest dx with J dx = −f; None if there is none. J of shape (m, n), f of shape (m,).

    It is −Jᵀ y with J Jᵀ y = f. Where there are more equations than unknowns Jᵀ J dx = −Jᵀ f is the smaller system; it
    always has solutions, which have to be tried, unless J is so steep that rounding leaves none.
    """
    m, n = len(J), len(J[0])
    if m <= n:
        y = point.solution(_products(J), f)
        return None if y is None else [-sum(row[k] * y[i] for i, row in enumerate(J)) for k in range(n)]
    columns = [[row[k] for row in J] for k in range(n)]
    step = point.solution(_products(columns), [-sum(map(mul, column, f)) for column in columns])
    if step is None:
        return None
    zero = point.number(1, 10**ZERO_DIGITS) * (1 + max(map(abs, f)))
    return step if all(abs(sum(map(mul, row, step)) + x) < zero for row, x in zip(J, f, strict=True)) else None


def _products(rows: list[list[Any]]) -> list[list[Any]]:
    """Rows times rows; symmetric, and each constraint contains few of the coordinates of a large system."""
    entries = [{k: x for k, x in enumerate(row) if x} for row in rows]
    products = [[_mp.mpf(0)] * len(rows) for _ in rows]
    for m, r in enumerate(entries):
        for n in range(m + 1):
            s = entries[n]
            products[m][n] = products[n][m] = sum((x * s[k] for k, x in r.items() if k in s), _mp.mpf(0))
    return products
