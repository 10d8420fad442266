"""How long an expression is: its operations, counted as SymPy's `count_ops` does.

Lengths are compared in every step (which form is shorter, what is too long to be shown), and `count_ops` makes symbols
for the operations and a sum of them: a twentieth of a short run. Here they are counted, each with its number of
occurrences: additions and subtractions, multiplications, divisions, powers, functions, leading minus signs.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache

import sympy as sp

from lagrange.core.limits import MOST_REMEMBERED_COUNTS


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
    """How many different parts some expressions have: what a program takes that evaluates each of them once."""
    return sum(1 for e in distinct_parts(expressions) if e.args)


def _of_sum(e: sp.Expr, rest: list[sp.Expr]) -> int:
    """One operation between two terms, and one more where all are subtracted."""
    negative = [_is_negative(term) for term in e.args]
    rest.extend(-term if minus else term for term, minus in zip(e.args, negative, strict=True))
    return len(e.args) - 1 + all(negative)


def _of_product(e: sp.Expr, rest: list[sp.Expr]) -> int:
    """Its sign, one division by all that is below the line, and one multiplication between two factors."""
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
    """Whether it is clear on which side of the line a factor stands."""
    return not isinstance(factor, sp.exp) and factor.is_commutative and (not factor.is_Pow or factor.exp.is_Rational)
