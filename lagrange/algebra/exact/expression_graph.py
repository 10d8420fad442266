"""Expressions as a graph of arithmetic operations, which residues and real numbers can both carry out.

Every subexpression is one node, shared by all expressions of a problem and placed after the nodes that it needs, so
that it is evaluated at most once at a random point. The class that is decided exactly is

    rational functions of symbols, e^{±i c m} and e^{c m}   (c rational, m a product of powers of symbols):

symbols and such exponentials are algebraically independent unless the m are linearly dependent over the rationals
(Lindemann; Ax). An argument is therefore expanded into Σ c_j m_j, multiples of π apart, and each m_j has one random
point of the circle. Roots of positive symbols and of rational numbers belong to the class too. Everything else is
marked; a zero found with a mark is still a zero, but "not zero" then needs a second opinion:

    SIGNED   the value on one branch: √(a + b), |a|, sign(a) with a of unknown sign;
    OPAQUE   a random function of the argument's value, which may miss identities: atan, log, acos.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from enum import IntEnum
from math import prod
from typing import Any

import sympy as sp

from lagrange.algebra.exact.limits import (
    LARGEST_CANCELLED_ANGLE,
    MOST_ANGLE_TERMS,
    MOST_NODES,
    MOST_SYMBOLS,
    MOST_WANTED_SQUARES,
)
from lagrange.algebra.exact.prime_field import ALWAYS_SQUARES, M
from lagrange.core.expression_size import count_operations
from lagrange.core.symbols import Unspecified

SIGNED = 1
OPAQUE = 2


class UnsupportedError(Exception):
    """An expression that is not evaluated: a float, a Piecewise, an unknown function, one too large."""


class DivisionByZeroError(Exception):
    """A denominator is exactly zero, everywhere (on the constraint surface)."""

    def __init__(self, denominator: sp.Expr) -> None:
        super().__init__(f"division by {denominator}, which is exactly zero")
        self.denominator = denominator


class Op(IntEnum):
    """The operation of a node, with its data in brackets: numbers of nodes unless stated otherwise.

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


GraphTerm = tuple[int, int, int]


