"""Points: values for all symbols at once, and the value of every expression there.

A point carries its arithmetic: residues of a random prime field (`field_points`) or reals of eighty digits
(`real_points`). Rows are reduced, ranks taken and systems solved with the same calls in both. A symbol gets its random
value when it is first needed: a square (a positive number) if it is positive, ±1 for a `Sign`, anything otherwise.

Equations that are affine in some unknowns u, e_i = Σ_k A_ik u_k + b_i, are read as rows [A | b] of numbers. A_ik is
the derivative of e_i with respect to u_k, found for all k by one backward pass through the graph.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Self, cast

import sympy as sp

from lagrange.algebra.exact import linear_algebra
from lagrange.algebra.exact.expression_graph import Graph, GraphTerm, Op
from lagrange.algebra.exact.limits import NODES_PER_UNIT, STEPS_OF_A_DECIMAL
from lagrange.algebra.exact.linear_algebra import NumberRow
from lagrange.algebra.exact.prime_field import InadmissibleError
from lagrange.core.effort import spend, take_steps
from lagrange.core.symbols import Sign

_RATIONAL = (Op.SYMBOL, Op.ADD, Op.MULTIPLY, Op.POWER)

Operation = Callable[[Any, list[Any], Any], Any]


class Point:
    """Random values of the symbols of a graph, residues (int) or reals (mpf).

    assigned   values of the symbols needed so far, shared by the points made `with_values`
    functions  values of undefined and opaque functions, by name and by values of the arguments
    signs      bit n gives the sign of the n-th `Sign` symbol
    """

    operations: tuple[Operation, ...]

    def __init__(self, graph: Graph, arithmetic: Any, signs: int = 0) -> None:
        self.graph = graph
        self.arithmetic = arithmetic
        self.assigned: dict[sp.Symbol, Any] = {}
        self.functions: dict[Any, Any] = {}
        self.signs = signs
        self._changes: Mapping[sp.Symbol, Any] = {}
        self._values: list[Any] = []
        self._origin: Point | None = None
        self._mask: int | None = None

    @property
    def exact(self) -> bool:
        """Whether values are residues."""
        return bool(self.arithmetic.exact)

    def value(self, expression: sp.Expr) -> Any:
        """The value of an expression. Raises InadmissibleError, ZeroDivisorError, UnsupportedError."""
        return self.at(self.graph.node(expression))

    def values(self, expressions: Iterable[sp.Expr]) -> NumberRow:
        """The values of several expressions."""
        return [self.value(e) for e in expressions]

    def matrix(self, rows: Iterable[Iterable[sp.Expr]]) -> list[NumberRow]:
        """The values of a matrix given by its rows (`matrix.tolist()`), shape (m, n)."""
        return [self.values(row) for row in rows]

    def at(self, node: int) -> Any:
        """The value of a node of the graph."""
        values = self._values
        if len(values) <= node:
            values.extend([None] * (len(self.graph.operations) - len(values)))
        if values[node] is None and (self._origin is None or self._taken_over(node) is None):
            graph, operations, mask = self.graph, self.operations, self._mask
            codes, data, symbols = graph.operations, graph.data, graph.symbols
            n = node
            order = graph.order(node)
            spend(len(order) / NODES_PER_UNIT)
            if not self.exact:
                take_steps(STEPS_OF_A_DECIMAL * len(order))
            try:
                for n in order:
                    if values[n] is None:
                        shared = mask is not None and not symbols[n] & mask
                        values[n] = self._shared(n) if shared else operations[codes[n]](self, values, data[n])
            except InadmissibleError as error:
                # The first node that fails shows which symbols should be drawn again (`Sampler`).
                error.node = n if error.node is None else error.node
                raise
        return values[node]

    def _shared(self, node: int) -> Any:
        """The value of a node without changed symbols: that of the point this one comes from, found there once.

        What it needs has been evaluated there in the same way, since `at` goes through the graph in order.
        """
        point = cast(Point, self._origin)
        values, graph = point._values, point.graph
        if len(values) <= node:
            values.extend([None] * (len(graph.operations) - len(values)))
        if values[node] is None:
            if point._mask is not None and not graph.symbols[node] & point._mask:
                values[node] = point._shared(node)
            else:
                values[node] = point.operations[graph.operations[node]](point, values, graph.data[node])
        return values[node]

    def has_value(self, node: int) -> bool:
        """Whether a node has been evaluated."""
        return self._known(node) is not None

    def _known(self, node: int) -> Any:
        """The value of a node that has been evaluated here, or where this point comes from; None if it has none."""
        point: Point = self
        symbols = self.graph.symbols[node]
        while True:
            values = point._values
            if node < len(values) and values[node] is not None:
                return values[node]
            if point._origin is None or point._mask is None or symbols & point._mask:
                return None
            point = point._origin

    def _taken_over(self, node: int) -> Any:
        """The value of a node, which is then stored."""
        self._values[node] = value = self._known(node)
        return value

    def is_zero(self, expression: sp.Expr) -> bool:
        """Whether an expression vanishes here."""
        return bool(self.arithmetic.vanishes(self.value(expression)))

    def affine(self, expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> list[NumberRow] | None:
        """Rows [A | b], shape (m, n + 1), with expressions = A u + b here; None if one is not affine in u."""
        rows = self.affine_each(expressions, unknowns)
        return None if None in rows else [row for row in rows if row is not None]

    def affine_each(self, expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> list[NumberRow | None]:
        """The row of each expression, shape (n + 1,); None for one that is not affine in u.

        expressions (m,), unknowns (n,). A is read off at random u; that A u + b holds is tried at other ones.
        """
        # u² has a slope at every point too: only a second set of values tells it from an affine expression.
        nodes = [self.graph.node(e) for e in expressions]
        first = self.with_values({u: self.random() for u in unknowns})
        second = self.with_values({u: self.random() for u in unknowns})
        mask = self.graph.mask(unknowns)
        return [first._affine(node, unknowns, mask, second) for node in nodes]

    def with_values(self, changes: Mapping[sp.Symbol, Any]) -> Self:
        """The same point with other values of the given symbols; nothing else is evaluated again."""
        # The two share the values of all other symbols, so that values of nodes are taken over when they are needed:
        # copying all of them takes longer than evaluating an equation.
        other = self._blank()
        other.assigned, other._changes, other.functions = self.assigned, {**self._changes, **changes}, self.functions
        other._origin, other._mask = self, self.graph.mask(changes)
        return other

    def redrawn(self, symbols: Iterable[sp.Symbol]) -> Self:
        """The same point with other random values of the given symbols."""
        drawn = set(symbols)
        kept = {s: v for s, v in self.assigned.items() if s not in drawn}
        other, mask = self._blank(), self.graph.mask(drawn)
        other.assigned, other._changes, other.functions = kept, self._changes, self.functions
        # What does not depend on the changed symbols need not be evaluated again.
        nodes = range(max(len(self._values), len(self._origin._values) if self._origin is not None else 0))
        other._values = [None if self.graph.symbols[n] & mask else self._known(n) for n in nodes]
        return other

    def assign(self, symbol: sp.Symbol, value: Any) -> None:
        """Give a symbol that has no value yet its value. Raises InadmissibleError for a wrong sign."""
        if symbol.is_nonnegative:
            self.require_positive(value)
        self.assigned[symbol] = value

    def input(self, symbol: sp.Symbol) -> Any:
        """The value of a symbol, drawn now if it has none."""
        if symbol in self._changes:
            return self._changes[symbol]
        if symbol not in self.assigned:
            self.assigned[symbol] = self._sign(symbol) if isinstance(symbol, Sign) else self._drawn(symbol)
        return self.assigned[symbol]

    def is_difference_zero(self, difference: Any, sizes: Iterable[Any]) -> bool:  # noqa: ARG002
        """Whether a difference of numbers of these sizes vanishes. Raises InadmissibleError where that is undecided."""
        return bool(self.arithmetic.vanishes(difference))

    def require_positive(self, value: Any) -> None:
        """Raises InadmissibleError unless the value is a square (a positive number), and not 0."""
        self.arithmetic.root(value)
        if self.arithmetic.vanishes(value):
            raise InadmissibleError

    def number(self, numerator: int, denominator: int = 1) -> Any:
        """A rational number in the point's arithmetic."""
        return self.arithmetic.number(numerator, denominator)

    def random(self) -> Any:
        """A random number."""
        return self.arithmetic.sample()

    def rank(self, rows: Sequence[Sequence[Any]]) -> int:
        """The rank of a matrix of values, shape (m, n)."""
        return linear_algebra.rank(self.arithmetic, rows)

    def row_reduced(self, rows: Sequence[Sequence[Any]]) -> tuple[list[NumberRow], list[int]]:
        """Echelon form and pivot columns, see `linear_algebra.row_reduced`."""
        return linear_algebra.row_reduced(self.arithmetic, rows)

    def nullspace(self, rows: Sequence[Sequence[Any]], width: int) -> list[NumberRow]:
        """A basis of the solutions of A x = 0, see `linear_algebra.nullspace`."""
        return linear_algebra.nullspace(self.arithmetic, rows, width)

    def solution(
        self, rows: Sequence[Sequence[Any]], right: Sequence[Any], free: Sequence[Any] | None = None
    ) -> NumberRow | None:
        """A solution of A x = b or None, see `linear_algebra.solution`."""
        return linear_algebra.solution(self.arithmetic, rows, right, free)

    def turned(self, terms: tuple[GraphTerm, ...], n: int, d: int) -> tuple[Any, Any]:
        """Cosine and sine of Σ terms + π n/d."""
        raise NotImplementedError

    def set_angle(self, symbol: sp.Symbol, pair: tuple[Any, Any], depth: int) -> None:
        """Give a symbol a value v with (cos, sin)(v/depth) = pair."""
        raise NotImplementedError

    def function_key(self, node: int) -> Any:
        """The key in `functions` of the value of an UNSPECIFIED node."""
        raise NotImplementedError

    def _drawn(self, symbol: sp.Symbol) -> Any:
        raise NotImplementedError

    def _blank(self) -> Self:
        raise NotImplementedError

    def _sign(self, symbol: sp.Symbol) -> Any:
        # Bit n of the number of the point: successive points run through all combinations of signs.
        own = self.graph.bit(symbol)
        place = sum(isinstance(s, Sign) and bit < own for s, bit in self.graph.bits.items())
        return self.number(-1 if self.signs >> place & 1 else 1)

    def _affine(self, node: int, unknowns: Sequence[sp.Symbol], mask: int, other: Self) -> NumberRow | None:
        """The row of a node; None if it does not hold at `other` values of the unknowns as well."""
        slopes = self._slopes(node, mask)
        if slopes is None:
            return None
        b, c = (p.at(node) - sum(a * p.input(u) for u, a in slopes.items()) for p in (self, other))
        reduce = self.arithmetic.reduce
        sizes = (self.at(node), other.at(node), b, c)
        if not self.is_difference_zero(reduce(b - c), sizes):
            return None
        zero = self.number(0)
        return [*(slopes.get(u, zero) for u in unknowns), reduce(b)]

    def _slopes(self, node: int, mask: int) -> dict[sp.Symbol, Any] | None:
        """Derivatives of a node by the unknowns in it; None if these occur in other than sums, products, powers."""
        graph, reduce = self.graph, self.arithmetic.reduce
        if any(graph.symbols[n] & mask and graph.operations[n] not in _RATIONAL for n in graph.order(node)):
            return None
        self.at(node)
        values = self._values
        # Backward through the graph, each node's slope complete before its needs: all unknowns in one pass.
        slopes: dict[int, Any] = {node: self.number(1)}
        by_unknown: dict[sp.Symbol, Any] = {}
        for n in reversed(graph.order(node)):
            if not graph.symbols[n] & mask or n not in slopes:
                continue
            slope, op, data = reduce(slopes[n]), graph.operations[n], graph.data[n]
            if op == Op.SYMBOL:
                by_unknown[data] = slope
            elif op == Op.ADD:
                for m in data:
                    slopes[m] = slopes.get(m, 0) + slope
            elif op == Op.MULTIPLY:
                for place, m in enumerate(data):
                    if graph.symbols[m] & mask:
                        slopes[m] = slopes.get(m, 0) + self._others(slope, data, place)
            elif op == Op.POWER:
                # n b^(n − 1) as n b^n/b, from the value that is known; where b = 0 another point is drawn.
                base, exponent = data
                inverse = self.arithmetic.inverse(values[base])
                slopes[base] = slopes.get(base, 0) + slope * exponent * reduce(values[n] * inverse)
        return by_unknown

    def _others(self, slope: Any, factors: tuple[int, ...], place: int) -> Any:
        for n, m in enumerate(factors):
            if n != place:
                slope = self.arithmetic.reduce(slope * self._values[m])
        return slope


# -- operations that are the same for numbers of every kind ------------------------------------------------------------


def symbol(point: Point, _: list[Any], data: Any) -> Any:
    """The value of a symbol."""
    return point.input(data)


def angle(point: Any, _: list[Any], data: Any) -> Any:
    """cos and sin of a sum of angles."""
    return point.turned(*data)


def cosine(_: Point, v: list[Any], data: Any) -> Any:
    """The first of the two."""
    return v[data[0]][0]


def sine(_: Point, v: list[Any], data: Any) -> Any:
    """The second of the two."""
    return v[data[0]][1]
