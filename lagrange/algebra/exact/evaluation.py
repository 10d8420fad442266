"""From SymPy to a graph of arithmetic operations that residues and reals can both carry out.

The class that is decided exactly is

    rational functions of symbols, e^{±i c m} and e^{c m}   (c rational, m a product of powers of symbols),

because symbols and such exponentials are algebraically independent unless the m are dependent over the
rationals (Lindemann, Ax). So an argument is expanded into Σ c_j m_j, multiples of π apart, and each m_j has
one random point of the circle. Roots of symbols that are positive and of rational numbers belong to the
class too. All else is marked SIGNED or OPAQUE (`graph`): a zero found with such marks is still a zero, "not
zero" then needs a second opinion.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import prod
from typing import Any

import sympy as sp

from lagrange.algebra.exact.graph import OPAQUE, SIGNED, DivisionByZeroError, Nodes, Op, Term, UnsupportedError
from lagrange.algebra.exact.prime_field import ALWAYS_SQUARES, M
from lagrange.core.symbols import Unspecified

_MOST_TERMS = 200
_LARGEST_CANCELLED = 40
_MOST_SQUARES = 12
_INFINITE = (sp.zoo, sp.nan, sp.oo, -sp.oo)


class Graph(Nodes):
    """The nodes of expressions.

    rules  what symbols are equal to (in symbols that have no rule), put in for them in angles and exponents:
           with x = R(θ + φ), the cosine of x/R is that of θ + φ
    """

    def __init__(self, rules: Mapping[sp.Symbol, sp.Expr] | None = None) -> None:
        super().__init__()
        self.rules = dict(rules or {})

    def node(self, expression: sp.Expr) -> int:
        """The node of an expression. Raises UnsupportedError, DivisionByZeroError for an infinity."""
        found = self.known.get(expression)
        if found is None:
            try:
                found = self.visit(expression)
            except RecursionError:
                raise UnsupportedError("nested too deep") from None
        return found

    def visit(self, e: sp.Expr) -> int:
        """The node of a subexpression."""
        found = self.known.get(e)
        if found is None:
            found = self.known[e] = _builder(e)(self, e)
        return found

    def visited(self, expressions: tuple[sp.Expr, ...]) -> tuple[int, ...]:
        """The nodes of several subexpressions."""
        return tuple(self.visit(e) for e in expressions)

    def angle(self, argument: sp.Expr) -> int:
        """The node of an angle."""
        terms = self.terms(argument)
        turn = terms.get(sp.pi, sp.S.Zero)
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
        terms = self.terms(exponent)
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
        for part in (number.p, number.q):
            found = sp.factorint(part, limit=1000, use_rho=False, use_pm1=False, use_ecm=False)
            factors.update(int(f) for f in found)
        self.squares |= {f for f in factors if f > 1} - ALWAYS_SQUARES
        if len(self.squares) > _MOST_SQUARES:
            raise UnsupportedError("roots of too many primes")

    def _listed(self, terms: Mapping[sp.Expr, sp.Rational]) -> tuple[Term, ...]:
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
    if _is_flat(argument) or _expanded_terms(argument) > _MOST_TERMS:
        return argument
    quotients = any(p.exp.is_negative and p.base.is_Add for p in argument.atoms(sp.Pow))
    if quotients and argument.count_ops() <= _LARGEST_CANCELLED:
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
        return 1 if terms == 1 else _MOST_TERMS + 1 if abs(e.exp) > _MOST_TERMS else terms ** abs(int(e.exp))
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
    """Of cosine and sine of the same angle."""

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


def _unspecified(graph: Graph, e: Unspecified) -> int:
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
    sp.log: _function,
    sp.atan: _function,
    sp.asin: _function,
    sp.acos: _function,
    sp.atan2: _function,
    sp.Abs: _branching(Op.ABS),
    sp.sign: _branching(Op.SIGN),
    Unspecified: _unspecified,
}
