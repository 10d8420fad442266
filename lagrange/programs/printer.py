"""Expressions in the syntax of a programming language.

Only numbers, +, ·, powers and the functions of a short list are written; everything else is refused. A
symbol is written by the name that the caller has given it, which is made by `names.py` or is an element of an array:
no text of a file becomes code.

Numbers are written as floating-point literals, so that 1/2 is no division of integers; a fraction p/q is a quotient of
such literals, correctly rounded as each language divides. `x^2` is written as a product where that is one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import sympy as sp

from lagrange.core.diagnostics import NotCoveredError
from lagrange.core.records import record
from lagrange.programs.limits import LARGEST_WHOLE

_SUM, _PRODUCT, _POWER, _ATOM = range(1, 5)
_RECIPROCAL: dict[type[sp.Basic], type[sp.Basic]] = {sp.cot: sp.tan, sp.sec: sp.cos, sp.csc: sp.sin}
FUNCTIONS: dict[type[sp.Basic], str] = {
    sp.sin: "sin", sp.cos: "cos", sp.tan: "tan", sp.asin: "asin", sp.acos: "acos", sp.atan: "atan",
    sp.atan2: "atan2", sp.sinh: "sinh", sp.cosh: "cosh", sp.tanh: "tanh", sp.exp: "exp", sp.log: "log",
    sp.Abs: "abs", sp.sign: "sign",
}  # fmt: skip
"""The functions that are written, besides sqrt, and cot, sec, csc as reciprocals."""


@record
class Syntax:
    """What expressions look like in a language.

    functions  the name of each function that is not called as in `FUNCTIONS`; `sqrt` and `power` among them
    power      the infix operator of powers with whole exponents; empty: the function `power`
    """

    functions: Mapping[str, str] = field(default_factory=dict)
    power: str = ""

    def function(self, name: str) -> str:
        """The name of a function."""
        return self.functions.get(name, name)


class Printer:
    """Writes expressions in a syntax; `names` gives the code of each symbol."""

    def __init__(self, syntax: Syntax, names: Mapping[sp.Symbol, str]) -> None:
        self._syntax = syntax
        self._names = names

    def __call__(self, expression: sp.Expr) -> str:
        """The code of an expression. Raises NotCoveredError at what has none."""
        return self._written(expression, 0)

    def _written(self, e: sp.Basic, within: int) -> str:
        code, level = self._code(e)
        return f"({code})" if level < within else code

    def _code(self, e: sp.Basic) -> tuple[str, int]:
        if isinstance(e, sp.Symbol):
            return self._symbol(e), _ATOM
        if isinstance(e, sp.Rational | sp.Float) or e in (sp.pi, sp.E):
            return _number(e)
        if isinstance(e, sp.Add):
            return self._sum(e), _SUM
        if isinstance(e, sp.Mul):
            return self._product(e)
        if isinstance(e, sp.Pow):
            return self._power(e.base, e.exp)
        return self._call(e)

    def _symbol(self, s: sp.Symbol) -> str:
        if s not in self._names:
            raise NotCoveredError(f"`{s.name}` as part of a program")
        return self._names[s]

    def _sum(self, e: sp.Add) -> str:
        code = ""
        for term in sorted(e.args, key=_is_negative):
            negative = _is_negative(term)
            written = self._written(-term if negative else term, _PRODUCT)
            sign = ("-" if negative else "") if not code else (" - " if negative else " + ")
            code += sign + written
        return code

    def _product(self, e: sp.Mul) -> tuple[str, int]:
        if _is_negative(e):
            return f"-{self._written(-e, _PRODUCT)}", _SUM
        above: list[sp.Expr] = []
        below: list[sp.Expr] = []
        for f in e.args:
            if isinstance(f, sp.Pow) and f.exp.is_Rational and f.exp < 0:
                below.append(sp.Pow(f.base, -f.exp, evaluate=False) if f.exp != -1 else f.base)
            elif isinstance(f, sp.Rational) and f.q != 1:
                above += [sp.Integer(f.p)] if f.p != 1 else []
                below.append(sp.Integer(f.q))
            else:
                above.append(f)
        top = "*".join(self._written(f, _PRODUCT) for f in above) or "1.0"
        if not below:
            return top, _PRODUCT
        bottom = "*".join(self._written(f, _PRODUCT) for f in below)
        alone = len(below) == 1 and self._code(below[0])[1] >= _POWER
        return f"{top}/{bottom if alone else f'({bottom})'}", _PRODUCT

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> tuple[str, int]:
        call = self._syntax.function
        if exponent == sp.S.Half:
            return f"{call('sqrt')}({self._written(base, 0)})", _ATOM
        if exponent.is_Rational and exponent < 0:
            below, level = self._power(base, -exponent) if exponent != -1 else self._code(base)
            return f"1.0/{below if level >= _POWER else f'({below})'}", _PRODUCT
        if exponent in (2, 3) and not base.args:
            return "*".join([self._written(base, _POWER)] * int(exponent)), _PRODUCT
        if exponent.is_Integer and self._syntax.power:
            return f"{self._written(base, _ATOM)}{self._syntax.power}{exponent}", _POWER
        return f"{call('power')}({self._written(base, 0)}, {self._written(exponent, 0)})", _ATOM

    def _call(self, e: sp.Basic) -> tuple[str, int]:
        arguments = ", ".join(self._written(a, 0) for a in e.args if isinstance(a, sp.Expr))
        if type(e) in _RECIPROCAL:
            return f"1.0/{self._syntax.function(FUNCTIONS[_RECIPROCAL[type(e)]])}({arguments})", _PRODUCT
        name = FUNCTIONS.get(type(e))
        if name is None:
            raise NotCoveredError(f"`{type(e).__name__}` as part of a program")
        return f"{self._syntax.function(name)}({arguments})", _ATOM


def _is_negative(e: sp.Basic) -> bool:
    return bool(e.could_extract_minus_sign()) and (e.is_Mul or e.is_Number) and bool(e.as_coeff_Mul()[0].is_negative)


def _number(e: sp.Expr) -> tuple[str, int]:
    """A literal, and how strongly it binds."""
    if e.is_Rational and max(abs(e.p), e.q) < LARGEST_WHOLE:
        level = _ATOM if e.p >= 0 else _SUM
        if e.q == 1:
            return f"{e.p}.0", level
        short = repr(float(e))
        if len(short) <= 8 and "e" not in short and sp.Rational(short) == e:
            return short, level
        return f"{e.p}.0/{e.q}.0", min(level, _PRODUCT)
    try:
        number = float(e)
    except OverflowError:
        raise NotCoveredError("a number beyond the range of floating point") from None
    return repr(number), _ATOM if number >= 0 else _SUM
