"""A graph of arithmetic operations: what expressions become before they are evaluated.

Every subexpression is one node, shared by all expressions of a problem, and stands after the nodes that it
needs; at a random point each is evaluated at most once. Two marks say what a value is worth:

    SIGNED   it is that of one branch: √(a + b), |a|, sign(a) with a of unknown sign;
    OPAQUE   it is a random function of the argument's value, and identities may be missed: atan, log, acos.
"""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum
from typing import Any

import sympy as sp

SIGNED = 1
OPAQUE = 2

_MOST_NODES = 100_000
_MOST_SYMBOLS = 1_000


class UnsupportedError(Exception):
    """An expression that is not evaluated: a float, a Piecewise, an unknown function, one too large."""


class DivisionByZeroError(Exception):
    """A denominator is exactly zero, everywhere (on the constraint surface)."""

    def __init__(self, denominator: sp.Expr) -> None:
        super().__init__(f"division by {denominator}, which is exactly zero")
        self.denominator = denominator


class Op(IntEnum):
    """What a node does, with its data in brackets: numbers of nodes unless said otherwise.

    A term is (monomial, numerator, denominator): a rational multiple of a node.
    """

    NUMBER = 0  # (numerator, denominator), two ints
    SYMBOL = 1  # the symbol, or π
    ADD = 2  # (summand, ...)
    MULTIPLY = 3  # (factor, ...)
    POWER = 4  # (base, exponent), an int
    ROOT = 5  # (base, numerator, denominator) of the exponent, two ints
    ANGLE = 6  # (terms, n, d): Σ terms + π n/d; its value is (cos, sin)
    COS = 7  # (angle,)
    SIN = 8  # (angle,)
    TAN = 9  # (angle,)
    EXP = 10  # (terms,)
    COSH = 11  # (exp,)
    SINH = 12  # (exp,)
    TANH = 13  # (exp,)
    GROWTH = 14  # (base, terms): base^(Σ terms)
    FUNCTION = 15  # (name, arguments): a known function, taken by value
    UNSPECIFIED = 16  # ((name, orders), arguments): an undefined function
    ABS = 17  # (argument,)
    SIGN = 18  # (argument,)


Term = tuple[int, int, int]


class Nodes:
    """Nodes in lists, every one after those it needs.

    operations   what each does
    data         with what
    needs        the nodes it depends on
    symbols      the symbols it depends on: bit n for the n-th symbol met
    marks        SIGNED and OPAQUE, its own and inherited
    expressions  what it was made from
    branching    the nodes that are SIGNED themselves
    squares      numbers under roots that a field must have a root of
    """

    def __init__(self) -> None:
        self.operations: list[int] = []
        self.data: list[Any] = []
        self.needs: list[tuple[int, ...]] = []
        self.symbols: list[int] = []
        self.marks: list[int] = []
        self.expressions: list[sp.Expr] = []
        self.branching: set[int] = set()
        self.squares: frozenset[int] = frozenset()
        self.bits: dict[sp.Symbol, int] = {}
        self.known: dict[sp.Expr, int] = {}
        self._shared: dict[tuple[int, Any], int] = {}
        self._orders: dict[int, list[int]] = {}

    def order(self, node: int) -> list[int]:
        """The nodes needed for one node, in order of evaluation, that one last."""
        if node not in self._orders:
            found = {node}
            stack = [node]
            while stack:
                for n in self.needs[stack.pop()]:
                    if n not in found:
                        found.add(n)
                        stack.append(n)
            self._orders[node] = sorted(found)
        return self._orders[node]

    def needed(self, nodes: Iterable[int]) -> list[int]:
        """The nodes needed for several nodes, in order of evaluation."""
        return sorted({m for n in nodes for m in self.order(n)})

    def bit(self, symbol: sp.Symbol) -> int:
        """The bit that stands for a symbol."""
        found = self.bits.get(symbol)
        if found is None:
            if len(self.bits) >= _MOST_SYMBOLS:
                raise UnsupportedError("too many symbols")
            found = self.bits[symbol] = 1 << len(self.bits)
        return found

    def mask(self, symbols: Iterable[sp.Symbol]) -> int:
        """The bits of several symbols."""
        mask = 0
        for s in symbols:
            mask |= self.bit(s)
        return mask

    def marked(self, nodes: Iterable[int]) -> int:
        """The marks of several nodes."""
        marks = 0
        for n in nodes:
            marks |= self.marks[n]
        return marks

    def new(self, op: Op, data: Any, needs: tuple[int, ...], expression: sp.Expr, marks: int = 0) -> int:
        """A new node; `marks` are its own."""
        if len(self.operations) >= _MOST_NODES:
            raise UnsupportedError("the expression is too large")
        node = len(self.operations)
        if marks & SIGNED:
            self.branching.add(node)
        symbols = 0
        for n in needs:
            symbols |= self.symbols[n]
            marks |= self.marks[n]
        self.operations.append(int(op))
        self.data.append(data)
        self.needs.append(needs)
        self.symbols.append(symbols)
        self.marks.append(marks)
        self.expressions.append(expression)
        return node

    def shared(self, op: Op, data: Any, needs: tuple[int, ...], expression: sp.Expr, marks: int = 0) -> int:
        """The node with this operation and data, made now if there is none."""
        key = (int(op), data)
        if key not in self._shared:
            self._shared[key] = self.new(op, data, needs, expression, marks)
        return self._shared[key]