class Nodes:
    """Nodes in lists, every one after those it needs.

    operations   the operation of each
    data         and its data
    needs        the nodes it depends on
    symbols      the symbols it depends on: bit n for the n-th symbol met
    marks        SIGNED and OPAQUE, its own and inherited
    expressions  the expression of each
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
            needed = {node}
            stack = [node]
            while stack:
                for n in self.needs[stack.pop()]:
                    if n not in needed:
                        needed.add(n)
                        stack.append(n)
            # A node is made after those it needs, so that its number is the larger: sorting is a topological order.
            self._orders[node] = sorted(needed)
        return self._orders[node]

    def needed(self, nodes: Iterable[int]) -> list[int]:
        """The nodes needed for several nodes, in order of evaluation."""
        return sorted({m for n in nodes for m in self.order(n)})

    def bit(self, symbol: sp.Symbol) -> int:
        """The bit of a symbol."""
        bit = self.bits.get(symbol)
        if bit is None:
            if len(self.bits) >= MOST_SYMBOLS:
                raise UnsupportedError("too many symbols")
            bit = self.bits[symbol] = 1 << len(self.bits)
        return bit

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
        if len(self.operations) >= MOST_NODES:
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


_INFINITE = (sp.zoo, sp.nan, sp.oo, -sp.oo)


class Graph(Nodes):
    """The nodes of expressions.

    rules  values of symbols, in symbols that have no rule, substituted in angles and exponents:
           with x = R(θ + φ), the cosine of x/R is that of θ + φ
    """

    def __init__(self, rules: Mapping[sp.Symbol, sp.Expr] | None = None) -> None:
        super().__init__()
        self.rules = dict(rules or {})

    def node(self, expression: sp.Expr) -> int:
        """The node of an expression. Raises UnsupportedError, DivisionByZeroError for an infinity."""
        node = self.known.get(expression)
        if node is None:
            try:
                node = self.visit(expression)
            except RecursionError:
                raise UnsupportedError("nested too deep") from None
        return node

    def visit(self, e: sp.Expr) -> int:
        """The node of a subexpression."""
        node = self.known.get(e)
        if node is None:
            node = self.known[e] = _builder(e)(self, e)
        return node

    def visited(self, expressions: tuple[sp.Expr, ...]) -> tuple[int, ...]:
        """The nodes of several subexpressions."""
        return tuple(self.visit(e) for e in expressions)

    def angle(self, argument: sp.Expr) -> int:
        """The node of an angle."""
        terms = self.terms(argument)
        turn = terms.get(sp.pi, sp.S.Zero)
        # The circle has the exact point of π n/d if and only if 2d divides M. Any other multiple of π is an angle drawn
        # at random, which misses cos(π/25) = −cos(24π/25): OPAQUE, and real points decide.
        exact = M % (2 * int(turn.q)) == 0
        if exact:
            terms.pop(sp.pi, None)
        data = (self._listed(terms), int(turn.p) if exact else 0, int(turn.q) if exact else 1)
        marks = 0 if exact and all(_is_monomial(m) for m in terms) else OPAQUE
        return self.shared(Op.ANGLE, data, tuple(n for n, _, _ in data[0]), argument, marks)

    def exponential(self, argument: sp.Expr) -> int:
        """The node of e^argument."""
        terms = self.terms(argument)
        data = self._listed(terms)
        marks = 0 if all(_is_monomial(m) for m in terms) else OPAQUE
        return self.shared(Op.EXP, (data,), tuple(n for n, _, _ in data), sp.exp(argument, evaluate=False), marks)

    def growth(self, e: sp.Expr, base: sp.Expr, exponent: sp.Expr) -> int:
        """The node of b^(c + Σ c_j m_j): b^c times one random function of b and m_j for each j."""
        if (split := _without_positive(base)) is not None:  # (1 + q t/m)^n is (m + q t)^n m^(-n)
            powers = tuple(self.visit(sp.Pow(b, n * exponent)) for b, n in split)
            return self.new(Op.MULTIPLY, powers, powers, e)
        terms = self.terms(exponent)
        # The constant part is a power of its own, so that b^(n + 1) = b b^n holds.
        constant = terms.pop(sp.S.One, sp.S.Zero)
        node = self.visit(base)
        known = base.is_Symbol and base.is_positive and all(_is_monomial(m) for m in terms)
        data = (node, self._listed(terms))
        needs = (node, *(n for n, _, _ in data[1]))
        growth = self.shared(Op.GROWTH, data, needs, e, 0 if known else OPAQUE)
        if constant == 0:
            return growth
        factors = (growth, self.visit(sp.Pow(base, constant)))
        return self.new(Op.MULTIPLY, factors, factors, e)

    def terms(self, argument: sp.Expr) -> dict[sp.Expr, sp.Rational]:
        """c_j by m_j, where argument = Σ c_j m_j."""
        if self.rules and argument.free_symbols & self.rules.keys():
            argument = argument.xreplace(self.rules)
        terms: dict[sp.Expr, sp.Rational] = {}
        for part in sp.Add.make_args(_expanded(argument)):
            coefficient, monomial = part.as_coeff_Mul()
            if not coefficient.is_Rational:
                raise UnsupportedError("a number that is not rational")
            terms[monomial] = terms.get(monomial, sp.S.Zero) + coefficient
        return {m: c for m, c in terms.items() if c != 0}

    def want_squares(self, number: sp.Rational) -> None:
        """Fields must have roots of the prime factors of a number (small ones; the rest as a whole)."""
        factors: set[int] = set()
        # Trial division only: to factor a large number may take forever. What is left is wanted as a square as a whole.
        for part in (number.p, number.q):
            primes = sp.factorint(part, limit=1000, use_rho=False, use_pm1=False, use_ecm=False)
            factors.update(int(f) for f in primes)
        self.squares |= {f for f in factors if f > 1} - ALWAYS_SQUARES
        if len(self.squares) > MOST_WANTED_SQUARES:
            raise UnsupportedError("roots of too many primes")

    def _listed(self, terms: Mapping[sp.Expr, sp.Rational]) -> tuple[GraphTerm, ...]:
        return tuple(sorted((self.visit(m), int(c.p), int(c.q)) for m, c in terms.items()))


_Builder = Callable[[Graph, Any], int]


def _builder(e: sp.Expr) -> _Builder:
    known = _BUILDERS.get(type(e))
    if known is not None:
        return known
    if isinstance(e, sp.Rational):
        return _number
    if isinstance(e, sp.Symbol):
        return _symbol
    if e in _INFINITE:
        raise DivisionByZeroError(sp.S.Zero)
    raise UnsupportedError(f"{type(e).__name__} is not evaluated exactly")


def _expanded(argument: sp.Expr) -> sp.Expr:
    """The argument as a sum of monomials, as far as that is cheap; else the argument itself."""
    # An argument left as it is counts as one opaque monomial: correct, though identities with its parts are missed.
    if _is_flat(argument) or _expanded_terms(argument) > MOST_ANGLE_TERMS:
        return argument
    quotients = any(p.exp.is_negative and p.base.is_Add for p in argument.atoms(sp.Pow))
    if quotients and count_operations(argument) <= LARGEST_CANCELLED_ANGLE:
        argument = sp.cancel(argument)
    return sp.expand(argument)


def _expanded_terms(e: sp.Expr) -> int:
    """How many terms an expanded expression can have."""
    if e.is_Add:
        return sum(map(_expanded_terms, e.args))
    if e.is_Mul:
        return prod(map(_expanded_terms, e.args))
    if e.is_Pow and e.exp.is_Integer:
        terms = _expanded_terms(e.base)
        return 1 if terms == 1 else MOST_ANGLE_TERMS + 1 if abs(e.exp) > MOST_ANGLE_TERMS else terms ** abs(int(e.exp))
    return 1


def _is_flat(e: sp.Expr) -> bool:
    return all(_is_monomial(a) for a in e.args) if e.is_Add else _is_monomial(e)


def _is_monomial(e: sp.Expr) -> bool:
    """A product of powers of symbols, π and rationals. Different ones are independent over the rationals."""
    if e.is_Mul:
        return all(_is_monomial(f) for f in e.args)
    if e.is_Pow:
        return bool(e.exp.is_Rational and (e.base.is_Symbol or e.base.is_Rational or e.base is sp.pi))
    return bool(e.is_Symbol or e.is_Rational or e is sp.pi)


def _number(graph: Graph, e: sp.Rational) -> int:
    return graph.new(Op.NUMBER, (int(e.p), int(e.q)), (), e)


def _symbol(graph: Graph, e: sp.Symbol) -> int:
    node = graph.new(Op.SYMBOL, e, (), e)
    graph.symbols[node] = graph.bit(e) if e is not sp.pi else 0
    return node


def _add(graph: Graph, e: sp.Add) -> int:
    needs = graph.visited(e.args)
    return graph.new(Op.ADD, needs, needs, e)


def _multiply(graph: Graph, e: sp.Mul) -> int:
    needs = graph.visited(e.args)
    return graph.new(Op.MULTIPLY, needs, needs, e)


def _without_positive(base: sp.Expr) -> list[tuple[sp.Expr, int]] | None:
    """A sum or product as one without positive symbols for factors, and these with their powers; None without any."""
    if not base.is_Add and not base.is_Mul:
        return None
    above, below = sp.fraction(sp.together(base))
    rest: list[tuple[sp.Expr, int]] = []
    taken: list[tuple[sp.Expr, int]] = []
    for part, sign in ((above, 1), (below, -1)):
        for f in sp.Mul.make_args(part):
            b, n = f.as_base_exp()
            positive = b.is_Symbol and b.is_positive and n.is_Integer
            (taken if positive else rest).append((b, sign * int(n)) if positive else (f, sign))
    if not taken:
        return None
    left = sp.Mul(*(f**sign for f, sign in rest))
    return [*([(left, 1)] if left != 1 else []), *taken]


def _power(graph: Graph, e: sp.Pow) -> int:
    base, exponent = e.args
    if exponent.is_Integer:
        node = graph.visit(base)
        return graph.new(Op.POWER, (node, int(exponent)), (node,), e)
    if exponent.is_Rational:
        return _root(graph, e, base, exponent)
    return graph.growth(e, base, exponent)


def _root(graph: Graph, e: sp.Expr, base: sp.Expr, exponent: sp.Rational) -> int:
    node = graph.visit(base)
    marks = 0
    if base.is_Rational:
        if base < 0:
            raise UnsupportedError("a root of a negative number")
        graph.want_squares(base)
    # Odd roots need no mark: a positive number has exactly one that is positive, in F_p as in the reals.
    elif exponent.q % 2 == 0 and not (base.is_Atom and base.is_nonnegative):
        marks = SIGNED
    return graph.new(Op.ROOT, (node, int(exponent.p), int(exponent.q)), (node,), e, marks)


def _exp(graph: Graph, e: sp.Expr) -> int:
    return graph.exponential(e.args[0] if e.args else sp.S.One)


def _of_angle(op: Op) -> _Builder:
    def build(graph: Graph, e: sp.Expr) -> int:
        angle = graph.angle(e.args[0])
        return graph.shared(op, (angle,), (angle,), e)

    return build


def _of_exponential(op: Op) -> _Builder:
    def build(graph: Graph, e: sp.Expr) -> int:
        exp = graph.exponential(e.args[0])
        return graph.shared(op, (exp,), (exp,), e)

    return build


def _quotient(above: Op | None, below: Op) -> _Builder:
    """Builds a quotient of the cosine and sine of one angle."""

    def build(graph: Graph, e: sp.Expr) -> int:
        angle = graph.angle(e.args[0])
        named = {Op.COS: sp.cos, Op.SIN: sp.sin}
        denominator = graph.shared(below, (angle,), (angle,), named[below](e.args[0], evaluate=False))
        inverse = graph.shared(Op.POWER, (denominator, -1), (denominator,), e)
        if above is None:
            return inverse
        factors = (graph.shared(above, (angle,), (angle,), named[above](e.args[0], evaluate=False)), inverse)
        return graph.new(Op.MULTIPLY, factors, factors, e)

    return build


def _function(graph: Graph, e: sp.Expr) -> int:
    needs = graph.visited(e.args)
    return graph.new(Op.FUNCTION, (type(e).__name__, needs), needs, e, OPAQUE)


def _logarithm(graph: Graph, e: sp.Expr) -> int:
    """log(q b/a) as log q + log b − log a: for positive a, b this is no identity that real values have to show."""
    parts = _without_positive(e.args[0])
    return _function(graph, e) if parts is None else graph.visit(sp.Add(*(n * sp.log(b) for b, n in parts)))


def _unspecified(graph: Graph, e: Unspecified) -> int:
    # Exact in spite of its random values: nothing is known of f, so that f(a) is as independent as a symbol.
    needs = graph.visited(e.arguments)
    return graph.new(Op.UNSPECIFIED, ((e.name, e.orders), needs), needs, e)


def _branching(op: Op) -> _Builder:
    def build(graph: Graph, e: sp.Expr) -> int:
        argument = graph.visit(e.args[0])
        return graph.new(op, (argument,), (argument,), e, SIGNED)

    return build


_BUILDERS: dict[type, _Builder] = {
    sp.Integer: _number,
    sp.Rational: _number,
    sp.Symbol: _symbol,
    type(sp.pi): _symbol,
    sp.Add: _add,
    sp.Mul: _multiply,
    sp.Pow: _power,
    type(sp.E): _exp,
    sp.exp: _exp,
    sp.cos: _of_angle(Op.COS),
    sp.sin: _of_angle(Op.SIN),
    sp.tan: _of_angle(Op.TAN),
    sp.cot: _quotient(Op.COS, Op.SIN),
    sp.sec: _quotient(None, Op.COS),
    sp.csc: _quotient(None, Op.SIN),
    sp.cosh: _of_exponential(Op.COSH),
    sp.sinh: _of_exponential(Op.SINH),
    sp.tanh: _of_exponential(Op.TANH),
    sp.log: _logarithm,
    sp.atan: _function,
    sp.asin: _function,
    sp.acos: _function,
    sp.atan2: _function,
    sp.Abs: _branching(Op.ABS),
    sp.sign: _branching(Op.SIGN),
    Unspecified: _unspecified,
}
