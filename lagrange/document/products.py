"""A term taken apart, as it is going to be written: sign, numbers, factors above and below the line.

Nothing is multiplied out and nothing cancels; only signs are gathered: -(-a - b) c is written (a + b) c.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import sympy as sp

Factor = tuple[sp.Expr, sp.Expr]  # base and exponent


@dataclass
class Product:
    """A term. The numbers are positive and not 1, and no exponent is negative."""

    negative: bool = False
    numbers: list[sp.Number] = field(default_factory=list)
    divisors: list[sp.Number] = field(default_factory=list)
    above: list[Factor] = field(default_factory=list)
    below: list[Factor] = field(default_factory=list)


def product(term: sp.Expr) -> Product:
    """Takes a term apart."""
    parts = Product()
    for factor in flat(term):
        if isinstance(factor, sp.Rational | sp.Float):
            _number(factor, parts)
        elif isinstance(factor, sp.Add) and factor is not term and _all_negative(factor):
            parts.negative = not parts.negative
            parts.above.append((sp.Add(*(-a for a in factor.args)), sp.S.One))
        elif isinstance(factor, sp.Pow):
            base, exponent = factor.args
            if is_negative(exponent):
                parts.below.append((base, -exponent))
            else:
                parts.above.append((base, exponent))
        else:
            parts.above.append((factor, sp.S.One))
    return parts


def factors(term: sp.Expr) -> list[Factor]:
    """All factors with their exponents, of either sign."""
    return [part.args if isinstance(part, sp.Pow) else (part, sp.S.One) for part in flat(term)]


def flat(term: sp.Expr) -> Iterator[sp.Expr]:
    """The factors of nested products."""
    if isinstance(term, sp.Mul):
        for part in term.args:
            yield from flat(part)
    else:
        yield term


def is_negative(term: sp.Expr) -> bool:
    """Whether a term is written with a minus."""
    negative = False
    for factor in flat(term):
        if isinstance(factor, sp.Rational | sp.Float):
            negative ^= bool(factor < 0)
        elif isinstance(factor, sp.Add) and factor is not term and _all_negative(factor):
            negative = not negative
    return negative


def _all_negative(total: sp.Add) -> bool:
    return all(is_negative(a) for a in total.args)


def _number(number: sp.Number, parts: Product) -> None:
    if number < 0:
        parts.negative = not parts.negative
        number = -number
    if isinstance(number, sp.Float):
        parts.numbers.append(number)
        return
    if number.p != 1:
        parts.numbers.append(sp.Integer(number.p))
    if number.q != 1:
        parts.divisors.append(sp.Integer(number.q))
