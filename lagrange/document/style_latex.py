r"""How LaTeX spells mathematics, as typed by hand: `\ddot{\theta} + \frac{g}{l} \sin\theta`."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import ClassVar

import sympy as sp

from lagrange.document.names import Name, latex_name
from lagrange.document.pieces import BREAK, END, START, Level, Piece, brackets, plain
from lagrange.document.style_unicode import Unicode
from lagrange.document.styles import FUNCTIONS

LONG = 120  # characters of LaTeX that are about a third of a line


_SLOPE = re.compile(r"\\frac\{(\\partial (?:[^{}]|\{\w+\})+)\}\{(\\partial (?:[^{}]|\{\w+\})+)\}")
_SET_OFF = (r"\mathrm{d}", r"\delta ", r"\mathbf{e}", r"\mathbf{i}", r"\mathbf{j}", r"\mathbf{k}")


class Latex(Unicode):
    r"""LaTeX with amsmath, as typed by hand: `\ddot{\theta} + \frac{g}{l} \sin\theta`."""

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
        parts = Name.of(name)
        return Piece(latex_name(parts, vector), tight=parts.is_letter and not parts.operator and not vector)

    def number(self, number: sp.Number) -> Piece:
        """A positive integer or float."""
        if isinstance(number, sp.Float):
            digits, _, exponent = f"{float(number):.6g}".partition("e")
            return Piece(digits + (rf" \cdot 10^{{{int(exponent)}}}" if exponent else ""), tight=True)
        return Piece(str(int(number)), tight=True)

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
        return Piece(f"{function}{gap}{argument}", Level.APPLICATION)

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
        return Piece(rf"\frac{{{_flat(numerator)}}}{{{_flat(denominator)}}}", Level.PRODUCT)

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power of what needs no brackets."""
        return Piece(f"{base}^{{{plain(exponent.code)}}}", Level.POWER, tight=True)

    def exponential(self, exponent: Piece) -> Piece:
        """A power of e."""
        return Piece(rf"\mathrm{{e}}^{{{plain(exponent.code)}}}", Level.POWER)

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
        return Piece(rf"{self._operand(a)} \cdot {self._operand(b)}", Level.DIVISION)

    def wedge(self, forms: Sequence[Piece]) -> Piece:
        """An exterior product."""
        return Piece(r" \wedge ".join(self._operand(f) for f in forms), Level.PRODUCT)

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative."""
        if is_tall(inner.code) and not at:
            body = inner.code if inner.level >= Level.PRODUCT else self.bracketed(inner.code)
            below = self._differentials(r"\partial", " ", Piece(""), variables)[1]
            raised = self.power(r"\partial", Piece(str(len(variables)))).code if len(variables) > 1 else r"\partial"
            return Piece(rf"\frac{{{raised}}}{{{below}}} {body}", Level.PRODUCT)
        above, below = self._differentials(r"\partial", " ", inner, variables)
        code = rf"\frac{{{plain(above)}}}{{{below}}}"
        return Piece(code + (self.arguments(at) if at else ""), Level.PRODUCT)

    def rate(self, inner: Piece) -> Piece:
        """A total time derivative."""
        if inner.level == Level.ATOM and "(" not in inner.code:
            return Piece(rf"\frac{{\mathrm{{d}}{inner.code}}}{{\mathrm{{d}}t}}", Level.PRODUCT)
        body = inner.code if inner.level >= Level.PRODUCT and is_tall(inner.code) else self.bracketed(inner.code)
        return Piece(rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}t}} {body}", Level.PRODUCT)

    def zero_vector(self) -> Piece:
        """The vector 0."""
        return Piece(r"\mathbf{0}")


class WideLatex(Latex):
    r"""LaTeX for what is too wide for a line: long fractions and roots can be broken."""

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """`\frac{1}{b} (...)`, and `(...) / (...)` where both parts are long."""
        if not {BREAK} & {*numerator.code, *denominator.code}:
            return super().fraction(numerator, denominator)
        if BREAK not in denominator.code:
            one = super().fraction(Piece("1"), denominator).code
            inner = numerator.code if numerator.level > Level.DIVISION else self.bracketed(numerator.code)
            return Piece(f"{one} {inner}", Level.PRODUCT)
        if BREAK not in numerator.code and len(denominator.code) < LONG:
            return super().fraction(numerator, denominator)
        above = self.bracketed(numerator.code) if numerator.level <= Level.DIVISION else numerator.code
        below = self.bracketed(denominator.code) if denominator.level <= Level.PRODUCT else denominator.code
        if BREAK not in above:
            return Piece(f"{above} / {below}", Level.DIVISION)
        return Piece(f"{START}{above}{BREAK} / {below}{END}", Level.DIVISION)

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value whose bars have a fixed size, so that it can be broken."""
        if BREAK not in inner.code or not is_tall(inner.code):
            return super().absolute(inner)
        return Piece(rf"\biggl\lvert {inner.code} \biggr\rvert")

    def root(self, inner: Piece) -> Piece:
        """A power 1/2 where the root is long."""
        if len(inner.code) < LONG:
            return super().root(inner)
        return Piece(self.bracketed(inner.code) + "^{1/2}", Level.POWER)


def _flat(piece: Piece) -> str:
    r"""The code above or below a fraction line: a lone ∂f/∂x is `\partial f / \partial x` there."""
    code = plain(piece.code)
    found = _SLOPE.fullmatch(code)
    return f"{found[1]} / {found[2]}" if found else code


def is_tall(code: str) -> bool:
    """Whether brackets around it have to grow."""
    return r"\frac" in code
