"""Points over a random prime field, at which expressions are evaluated exactly.

Angles are kept by value: where the monomial m has the residue v, e^{im} is a random point w of the unit circle that
belongs to v from then on, and e^{icm} = w^c. Equal arguments therefore have equal cosines however they are written.
θ/2 may occur after θ, because w is drawn from a part of the circle in which fractions exist and are unique; an angle
for which a constraint was solved has its fractions at some of the points only.

Exponentials are kept by value too, as random squares, and so are undefined functions: f(a) = f(b) exactly where a = b.
"""

from __future__ import annotations

from itertools import islice
from math import lcm
from typing import Any, Self, cast

import sympy as sp

from lagrange.algebra.exact import points
from lagrange.algebra.exact.expression_graph import Graph, GraphTerm
from lagrange.algebra.exact.limits import LARGEST_ANGLE_RATIO, MOST_COMPARED_ANGLES
from lagrange.algebra.exact.points import Operation, Point
from lagrange.algebra.exact.prime_field import Circle, PrimeField, ZeroDivisorError, reconstructed


class CirclePoint:
    """A point of the circle, e^{iv/depth} for a residue v; `free` if all its fractions exist uniquely."""

    __slots__ = ("depth", "free", "root")

    def __init__(self, root: Circle, depth: int = 1, free: bool = True) -> None:
        self.root = root
        self.depth = depth
        self.free = free

    def turned(self, field: PrimeField, n: int, d: int) -> Circle:
        """The point of n/d times the angle. Raises InadmissibleError."""
        if d < 0:
            n, d = -n, -d
        if self.free:
            return field.circle_fraction(self.root, n, d)
        if self.depth % d:
            step = lcm(self.depth, d) // self.depth
            self.root, self.depth = field.circle_root(self.root, step), self.depth * step
        return field.circle_power(self.root, n * (self.depth // d))


class FieldPoint(Point):
    """A point whose values are residues mod p."""

    def __init__(self, graph: Graph, field: PrimeField, signs: int = 0) -> None:
        super().__init__(graph, field, signs)
        self.field = field
        self.p = field.p
        self.angles: dict[int, tuple[CirclePoint, int, int]] = {}
        self._turned: dict[tuple[int, int, int], Circle] = {}

    def reconstructed(self, residue: int) -> sp.Rational | None:
        """The small fraction with this residue, or None."""
        fraction = reconstructed(residue, self.p)
        return None if fraction is None else sp.Rational(fraction.numerator, fraction.denominator)

    def set_angle(self, symbol: sp.Symbol, pair: Circle, depth: int) -> None:
        """Give a symbol a random value and its angle: e^{iv/depth} = pair."""
        value = self.assigned[symbol] = self._drawn(symbol)
        self.angles[value] = (CirclePoint(pair, depth, free=False), 1, 1)

    def function_key(self, node: int) -> Any:
        """The key in `functions` of the value of an UNSPECIFIED node."""
        name, needs = self.graph.data[node]
        return name, tuple([self.at(n) for n in needs])

    def turned(self, terms: tuple[GraphTerm, ...], n: int, d: int) -> Circle:
        """e^{i(Σ terms + π n/d)}."""
        result: Circle | None = None
        for term in terms:
            factor = self._circle(*term)
            result = factor if result is None else self.field.times(result, factor)
        if n:
            turn = self.field.unity(n, 2 * d)
            result = turn if result is None else self.field.times(result, turn)
        return result or (1, 0)

    def function_value(self, name: Any, arguments: tuple[int, ...]) -> int:
        """The value of a function taken by value: random, the same for the same arguments."""
        key = (name, arguments)
        if key not in self.functions:
            self.functions[key] = self.field.sample()
        return cast(int, self.functions[key])

    def odd_function_value(self, name: str, argument: int) -> int:
        """The value of an odd function."""
        sign = self.field.sign(argument)
        return sign * self.function_value(name, (sign * argument % self.p,)) % self.p if sign else 0

    def exponential(self, terms: tuple[GraphTerm, ...], base: int = 0) -> int:
        """e^{Σ terms}, or base^{Σ terms}: for each monomial a random square, to a rational power."""
        result = 1
        for m, n, d in terms:
            v = self._values[m]
            if v:
                key = ("exp", base, v)
                if key not in self.functions:
                    self.functions[key] = pow(self.field.sample(), 2, self.p)
                result = result * self.field.power(self.functions[key], n, d) % self.p
        return result

    def _circle(self, m: int, n: int, d: int) -> Circle:
        """e^{i n v/d} for the value v of a monomial."""
        v = self.at(m)
        key = (v, n, d)
        if key not in self._turned:
            if v == 0:
                return 1, 0
            angle, a, b = self.angles.get(v) or self._new_angle(v, self.graph.marks[m] != 0)
            self._turned[key] = angle.turned(self.field, n * a, d * b)
        return self._turned[key]

    def _new_angle(self, v: int, may_be_dependent: bool) -> tuple[CirclePoint, int, int]:
        """A multiple of a known angle, or a new one; `may_be_dependent`: any small ratio is looked for, not only −1."""
        # cos(a − b) and cos(b − a) both occur, so that −v is always looked up. Other ratios can only arise where values
        # are marked, √(k/m) t beside √(4k/m) t: different monomials of symbols are independent.
        if self.p - v in self.angles:
            angle, a, b = self.angles[self.p - v]
            multiple = (angle, -a, b)
        else:
            multiple = (self._multiple(v) if may_be_dependent else None) or (
                CirclePoint(self.field.random_circle()),
                1,
                1,
            )
        self.angles[v] = multiple
        return multiple

    def _multiple(self, v: int) -> tuple[CirclePoint, int, int] | None:
        inverse = pow(v, -1, self.p)
        for other, (angle, a, b) in islice(self.angles.items(), MOST_COMPARED_ANGLES):
            ratio = reconstructed(other * inverse, self.p, LARGEST_ANGLE_RATIO)
            if ratio:
                return angle, a * ratio.denominator, b * ratio.numerator
        return None

    def _drawn(self, symbol: sp.Symbol) -> int:
        value = self.field.sample()
        # Squares only for symbols of known sign: if all symbols were squares, |u| − u would vanish at every point.
        if symbol.is_nonnegative:
            return value * value % self.p
        if symbol.is_nonpositive:
            return -value * value % self.p
        return value

    def _blank(self) -> Self:
        other = type(self)(self.graph, self.field, self.signs)
        other.angles, other._turned = self.angles, self._turned
        return other


# What each node does: (point, values of the nodes so far, data of the node) -> value.


def _number(point: FieldPoint, _: list[Any], data: Any) -> int:
    return point.field.number(*data)


def _sum(point: FieldPoint, v: list[Any], data: Any) -> Any:
    return sum([v[n] for n in data]) % point.p


def _product(point: FieldPoint, v: list[Any], data: Any) -> Any:
    p = point.p
    result = v[data[0]]
    for n in data[1:]:
        result = result * v[n] % p
    return result


def _power(point: FieldPoint, v: list[Any], data: Any) -> int:
    base, exponent = v[data[0]], data[1]
    if exponent < 0 and base == 0:
        raise ZeroDivisorError
    return cast(int, pow(base, exponent, point.p))


def _root(point: FieldPoint, v: list[Any], data: Any) -> int:
    return point.field.power(v[data[0]], data[1], data[2])


def _tangent(point: FieldPoint, v: list[Any], data: Any) -> Any:
    cosine, sine = v[data[0]]
    return sine * point.field.inverse(cosine) % point.p


def _exponential(point: FieldPoint, _: list[Any], data: Any) -> int:
    return point.exponential(data[0])


def _hyperbolic_cosine(point: FieldPoint, v: list[Any], data: Any) -> Any:
    e = v[data[0]]
    return (e + point.field.inverse(e)) * point.field.number(1, 2) % point.p


def _hyperbolic_sine(point: FieldPoint, v: list[Any], data: Any) -> Any:
    e = v[data[0]]
    return (e - point.field.inverse(e)) * point.field.number(1, 2) % point.p


def _hyperbolic_tangent(point: FieldPoint, v: list[Any], data: Any) -> Any:
    square = v[data[0]] ** 2
    return (square - 1) * point.field.inverse(square + 1) % point.p


def _growth(point: FieldPoint, v: list[Any], data: Any) -> int:
    base, terms = data
    point.require_positive(v[base])
    return point.exponential(terms, v[base])


def _function(point: FieldPoint, v: list[Any], data: Any) -> int:
    name, needs = data
    first, *rest = (v[n] for n in needs)
    if name in ("atan", "asin"):
        return point.odd_function_value(name, first)
    if name == "atan2" and rest[0]:
        # The angle of (x, y) depends on y/x and on the sign of x.
        rest = [point.field.sign(rest[0]), first * point.field.inverse(rest[0]) % point.p]
        first = 0
    return point.function_value(name, (first, *rest))


def _unspecified(point: FieldPoint, v: list[Any], data: Any) -> int:
    return point.function_value(data[0], tuple([v[n] for n in data[1]]))


def _absolute(point: FieldPoint, v: list[Any], data: Any) -> Any:
    return v[data[0]] * point.field.sign(v[data[0]]) % point.p


def _signum(point: FieldPoint, v: list[Any], data: Any) -> int:
    return point.field.sign(v[data[0]]) % point.p


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
FieldPoint.operations = _OPERATIONS
