"""Size and cost estimates of an expression, without evaluating it.

Abbreviations share their parts, so that a short file can define an expression with 2^60 leaves: everything here is
computed once for each distinct part, in time proportional to their number. Two costs are estimated: that of a
derivative, which differentiates each factor of each product and each function in turn, and that of the sign of an
expression, for which SymPy isolates the roots of every polynomial in one parameter of known sign.

How long an expression is: its operations, counted as SymPy's `count_ops` does.

Lengths are compared in every step (which form is shorter, what is too long to be shown), and `count_ops` makes symbols
for the operations and a sum of them: a twentieth of a short run. Here they are counted, each with its number of
occurrences: additions and subtractions, multiplications, divisions, powers, functions, leading minus signs.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence, Set
from functools import lru_cache
from math import comb
from typing import NamedTuple

import sympy as sp

from lagrange.core.limits import LARGEST_SIZE, MOST_REMEMBERED_COUNTS
from lagrange.core.symbols import base

_INFINITE = (sp.S.NaN, sp.S.ComplexInfinity, sp.S.Infinity, sp.S.NegativeInfinity)
_SEVERAL = sp.Dummy()  # as `Size.symbol` where there are several


class Size(NamedTuple):
    """The size of an expression.

    size         nodes of its tree, shared parts counted each time
    layers       nodes on the longest path from its root to a leaf
    power        the highest numeric power in it, nested ones multiplied
    denominator  the largest denominator of such a power
    bits         length of its longest number
    terms        upper bound on the number of its terms when it is multiplied out
    widest       the largest `terms` of its parts
    symbol       its only symbol; None in a constant
    degree       its degree in that symbol
    doubt        the cost of finding its sign, in units of 0.1 ms
    is_constant  whether it is a number
    is_finite    whether it has no division by zero
    is_real      whether it has no root of a negative number
    """

    size: int = 1
    layers: int = 1
    power: float = 1.0
    denominator: int = 1
    bits: int = 0
    terms: int = 1
    widest: int = 1
    symbol: sp.Symbol | None = None
    degree: int = 0
    doubt: float = 0.0
    is_constant: bool = False
    is_finite: bool = True
    is_real: bool = True


class Sizes:
    """The sizes of expressions, each computed once."""

    def __init__(self) -> None:
        self._known: dict[sp.Basic, Size] = {}

    def of(self, expression: sp.Basic) -> Size:
        """The size of an expression."""
        size = self._known.get(expression)
        if size is None:
            parts = [self.of(a) for a in expression.args]
            size = _of_compound(expression, parts) if parts else _of_atom(expression)
            self._known[expression] = size
        return size

    def derivative_cost(self, expressions: Iterable[sp.Expr], moving: Set[sp.Symbol]) -> float:
        """The cost of differentiating with respect to each of the moving symbols, in units of 0.1 ms."""
        estimate = _DerivativeEstimate(self, moving)
        sizes = sum(0.2 * size + 5 * len(symbols) for size, symbols in map(estimate.of, expressions))
        return sizes + 1.5 * estimate.cost


class _DerivativeEstimate:
    """Upper bound on the size of a derivative, and the cost of the steps to it, each distinct part once."""

    def __init__(self, sizes: Sizes, moving: Set[sp.Symbol]) -> None:
        self.cost = 0.0
        self._sizes = sizes
        self._moving = moving
        self._known: dict[sp.Basic, tuple[float, frozenset[sp.Symbol]]] = {}

    def of(self, e: sp.Basic) -> tuple[float, frozenset[sp.Symbol]]:
        """The size of the derivative, and the moving symbols in it."""
        estimate = self._known.get(e)
        if estimate is None:
            estimate = self._known[e] = self._of_symbol(e) if e.is_Symbol else self._of_compound(e)
        return estimate

    def _of_symbol(self, e: sp.Symbol) -> tuple[float, frozenset[sp.Symbol]]:
        moves = e in self._moving or base(e) in self._moving
        return (1.0, frozenset({e})) if moves else (0.0, frozenset())

    def _of_compound(self, e: sp.Basic) -> tuple[float, frozenset[sp.Symbol]]:
        parts = [self.of(a) for a in e.args]
        size = sum(s for s, _ in parts)
        dependences = sum(len(symbols) for _, symbols in parts)
        together = frozenset().union(*(symbols for _, symbols in parts))
        if e.is_Add:
            self.cost += 0.5 * len(together) * len(parts)
        else:
            size += dependences * self._sizes.of(e).size
            step = 2 + 0.12 * len(parts) ** 2 if e.is_Mul else 10 if e.is_Pow else 30
            self.cost += dependences * step
        return size, together


def _of_atom(e: sp.Basic) -> Size:
    if e.is_Rational:
        return Size(bits=max(abs(e.p).bit_length(), e.q.bit_length()), is_constant=True)
    if e.is_Symbol:
        return Size(symbol=e, degree=1)
    return Size(is_constant=bool(e.is_number), is_finite=e not in _INFINITE, is_real=e is not sp.I)


def _of_compound(e: sp.Basic, parts: Sequence[Size]) -> Size:
    terms, symbol, degree = _terms(e, parts), _only_symbol(parts), _degree(e, parts)
    return Size(
        size=min(1 + sum(p.size for p in parts), LARGEST_SIZE),
        layers=1 + max(p.layers for p in parts),
        power=_power(e, parts),
        denominator=max(e.exp.q if _is_power(e) else 1, *(p.denominator for p in parts)),
        bits=max(p.bits for p in parts),
        terms=terms,
        widest=max(terms, *(p.widest for p in parts)),
        symbol=symbol,
        degree=degree,
        doubt=min(_own_doubt(e, symbol, degree) + sum(p.doubt for p in parts), LARGEST_SIZE),
        is_constant=all(p.is_constant for p in parts),
        is_finite=all(p.is_finite for p in parts),
        is_real=all(p.is_real for p in parts) and not _is_imaginary(e),
    )


def _is_power(e: sp.Basic) -> bool:
    return bool(e.is_Pow and e.exp.is_Rational)


def _is_imaginary(e: sp.Basic) -> bool:
    return bool(e.is_Pow and e.base.is_Number and e.base.is_negative and not e.exp.is_Integer)


def _power(e: sp.Basic, parts: Sequence[Size]) -> float:
    if _is_power(e):
        return max(abs(int(e.exp.p)) / int(e.exp.q), 1.0) * parts[0].power
    return max(p.power for p in parts) if e.is_Add or e.is_Mul else 1.0


def _terms(e: sp.Basic, parts: Sequence[Size]) -> int:
    if e.is_Add:
        return min(sum(p.terms for p in parts), LARGEST_SIZE)
    if e.is_Mul:
        terms = 1
        for p in parts:
            terms = min(terms * p.terms, LARGEST_SIZE)
        return terms
    if e.is_Pow and e.exp.is_Integer and parts[0].terms > 1:
        terms, power = parts[0].terms, abs(int(e.exp))
        return min(comb(terms + power - 1, power), LARGEST_SIZE) if power <= 100 else LARGEST_SIZE
    return 1


def _only_symbol(parts: Sequence[Size]) -> sp.Symbol | None:
    symbols = {p.symbol for p in parts} - {None}
    return symbols.pop() if len(symbols) == 1 else _SEVERAL if symbols else None


def _degree(e: sp.Basic, parts: Sequence[Size]) -> int:
    if e.is_Mul:
        return sum(p.degree for p in parts)
    if e.is_Pow and e.exp.is_Integer:
        return parts[0].degree * abs(int(e.exp))
    return max(p.degree for p in parts) if e.is_Add else 0


def _own_doubt(e: sp.Basic, symbol: sp.Symbol | None, degree: int) -> float:
    """The cost that a node adds: for a sum in one symbol of known sign, the isolation of the roots of a polynomial."""
    if not e.is_Add or symbol is None or symbol is _SEVERAL or degree < 2:
        return 0.0
    return 30.0 * degree**2 if symbol.is_nonnegative else 0.0


# Operations


@lru_cache(maxsize=MOST_REMEMBERED_COUNTS)
def count_operations(expression: sp.Expr) -> int:
    """The number of operations: 2 in a + b/c, 1 in x², 1 in −x, none in a symbol."""
    total = 0
    rest = [expression]
    while rest:
        e = rest.pop()
        if e.is_Rational:
            total += (e.p < 0) + (e.q != 1)
        elif e.is_Mul:
            total += _of_product(e, rest)
        elif e.is_Add:
            total += _of_sum(e, rest)
        elif e.is_Pow and e.exp is sp.S.NegativeOne:
            total += 1
            rest.append(e.base)
        elif e.is_Pow or e.is_Function:
            total += 1
            rest.extend(e.args)
        elif not e.is_Symbol:
            total += int(e.count_ops())
    return total


def distinct_parts(expressions: Iterable[sp.Basic]) -> Iterator[sp.Basic]:
    """Every part of some expressions, each once: `atoms` would visit a common part as often as it occurs."""
    known: set[sp.Basic] = set()
    rest = list(expressions)
    while rest:
        e = rest.pop()
        if e not in known:
            known.add(e)
            yield e
            rest.extend(e.args)


def count_distinct(expressions: Iterable[sp.Expr]) -> int:
    """The number of distinct subexpressions: the cost for a program that evaluates each of them once."""
    return sum(1 for e in distinct_parts(expressions) if e.args)


def _of_sum(e: sp.Expr, rest: list[sp.Expr]) -> int:
    """One operation between two terms, and one more where all are subtracted."""
    negative = [_is_negative(term) for term in e.args]
    rest.extend(-term if minus else term for term, minus in zip(e.args, negative, strict=True))
    return len(e.args) - 1 + all(negative)


def _of_product(e: sp.Expr, rest: list[sp.Expr]) -> int:
    """The operations of a product: its sign, one division by the denominator, a multiplication between factors."""
    number, factors = e.as_coeff_mul()
    if not number.is_Rational or not all(_has_plain_exponent(f) for f in factors):
        return int(e.count_ops())
    minus = int(number.p < 0)
    above = [sp.Integer(abs(number.p))] if abs(number.p) != 1 else []
    below = [sp.Integer(number.q)] if number.q != 1 else []
    for f in factors:
        if f.is_Pow and f.exp.is_negative:
            below.append(f.base if f.exp is sp.S.NegativeOne else sp.Pow(f.base, -f.exp))
        else:
            above.append(f)
    if not below:
        if len(above) == 1 and above[0].is_Add:  # −(a + b), of which SymPy counts the minus sign only
            rest.extend(above[0].args)
            return minus
        rest.extend(above)
        return minus + len(above) - 1
    return minus + 1 + _of_factors(above, rest) + _of_factors(below, rest)


def _of_factors(factors: list[sp.Expr], rest: list[sp.Expr]) -> int:
    if len(factors) == 2 and factors[0].is_Integer and factors[1].is_Add:  # 2 (a + b) as 2 a + 2 b
        rest.append(sp.Mul(*factors))
        return 0
    rest.extend(factors)
    return max(len(factors) - 1, 0)


def _is_negative(term: sp.Expr) -> bool:
    first = term.args[0] if term.is_Mul else term
    return bool(first.is_Number and first.is_extended_negative)


def _has_plain_exponent(factor: sp.Expr) -> bool:
    """Whether it is clear if a factor belongs to the numerator or the denominator."""
    return not isinstance(factor, sp.exp) and factor.is_commutative and (not factor.is_Pow or factor.exp.is_Rational)
