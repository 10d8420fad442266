"""Expressions as one list of operations, to be evaluated many times, in floating point or with many digits.

A subexpression that occurs several times is one operation. The second arithmetic is the judge of the first: a zero of
floats is only a guess, which `newton.confirmed` follows to sixty digits.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import mpmath
import sympy as sp

from lagrange.core.floats import FUNCTIONS
from lagrange.core.records import record

Number = Any
"""A float, or a number of mpmath."""


class NoTapeError(Exception):
    """An expression has a part that is not evaluated: an undefined function, a case distinction."""


@record
class Arithmetic:
    """How operations are carried out. They raise ValueError or ArithmeticError where there is no real value."""

    rational: Callable[[int, int], Number]
    pi: Callable[[], Number]
    root: Callable[[Number], Number]
    power: Callable[[Number, Number], Number]
    functions: Mapping[type[sp.Basic], Callable[..., Number]]


def _real(function: Callable[..., Number]) -> Callable[..., Number]:
    """A function of mpmath that refuses complex values."""

    def real(*arguments: Number) -> Number:
        value = function(*arguments)
        if isinstance(value, mpmath.mpc):
            raise ValueError
        return value

    return real


_NAMES = {f: f.__name__.lower() for f in FUNCTIONS} | {sp.Abs: "fabs", sp.sign: "sign"}

FLOATS = Arithmetic(lambda p, q: p / q, lambda: math.pi, math.sqrt, math.pow, FUNCTIONS)
DIGITS = Arithmetic(
    lambda p, q: mpmath.mpf(p) / q,
    lambda: +mpmath.mp.pi,
    _real(mpmath.sqrt),
    _real(mpmath.power),
    {f: _real(getattr(mpmath, name)) for f, name in _NAMES.items()},
)


class Tape:
    """Several expressions of the same symbols; `carried_out` counts operations."""

    def __init__(self, expressions: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> None:
        self._places: dict[sp.Basic, int] = {s: n for n, s in enumerate(symbols)}
        self._given = len(symbols)
        self._operations: list[tuple[str, Any, tuple[int, ...]]] = []
        self._results = [self._placed(e) for e in expressions]
        self.carried_out = 0

    def values(self, given: Sequence[Number], by: Arithmetic = FLOATS) -> list[Number]:
        """The values of the expressions. Raises ValueError or ArithmeticError if one has none."""
        self.carried_out += len(self._operations)
        v = list(given)
        for kind, data, needs in self._operations:
            match kind:
                case "+":
                    v.append(sum([v[n] for n in needs]))
                case "*":
                    product = v[needs[0]]
                    for n in needs[1:]:
                        product = product * v[n]
                    v.append(product)
                case "^":
                    v.append(v[needs[0]] ** data if data > 0 else 1 / v[needs[0]] ** -data)
                case "root":
                    root = by.root(v[needs[0]])
                    v.append(root**data if data > 0 else 1 / root**-data)
                case "number":
                    v.append(by.rational(*data))
                case "pi":
                    v.append(by.pi())
                case "power":
                    v.append(by.power(*(v[n] for n in needs)))
                case _:
                    v.append(by.functions[data](*(v[n] for n in needs)))
        return [v[n] for n in self._results]

    def _placed(self, e: sp.Basic) -> int:
        place = self._places.get(e)
        if place is None:
            operation = self._operation(e)
            place = self._places[e] = self._given + len(self._operations)
            self._operations.append(operation)
        return place

    def _operation(self, e: sp.Basic) -> tuple[str, Any, tuple[int, ...]]:
        """The operation that an expression ends with. Raises NoTapeError."""
        if isinstance(e, sp.Rational):
            return "number", (int(e.p), int(e.q)), ()
        if e == sp.pi:
            return "pi", None, ()
        if isinstance(e, sp.Pow) and e.exp.is_Integer:
            return "^", int(e.exp), (self._placed(e.base),)
        if isinstance(e, sp.Pow) and e.exp.is_Rational and e.exp.q == 2:
            return "root", int(e.exp.p), (self._placed(e.base),)
        kind = "+" if e.is_Add else "*" if e.is_Mul else "power" if e.is_Pow else "f" if e.func in FUNCTIONS else None
        if kind is None:
            raise NoTapeError
        return kind, e.func, tuple(self._placed(a) for a in e.args)
