"""A block of constraints solved for as many unknowns at one point.

At a point where everything else has a value, a constraint is a polynomial in the unknowns with numbers as coefficients.
An angle θ contributes C = cos θ/D, S = sin θ/D and C² + S² = 1; a root R = √u and a quotient W = 1/u of an unknown u
contribute R² = u and W u = 1. Row reduction with the highest monomials first exposes linear equations (two circles
about the same unknown point differ by a linear one); each is solved and substituted, until one quadratic equation is
left:

    (x − x1)² + (y − y1)² = a²,  (x − x2)² + (y − y2)² = b²    ->    y = α x + β    ->    A x² + B x + C = 0.

Its root exists at half of the points; the others are drawn again. Either root is taken at random.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from math import lcm
from typing import Any, cast

import sympy as sp

from lagrange.algebra.exact.expression_graph import Op
from lagrange.algebra.exact.limits import HIGHEST_BLOCK_POWER
from lagrange.algebra.exact.linear_algebra import NumberField, row_reduced
from lagrange.algebra.exact.points import Point
from lagrange.core.records import record

Monomial = tuple[int, ...]
NumericPolynomial = dict[Monomial, Any]
Pair = tuple[NumericPolynomial, NumericPolynomial]


class NotSolvableError(Exception):
    """These equations are not solved for these unknowns by linear algebra and one square root at a time."""


class ContradictoryError(Exception):
    """The equations lead to a number that would have to be zero and is not."""


@record
class SolvedBlock:
    """Constraints and what they are solved for: symbols, or undefined functions at their arguments."""

    constraints: tuple[sp.Expr, ...]
    unknowns: tuple[sp.Expr, ...]

    def solve(self, point: Point) -> int:
        """Give the unknowns values at a point; returns how many square roots were needed.

        Raises NotSolvableError, ContradictoryError, or InadmissibleError where another point may do.
        """
        nodes = [point.graph.node(f) for f in self.constraints]
        system = _System(point, nodes, self.unknowns)
        equations = [system.polynomial(n) for n in nodes] + system.equations
        values, roots = _solution(point.arithmetic, equations, system.size)
        system.assign(values)
        return roots


class _System:
    """The constraints of a block as polynomials with numbers as coefficients."""

    def __init__(self, point: Point, constraints: Sequence[int], unknowns: Sequence[sp.Expr]) -> None:
        self.point = point
        self.graph = point.graph
        self.size = 0
        self.equations: list[NumericPolynomial] = []
        self._known: dict[int, Any] = {}
        self._roots: list[int] = []
        self._variables: dict[int, int] = {}
        self._circles: dict[int, tuple[int, int]] = {}
        self._depths: dict[int, int] = {}
        nodes = [self.graph.node(u) for u in unknowns]
        affected = self._affected(constraints, set(nodes))
        for n in nodes:
            self._introduce(n, affected)
        for n in affected:
            self._known[n] = self._expanded(n)

    def assign(self, values: Sequence[Any]) -> None:
        """Give the unknowns their values."""
        point = self.point
        # R² = u has the solutions ±R, but √u is the one that is itself a square.
        for n in self._roots:
            point.arithmetic.root(values[n])
        for unknown, n in self._variables.items():
            if self.graph.operations[unknown] == Op.UNSPECIFIED:
                point.functions[point.function_key(unknown)] = values[n]
            else:
                point.assign(self.graph.data[unknown], values[n])
        for unknown, (c, s) in self._circles.items():
            point.set_angle(self.graph.data[unknown], (values[c], values[s]), self._depths[unknown])

    def polynomial(self, node: int) -> NumericPolynomial:
        """A node as a polynomial in the variables."""
        polynomial = self._known.get(node)
        if polynomial is None:
            polynomial = {(): self.point.at(node)}
        return cast(NumericPolynomial, polynomial)

    def _affected(self, constraints: Sequence[int], unknowns: set[int]) -> list[int]:
        """The nodes that depend on the unknowns, in order."""
        affected: set[int] = set()
        needed = self.graph.needed(constraints)
        for n in needed:
            if n in unknowns or any(m in affected for m in self.graph.needs[n]):
                affected.add(n)
        return [n for n in needed if n in affected]

    def _introduce(self, unknown: int, affected: list[int]) -> None:
        """Variables for an unknown: itself, or cosine and sine if it occurs in angles only."""
        graph = self.graph
        users = [n for n in affected if unknown in graph.needs[n]]
        angles = [n for n in users if graph.operations[n] == Op.ANGLE]
        if not angles:
            self._variables[unknown] = self._new()
            return
        # An unknown beside its own cosine, x + sin x = c, has no algebraic solution.
        if len(angles) < len(users) or graph.operations[unknown] != Op.SYMBOL:
            raise NotSolvableError
        self._depths[unknown] = lcm(*(d for n in angles for m, _, d in graph.data[n][0] if m == unknown))
        c, s = self._circles[unknown] = self._new(), self._new()
        self.equations.append({(c, c): self._one(), (s, s): self._one(), (): self.point.number(-1)})

    def _new(self) -> int:
        self.size += 1
        return self.size - 1

    def _one(self) -> Any:
        return self.point.number(1)

    def _expanded(self, n: int) -> Any:
        op, data = self.graph.operations[n], self.graph.data[n]
        if n in self._variables:
            return {(self._variables[n],): self._one()}
        match op:
            case Op.SYMBOL:
                return {}  # an angle: only its cosine and sine are used
            case Op.ADD:
                return self._sum([self.polynomial(m) for m in data])
            case Op.MULTIPLY:
                return reduce(self._product, (self.polynomial(m) for m in data))
            case Op.POWER:
                return self._power(self.polynomial(data[0]), data[1])
            case Op.ROOT:
                return self._root(self.polynomial(data[0]), data[1], data[2])
            case Op.ANGLE:
                return self._angle(*data)
            case Op.COS | Op.SIN:
                return self._known[data[0]][op == Op.SIN]
            case Op.TAN:
                cosine, sine = self._known[data[0]]
                return self._product(sine, self._power(cosine, -1))
        raise NotSolvableError

    def _sum(self, parts: Sequence[NumericPolynomial]) -> NumericPolynomial:
        total: NumericPolynomial = {}
        for part in parts:
            for monomial, c in part.items():
                total[monomial] = total[monomial] + c if monomial in total else c
        return _cleaned(self.point.arithmetic, total)

    def _product(self, a: NumericPolynomial, b: NumericPolynomial) -> NumericPolynomial:
        return _product(self.point.arithmetic, a, b)

    def _power(self, base: NumericPolynomial, exponent: int) -> NumericPolynomial:
        if exponent < 0:
            # 1/b is one more unknown w with b w = 1: a solution with b = 0 is then none.
            w = self._new()
            self.equations.append(self._sum([self._product(base, {(w,): self._one()}), {(): self.point.number(-1)}]))
            base, exponent = {(w,): self._one()}, -exponent
        if exponent > HIGHEST_BLOCK_POWER:
            raise NotSolvableError
        result: NumericPolynomial = {(): self._one()}
        for _ in range(exponent):
            result = self._product(result, base)
        return result

    def _root(self, base: NumericPolynomial, n: int, d: int) -> NumericPolynomial:
        if d > HIGHEST_BLOCK_POWER:
            raise NotSolvableError
        r = self._new()
        self._roots.append(r)
        minus = {m: self.point.arithmetic.reduce(-c) for m, c in base.items()}
        self.equations.append(self._sum([{(r,) * d: self._one()}, minus]))
        return self._power({(r,): self._one()}, n)

    def _angle(self, terms: Any, n: int, d: int) -> Pair:
        known = []
        pair: Pair = ({(): self._one()}, {})
        for m, a, b in terms:
            if m in self._circles:
                pair = self._times(pair, self._circle_power(m, a * (self._depths[m] // b)))
            elif m in self._known:  # it depends on an unknown, but is not one: cos(x²) is no polynomial in cos x
                raise NotSolvableError
            else:
                known.append((m, a, b))
        cosine, sine = self.point.turned(tuple(known), n, d)
        return self._times(pair, ({(): cosine}, {(): sine}))

    def _circle_power(self, unknown: int, n: int) -> Pair:
        if abs(n) > HIGHEST_BLOCK_POWER:
            raise NotSolvableError
        c, s = self._circles[unknown]
        generator: Pair = ({(c,): self._one()}, {(s,): self.point.number(1 if n > 0 else -1)})
        return reduce(self._times, [generator] * abs(n))

    def _times(self, a: Pair, b: Pair) -> Pair:
        minus = {m: self.point.arithmetic.reduce(-c) for m, c in b[1].items()}
        return (
            self._sum([self._product(a[0], b[0]), self._product(a[1], minus)]),
            self._sum([self._product(a[0], b[1]), self._product(a[1], b[0])]),
        )


def _cleaned(arithmetic: NumberField, p: NumericPolynomial) -> NumericPolynomial:
    reduced = {m: arithmetic.reduce(c) for m, c in p.items()}
    return {m: c for m, c in reduced.items() if not arithmetic.vanishes(c)}


def _product(arithmetic: NumberField, a: NumericPolynomial, b: NumericPolynomial) -> NumericPolynomial:
    result: NumericPolynomial = {}
    for m, c in a.items():
        for n, d in b.items():
            monomial = tuple(sorted(m + n))
            result[monomial] = result[monomial] + c * d if monomial in result else c * d
    return _cleaned(arithmetic, result)


def _solution(arithmetic: NumberField, equations: list[NumericPolynomial], size: int) -> tuple[list[Any], int]:
    """Values of all variables, and the number of square roots taken."""
    rules: list[tuple[int, NumericPolynomial]] = []
    free = set(range(size))
    roots = 0
    while True:
        equations = _echelon(arithmetic, equations)
        linear = [e for e in equations if max(map(len, e)) == 1]
        # A linear equation has one solution and excludes no point, and substituting it leaves fewer unknowns. A root is
        # taken only when none is left: it halves the points and doubles the branches.
        if linear:
            variable, rule = _linear_rule(arithmetic, linear[-1])
        elif equations:
            variable, rule, used = _next_rule(arithmetic, equations, len(free))
            roots += used
        else:
            break
        rules.append((variable, rule))
        free.discard(variable)
        equations = [_inserted(arithmetic, e, variable, rule) for e in equations]
    values = [arithmetic.sample() if n in free else None for n in range(size)]
    for variable, rule in reversed(rules):
        values[variable] = _value(arithmetic, rule, values)
    return values, roots


def _echelon(arithmetic: NumberField, equations: list[NumericPolynomial]) -> list[NumericPolynomial]:
    """The equations reduced, highest monomials first. Raises ContradictoryError when one reads 1 = 0."""
    # The highest monomials are eliminated first, so that equations of lower degree remain at the end.
    monomials = sorted({m for e in equations for m in e}, key=lambda m: (-len(m), m))
    zero = arithmetic.number(0)
    rows, _ = row_reduced(arithmetic, [[e.get(m, zero) for m in monomials] for e in equations])
    reduced = [_cleaned(arithmetic, dict(zip(monomials, row, strict=True))) for row in rows]
    if any(set(e) == {()} for e in reduced):
        raise ContradictoryError
    return [e for e in reduced if e]


def _linear_rule(arithmetic: NumberField, equation: NumericPolynomial) -> tuple[int, NumericPolynomial]:
    """x = ... from a linear equation."""
    lead = next(m for m in equation if m)
    scale = arithmetic.inverse(equation[lead])
    return lead[0], {m: arithmetic.reduce(-c * scale) for m, c in equation.items() if m != lead}


def _next_rule(
    arithmetic: NumberField, equations: list[NumericPolynomial], free: int
) -> tuple[int, NumericPolynomial, int]:
    """A quadratic equation in one variable solved, or a random value for a variable that is to spare."""
    for equation in equations:
        variables = {v for m in equation for v in m}
        if len(variables) == 1 and max(map(len, equation)) == 2:
            x = variables.pop()
            a, b, c = (equation.get((x,) * n, arithmetic.number(0)) for n in (2, 1, 0))
            root = arithmetic.root(arithmetic.reduce(b * b - 4 * a * c))
            # Both branches must occur: what holds on one of them only is not true of the surface.
            signed = root if arithmetic.random.getrandbits(1) else -root
            return x, {(): arithmetic.reduce((signed - b) * arithmetic.inverse(arithmetic.reduce(2 * a)))}, 1
    if free <= len(equations):
        raise NotSolvableError
    # A variable of which the square occurs is better solved for; another one is given a value.
    occurring = sorted({v for e in equations for m in e for v in m})
    spare = max(occurring, key=lambda v: (min(m.count(v) for e in equations for m in e if v in m), v))
    return spare, {(): arithmetic.sample()}, 0


def _inserted(
    arithmetic: NumberField, p: NumericPolynomial, variable: int, rule: NumericPolynomial
) -> NumericPolynomial:
    if not any(variable in m for m in p):
        return p
    total: NumericPolynomial = {}
    for monomial, c in p.items():
        part: NumericPolynomial = {tuple(v for v in monomial if v != variable): c}
        for _ in range(monomial.count(variable)):
            part = _product(arithmetic, part, rule)
        for m, d in part.items():
            total[m] = total[m] + d if m in total else d
    return _cleaned(arithmetic, total)


def _value(arithmetic: NumberField, p: NumericPolynomial, values: list[Any]) -> Any:
    total = arithmetic.number(0)
    for monomial, c in p.items():
        for v in monomial:
            c = arithmetic.reduce(c * values[v])
        total = total + c
    return arithmetic.reduce(total)
