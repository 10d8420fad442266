"""Expressions as functions of JavaScript, with names of the program's own.

An expression is written node by node. Only the kinds of nodes in the tables below are known, and a symbol is written as
the name that the caller gives it (`y[0]`, `p[3]`): no text of a file gets into the code. A part that occurs more than
once in a function is computed once, as `x0`, `x1`, ...
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.core.symbols import Unspecified

Names = Mapping[sp.Symbol, str]

_FUNCTIONS: dict[type[sp.Basic], str] = {
    sp.sin: "Math.sin",
    sp.cos: "Math.cos",
    sp.tan: "Math.tan",
    sp.asin: "Math.asin",
    sp.acos: "Math.acos",
    sp.atan: "Math.atan",
    sp.atan2: "Math.atan2",
    sp.sinh: "Math.sinh",
    sp.cosh: "Math.cosh",
    sp.tanh: "Math.tanh",
    sp.exp: "Math.exp",
    sp.log: "Math.log",
    sp.Abs: "Math.abs",
    sp.sign: "Math.sign",
}


class UnprintableError(ValueError):
    """An expression cannot be written; the message says what in it, in words for a reader."""


def function(arguments: str, expressions: Sequence[sp.Expr], names: Names) -> str:
    """`(y, p) => { ...; return [...]; }`, which returns the values of all expressions. Raises UnprintableError."""
    return _Writer(names, expressions).function(arguments)


def names_of(array: str, symbols: Sequence[sp.Symbol]) -> dict[sp.Symbol, str]:
    """The name of each symbol as a component of an array."""
    return {s: f"{array}[{n}]" for n, s in enumerate(symbols)}


class _Writer:
    """Writes one function."""

    def __init__(self, names: Names, expressions: Sequence[sp.Expr]) -> None:
        self.names = names
        self.expressions = [sp.sympify(e, strict=True) for e in expressions]
        self.uses: Counter[sp.Basic] = Counter()
        for e in self.expressions:
            self._count(e)
        self.lines: list[str] = []
        self.known: dict[sp.Basic, str] = {}

    def _count(self, e: sp.Basic) -> None:
        self.uses[e] += 1
        if self.uses[e] == 1:
            for a in e.args:
                self._count(a)

    def function(self, arguments: str) -> str:
        values = ", ".join(self.write(e) for e in self.expressions)
        return f"({arguments}) => {{ {' '.join(self.lines)}{' ' if self.lines else ''}return [{values}]; }}"

    def write(self, e: sp.Basic) -> str:
        """An expression in parentheses, or the name of its value."""
        if e not in self.known:
            code = self._written(e)
            if e.args and self.uses[e] > 1:
                name = f"x{len(self.lines)}"
                self.lines.append(f"const {name} = {code};")
                code = name
            self.known[e] = code
        return self.known[e]

    def _written(self, e: sp.Basic) -> str:
        if isinstance(e, sp.Symbol):
            if e not in self.names:
                raise UnprintableError(f"{e.name} has no value")
            return self.names[e]
        if isinstance(e, sp.Number | sp.NumberSymbol):
            return _number(e)
        if e.is_Add:
            return "(" + " + ".join(map(self.write, e.args)) + ")"
        if e.is_Mul:
            return self._product(e)
        if isinstance(e, sp.Pow):
            return self._power(e.base, e.exp)
        if isinstance(e, sp.cot):
            return f"(1/Math.tan({self.write(e.args[0])}))"
        if isinstance(e, Unspecified):
            raise UnprintableError(f"the function {e.name} is not specified")
        name = _FUNCTIONS.get(type(e))
        if name is None:
            raise UnprintableError(f"{type(e).__name__} has no counterpart on a web page")
        return f"{name}({', '.join(map(self.write, e.args))})"

    def _product(self, e: sp.Basic) -> str:
        above, below = [], []
        for a in e.args:
            if isinstance(a, sp.Pow) and a.exp.is_Number and a.exp < 0 and self.uses[a] < 2:
                below.append(self.write(a.base) if a.exp == -1 else self._power(a.base, -a.exp))
            else:
                above.append(self.write(a))
        over = "*".join(above) or "1"
        return f"({over}/({'*'.join(below)}))" if below else f"({over})"

    def _power(self, base: sp.Basic, exponent: sp.Basic) -> str:
        b = self.write(base)
        if exponent == sp.Rational(1, 2):
            return f"Math.sqrt({b})"
        if exponent == sp.Rational(-1, 2):
            return f"(1/Math.sqrt({b}))"
        if exponent == -1:
            return f"(1/({b}))"
        if exponent == 2 and (base.is_Symbol or b.startswith("x")):
            return f"({b}*{b})"
        return f"Math.pow({b}, {self.write(exponent)})"


def _number(e: sp.Basic) -> str:
    if isinstance(e, sp.Rational) and e.q == 1 and abs(e.p) < 2**53:
        return str(e.p) if e.p >= 0 else f"({e.p})"
    number = float(e)
    if not math.isfinite(number):
        raise UnprintableError("a number is not finite")
    return repr(number) if number >= 0 else f"({number!r})"
