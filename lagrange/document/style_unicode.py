"""How the terminal spells mathematics: θ̈ + (g/l) sin θ."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import ClassVar

import sympy as sp

from lagrange.document.names import SUPERSCRIPTS, Name, unicode_name
from lagrange.document.pieces import BREAK, END, START, Level, Piece, brackets, plain
from lagrange.document.styles import Text

_VULGAR = {
    "1/2": "½",
    "1/3": "⅓",
    "2/3": "⅔",
    "1/4": "¼",
    "3/4": "¾",
    "1/6": "⅙",
    "5/6": "⅚",
    "1/8": "⅛",
    "3/8": "⅜",
}


class Unicode(Text):
    """The terminal: `θ̈ + (g/l) sin θ`."""

    column = 1
    minus = " − "
    sign = "−"
    times = " "
    between_numbers = "·"
    constants: ClassVar[Mapping[str, str]] = {"Pi": "π", "Exp1": "e", "Infinity": "∞"}
    by_hand = True

    def name(self, name: str, vector: bool = False) -> Piece:
        """A symbol."""
        parts = Name.of(name)
        return Piece(unicode_name(parts), tight=parts.is_letter and not parts.operator and not vector)

    def number(self, number: sp.Number) -> Piece:
        """A positive integer or float."""
        if isinstance(number, sp.Float):
            digits, _, exponent = f"{float(number):.6g}".partition("e")
            power = "·10" + str(int(exponent)).translate(SUPERSCRIPTS) if exponent else ""
            return Piece(digits + power, tight=True)
        return Piece(str(int(number)), tight=True)

    def coefficient(self, numerator: Piece, denominator: Piece) -> Piece:
        """½, or (5/12)."""
        code = f"{numerator.code}/{denominator.code}"
        return Piece(_VULGAR[code]) if code in _VULGAR else Piece(f"({code})")

    def between(self, before: Piece, after: Piece) -> str:
        """A space, but 2x."""
        usual = super().between(before, after)
        counts = before.code.replace(".", "").isdigit() and after.tight
        return "" if counts and usual == self.times else usual

    def applied(self, function: str, argument: str, raised: bool) -> Piece:
        """`sin θ`, `sin²θ`."""
        return Piece(f"{function}{argument}" if raised else f"{function} {argument}", Level.APPLICATION)

    def bracketed(self, code: str) -> str:
        """Round brackets; around a sum that has some, square ones, then braces."""
        left, right = brackets(code)
        return f"{left}{code}{right}"

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power of what needs no brackets."""
        if exponent.code.isdigit():
            return Piece(base + exponent.code.translate(SUPERSCRIPTS), Level.POWER, tight=True)
        inner = exponent.code if exponent.level >= Level.ATOM else f"({exponent.code})"
        return Piece(f"{base}^{plain(inner)}", Level.POWER, tight=True)

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A fraction on one line; a long one may be broken before the line."""
        piece = super().fraction(numerator, denominator)
        if BREAK not in numerator.code:
            return piece
        above = self.bracketed(numerator.code) if numerator.level <= Level.DIVISION else numerator.code
        return Piece(f"{START}{above}{BREAK}{piece.code.removeprefix(above)}{END}", Level.DIVISION)

    def root(self, inner: Piece) -> Piece:
        """A square root."""
        code = inner.code if inner.level == Level.ATOM else f"({inner.code})"
        return Piece("√" + code, Level.POWER, tight=True)

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value."""
        return Piece(f"|{inner.code}|")

    def dot(self, a: Piece, b: Piece) -> Piece:
        """A scalar product."""
        return Piece(f"{self._operand(a)}·{self._operand(b)}", Level.DIVISION)

    def wedge(self, forms: Sequence[Piece]) -> Piece:
        """An exterior product."""
        return Piece(" ∧ ".join(self._operand(f) for f in forms), Level.PRODUCT)

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative."""
        above, below = self._differentials("∂", "", inner, variables)
        where = self.arguments(at) if at else ""
        return Piece(f"{above}/{below}{where}", Level.DIVISION)

    def rate(self, inner: Piece) -> Piece:
        """A total time derivative."""
        if inner.level == Level.ATOM and len(inner.code) < 8 and "(" not in inner.code:
            return Piece(f"d{inner.code}/dt", Level.DIVISION)
        return Piece(f"d/dt {self.bracketed(inner.code)}", Level.DIVISION)

    def _operand(self, piece: Piece) -> str:
        return self.bracketed(piece.code) if piece.level <= Level.DIVISION else piece.code

    def _differentials(self, sign: str, gap: str, inner: Piece, variables: Sequence[str]) -> tuple[str, str]:
        """∂²f and ∂X∂Y, with ∂X² where a variable comes twice."""
        counts = {v: variables.count(v) for v in variables}
        raised = self.power(sign, Piece(str(len(variables)))).code if len(variables) > 1 else sign
        pieces = []
        for variable, n in counts.items():
            code = self.name(variable).code
            pieces.append(f"{sign}{gap}{self.power(code, Piece(str(n))).code if n > 1 else code}")
        body = inner.code if inner.level == Level.ATOM else self.bracketed(inner.code)
        return f"{raised}{gap}{body}", gap.join(pieces)
