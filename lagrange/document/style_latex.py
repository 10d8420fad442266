r"""Spelling of mathematics in LaTeX with amsmath, as typed by hand: `\ddot{\theta} + \frac{g}{l} \sin\theta`.

TeX breaks no line inside a fraction, a root, or `\left ... \right`. `WideLatex` is for equations too wide for a line:
it writes a long fraction as a product with a reciprocal or as a quotient with a slash, and a long root as a power.
`RunningLatex` is for formulas in a sentence.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import ClassVar

import sympy as sp

from lagrange.document.limits import LONG_LATEX
from lagrange.document.names import BREAK, END, START, Piece, Precedence, WrittenName, brackets, latex_name, plain
from lagrange.document.styles import FUNCTIONS, Unicode, figures

_SLOPE = re.compile(r"\\frac\{(\\partial (?:[^{}]|\{\w+\})+)\}\{(\\partial (?:[^{}]|\{\w+\})+)\}")
_SET_OFF = (r"\mathrm{d}", r"\delta ", r"\mathbf{")


class Latex(Unicode):
    """LaTeX with amsmath."""

    column = 2
    minus = " - "
    sign = "-"
    between_numbers = r" \cdot "
    stacked = True
    constants: ClassVar[Mapping[str, str]] = {"Pi": r"\pi", "Exp1": r"\mathrm{e}", "Infinity": r"\infty"}

    def function(self, name: str) -> str:
        """The command of a function."""
        return FUNCTIONS[name][self.column] if name in FUNCTIONS else rf"\operatorname{{{name}}}"

    def name(self, name: str, vector: bool = False) -> Piece:
        """A symbol."""
        parts = WrittenName.of(name)
        return Piece(latex_name(parts, vector), tight=parts.is_letter and not parts.operator and not vector)

    def number(self, number: sp.Number) -> Piece:
        """A positive integer or float."""
        if isinstance(number, sp.Float):
            digits, exponent = figures(number)
            return Piece(digits + ("" if exponent is None else rf" \cdot 10^{{{exponent}}}"), tight=True)
        return Piece(str(int(number)), tight=True)

    def unit(self, name: str) -> Piece:
        r"""A unit of measurement after a number: `\,\mathrm{m/s^{2}}`."""
        if name == "°":
            return Piece(r"^\circ")
        raised = re.sub(r"\^(-?\d+)", r"^{\1}", name).replace(" ", r"\,")
        return Piece(rf"\,\mathrm{{{raised}}}")

    def coefficient(self, numerator: Piece, denominator: Piece) -> Piece:
        """A small fraction."""
        return Piece(rf"\tfrac{{{numerator.code}}}{{{denominator.code}}}")

    def between(self, before: Piece, after: Piece) -> str:
        """A space, but 2x; a thin space before differentials and unit vectors."""
        usual = super().between(before, after)
        return r" \, " if after.code.startswith(_SET_OFF) and usual != self.between_numbers else usual

    def applied(self, function: str, argument: str, raised: bool) -> Piece:
        r"""`\sin\theta`, `\sin x`."""
        del raised
        gap = "" if argument.startswith("\\") else " "
        return Piece(f"{function}{gap}{argument}", Precedence.APPLICATION)

    def bracketed(self, code: str) -> str:
        """Brackets that grow only around fractions."""
        left, right = ("\\" + b if b in "{}" else b for b in brackets(code, r"\{"))
        return rf"\left{left} {code} \right{right}" if is_tall(code) else f"{left}{code}{right}"

    def arguments(self, codes: Sequence[str]) -> str:
        """The argument list of a function."""
        code = ", ".join(codes)
        return rf"\left( {code} \right)" if is_tall(code) else f"({code})"

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A fraction."""
        return Piece(rf"\frac{{{_flat(numerator)}}}{{{_flat(denominator)}}}", Precedence.PRODUCT)

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power; the base has its brackets already."""
        return Piece(f"{base}^{{{plain(exponent.code)}}}", Precedence.POWER, tight=True)

    def exponential(self, exponent: Piece) -> Piece:
        """A power of e."""
        return Piece(rf"\mathrm{{e}}^{{{plain(exponent.code)}}}", Precedence.POWER)

    def root(self, inner: Piece) -> Piece:
        """A square root."""
        return Piece(rf"\sqrt{{{plain(inner.code)}}}")

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value."""
        if is_tall(inner.code):
            return Piece(rf"\left\lvert {plain(inner.code)} \right\rvert")
        return Piece(rf"\lvert {inner.code} \rvert")

    def dot(self, a: Piece, b: Piece) -> Piece:
        """A scalar product."""
        return Piece(rf"{self._operand(a)} \cdot {self._operand(b)}", Precedence.DIVISION)

    def cross(self, a: Piece, b: Piece) -> Piece:
        """A vector product."""
        return Piece(rf"{self._operand(a)} \times {self._operand(b)}", Precedence.DIVISION)

    def wedge(self, forms: Sequence[Piece]) -> Piece:
        """An exterior product."""
        return Piece(r" \wedge ".join(self._operand(f) for f in forms), Precedence.PRODUCT)

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative."""
        if is_tall(inner.code) and not at:
            body = inner.code if inner.level >= Precedence.PRODUCT else self.bracketed(inner.code)
            below = self._differentials(r"\partial", " ", Piece(""), variables)[1]
            raised = self.power(r"\partial", Piece(str(len(variables)))).code if len(variables) > 1 else r"\partial"
            return Piece(rf"\frac{{{raised}}}{{{below}}} {body}", Precedence.PRODUCT)
        above, below = self._differentials(r"\partial", " ", inner, variables)
        code = rf"\frac{{{plain(above)}}}{{{below}}}"
        return Piece(code + (self.arguments(at) if at else ""), Precedence.PRODUCT)

    def slope(self, inner: Piece, order: int, at: Sequence[str] = ()) -> Piece:
        """A derivative of a function of one variable."""
        return Piece(inner.code + "'" * order + (self.arguments(at) if at else ""))

    def rate(self, inner: Piece) -> Piece:
        """A total time derivative."""
        if inner.level == Precedence.ATOM and "(" not in inner.code:
            return Piece(rf"\frac{{\mathrm{{d}}{inner.code}}}{{\mathrm{{d}}t}}", Precedence.PRODUCT)
        body = inner.code if inner.level >= Precedence.PRODUCT and is_tall(inner.code) else self.bracketed(inner.code)
        return Piece(rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}} {body}", Precedence.PRODUCT)

    def integral(self, body: Piece, start: Piece, end: Piece) -> Piece:
        """A definite integral."""
        return Piece(rf"\int_{{{plain(start.code)}}}^{{{plain(end.code)}}} {body.code}", Precedence.DIVISION)

    def zero_vector(self) -> Piece:
        """The vector 0."""
        return Piece(r"\mathbf{0}")


class WideLatex(Latex):
    r"""LaTeX for equations too wide for a line: long fractions and roots can be broken."""

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """`\frac{1}{b} (...)`, and `(...) / (...)` where both parts are long."""
        if not {BREAK} & {*numerator.code, *denominator.code}:
            return super().fraction(numerator, denominator)
        if BREAK not in denominator.code:
            reciprocal = super().fraction(Piece("1"), denominator).code
            inner = numerator.code if numerator.level > Precedence.DIVISION else self.bracketed(numerator.code)
            return Piece(f"{reciprocal} {inner}", Precedence.PRODUCT)
        if BREAK not in numerator.code and len(denominator.code) < LONG_LATEX:
            return super().fraction(numerator, denominator)
        above = self.bracketed(numerator.code) if numerator.level <= Precedence.DIVISION else numerator.code
        below = self.bracketed(denominator.code) if denominator.level <= Precedence.PRODUCT else denominator.code
        if BREAK not in above:
            return Piece(f"{above} / {below}", Precedence.DIVISION)
        return Piece(f"{START}{above}{BREAK} / {below}{END}", Precedence.DIVISION)

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value with bars of fixed size, so that it can be broken across lines."""
        if BREAK not in inner.code or not is_tall(inner.code):
            return super().absolute(inner)
        return Piece(rf"\biggl\lvert {inner.code} \biggr\rvert")

    def root(self, inner: Piece) -> Piece:
        """A power 1/2 where the root is long."""
        if len(inner.code) < LONG_LATEX:
            return super().root(inner)
        return Piece(self.bracketed(inner.code) + "^{1/2}", Precedence.POWER)


class RunningLatex(Latex):
    """LaTeX in running text, where a fraction line would make the letters too small: W/(2 cos α)."""

    stacked = False
    within_argument = " "

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A quotient with a slash; of numbers alone, a small fraction."""
        if numerator.code.isdigit() and denominator.code.isdigit():
            return self.coefficient(numerator, denominator)
        above = self.bracketed(numerator.code) if numerator.level <= Precedence.DIVISION else numerator.code
        below = self.bracketed(denominator.code) if denominator.level <= Precedence.PRODUCT else denominator.code
        return Piece(f"{plain(above)}/{plain(below)}", Precedence.DIVISION)


def _flat(piece: Piece) -> str:
    r"""The code above or below a fraction line: a lone ∂f/∂x is `\partial f / \partial x` there."""
    code = plain(piece.code)
    slope = _SLOPE.fullmatch(code)
    return f"{slope[1]} / {slope[2]}" if slope else code


def is_tall(code: str) -> bool:
    """Whether brackets around the code have to grow."""
    return r"\frac" in code
