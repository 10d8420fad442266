"""Spellings of mathematics for `math_writer`: the language of problem files, and Unicode for the terminal.

A style spells the pieces that the walker hands it, and decides nothing about order or structure. `Text` is the base of
all styles; `Unicode` is the base of those that write as by hand, θ̈ + (g/l) sin θ; LaTeX and MathML have modules of
their own.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping, Sequence
from typing import ClassVar

import sympy as sp
from mpmath.libmp import prec_to_dps

from lagrange.document.limits import LONGEST_EXPONENT, LONGEST_RATE, USUAL_DIGITS
from lagrange.document.names import (
    BREAK,
    END,
    START,
    SUPERSCRIPTS,
    Piece,
    Precedence,
    WrittenName,
    brackets,
    plain,
    unicode_name,
)

# SymPy's name: text, Unicode, LaTeX
FUNCTIONS: dict[str, tuple[str, str, str]] = {
    "sin": ("sin", "sin", r"\sin"),
    "cos": ("cos", "cos", r"\cos"),
    "tan": ("tan", "tan", r"\tan"),
    "cot": ("cot", "cot", r"\cot"),
    "sec": ("sec", "sec", r"\sec"),
    "csc": ("csc", "csc", r"\csc"),
    "asin": ("asin", "arcsin", r"\arcsin"),
    "acos": ("acos", "arccos", r"\arccos"),
    "atan": ("atan", "arctan", r"\arctan"),
    "atan2": ("atan2", "atan2", r"\operatorname{atan2}"),
    "sinh": ("sinh", "sinh", r"\sinh"),
    "cosh": ("cosh", "cosh", r"\cosh"),
    "tanh": ("tanh", "tanh", r"\tanh"),
    "exp": ("exp", "exp", r"\exp"),
    "log": ("log", "ln", r"\ln"),
    "sign": ("sign", "sgn", r"\operatorname{sgn}"),
}
BARE = frozenset({"sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan", "sinh", "cosh", "tanh", "log"})
POWERED = frozenset({"sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh"})

# text, Unicode, LaTeX
RELATIONS: dict[str, tuple[str, str, str]] = {
    "=": ("=", "=", "="),
    "≠": ("!=", "≠", r"\neq"),
    "<": ("<", "<", "<"),
    ">": (">", ">", ">"),
    "≤": ("<=", "≤", r"\le"),
    "≥": (">=", "≥", r"\ge"),
    "≡": ("==", "≡", r"\equiv"),
    "≈": ("~", "≈", r"\approx"),
    "→": ("->", "→", r"\to"),
    "∝": ("~", "∝", r"\propto"),
}
SAME = {"!=": "≠", "<=": "≤", ">=": "≥", "==": "≡", "->": "→"}


FIXED = range(-4, 6)
"""The powers of ten in front of which a number is written out: 0.0001234, 123400."""


def figures(number: sp.Float) -> tuple[str, int | None]:
    """The digits of a positive number, and its power of ten if it is very large or small.

    A number that was rounded has the precision of its digits, and shows all of them: 2.000.
    """
    if number._prec >= sys.float_info.mant_dig:
        digits, _, exponent = f"{float(number):.{USUAL_DIGITS}g}".partition("e")
        return digits, int(exponent) if exponent else None
    shown = prec_to_dps(number._prec)
    rounded = f"{float(number):.{shown - 1}e}"
    digits, _, exponent = rounded.partition("e")
    power = int(exponent)
    if power not in FIXED:
        return digits, power
    return f"{float(rounded):.{max(0, shown - 1 - power)}f}", None


class Text:
    """The language of problem files: `2*x*d(x)`, `l*theta'' + g*sin(theta)`."""

    column: ClassVar[int] = 0
    plus: ClassVar[str] = " + "
    minus: ClassVar[str] = " - "
    sign: ClassVar[str] = "-"
    times: ClassVar[str] = "*"
    between_numbers: ClassVar[str] = "*"
    constants: ClassVar[Mapping[str, str]] = {"Pi": "pi", "Exp1": "exp(1)", "Infinity": "oo"}
    by_hand: ClassVar[bool] = False  # coefficients in front, sin θ without parentheses, nested brackets
    stacked: ClassVar[bool] = False  # fractions have a line, and need no parentheses as arguments
    within_argument: ClassVar[str] = ""  # between the letters of a short argument: ωt

    def function(self, name: str) -> str:
        """The name of a function."""
        return FUNCTIONS[name][self.column] if name in FUNCTIONS else name

    def relation(self, relation: str) -> str:
        """The sign of a relation."""
        known = RELATIONS.get(SAME.get(relation, relation))
        return known[self.column] if known else relation

    def name(self, name: str, vector: bool = False) -> Piece:
        """A symbol."""
        del vector
        return Piece(name)

    def number(self, number: sp.Number) -> Piece:
        """A positive integer or float."""
        if not isinstance(number, sp.Float):
            return Piece(str(int(number)))
        digits, exponent = figures(number)
        return Piece(digits if exponent is None else f"{digits}e{exponent:+03d}")

    def unit(self, name: str) -> Piece:
        """A unit of measurement, with the space between it and the number before it."""
        return Piece(name if name == "°" else f" {name}")

    def coefficient(self, numerator: Piece, denominator: Piece) -> Piece:
        """A number such as 1/2 in front of a product."""
        return self.fraction(numerator, denominator)

    def between(self, before: Piece, after: Piece) -> str:
        """The code between two factors."""
        if after.code[0] in " °":  # a unit
            return ""
        return self.between_numbers if after.code[0].isdigit() or before.code == "0" else self.times

    def applied(self, function: str, argument: str, raised: bool) -> Piece:
        """A function with a short argument, where it needs no parentheses."""
        del raised
        return Piece(f"{function} {argument}", Precedence.APPLICATION)

    def bracketed(self, code: str) -> str:
        """Brackets around a sum."""
        return f"({code})"

    def arguments(self, codes: Sequence[str]) -> str:
        """The argument list of a function."""
        return f"({', '.join(codes)})"

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A fraction on one line."""
        above = self.bracketed(numerator.code) if numerator.level <= Precedence.DIVISION else numerator.code
        below = self.bracketed(denominator.code) if denominator.level <= Precedence.PRODUCT else denominator.code
        return Piece(f"{above}/{below}", Precedence.DIVISION)

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power; the base has its brackets already."""
        inner = exponent.code if exponent.level >= Precedence.ATOM else f"({exponent.code})"
        return Piece(f"{base}^{inner}", Precedence.POWER)

    def exponential(self, exponent: Piece) -> Piece:
        """exp of something."""
        return Piece(self.function("exp") + self.arguments([exponent.code]))

    def root(self, inner: Piece) -> Piece:
        """A square root."""
        return Piece(f"sqrt({inner.code})")

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value."""
        return Piece(f"abs({inner.code})")

    def dot(self, a: Piece, b: Piece) -> Piece:
        """A scalar product."""
        return Piece(f"dot({a.code}, {b.code})")

    def cross(self, a: Piece, b: Piece) -> Piece:
        """A vector product."""
        return Piece(f"cross({a.code}, {b.code})")

    def wedge(self, forms: Sequence[Piece]) -> Piece:
        """An exterior product."""
        return Piece("wedge" + self.arguments([f.code for f in forms]))

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative; `at`: the arguments at which it is taken, if they are ambiguous."""
        code = inner.code + (self.arguments(at) if at else "")
        for variable in variables:
            code = f"diff({code}, {self.name(variable).code})"
        return Piece(code)

    def slope(self, inner: Piece, order: int, at: Sequence[str] = ()) -> Piece:
        """A derivative of a function of one variable: f′, f″; `at` as in `partial`."""
        return Piece(inner.code + "′″‴"[order - 1] + (self.arguments(at) if at else ""))

    def rate(self, inner: Piece) -> Piece:
        """A total time derivative."""
        return Piece(f"diff({inner.code}, t)")

    def integral(self, body: Piece, start: Piece, end: Piece) -> Piece:
        """A definite integral; the body contains the differential."""
        return Piece("integral" + self.arguments([body.code, start.code, end.code]))

    def zero_vector(self) -> Piece:
        """The vector 0."""
        return Piece("0")


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
        parts = WrittenName.of(name)
        return Piece(unicode_name(parts), tight=parts.is_letter and not parts.operator and not vector)

    def number(self, number: sp.Number) -> Piece:
        """A positive integer or float."""
        if isinstance(number, sp.Float):
            digits, exponent = figures(number)
            power = "" if exponent is None else "·10" + str(exponent).translate(SUPERSCRIPTS)
            return Piece(digits + power, tight=True)
        return Piece(str(int(number)), tight=True)

    def unit(self, name: str) -> Piece:
        """A unit of measurement, with the space between it and the number before it: m/s²."""
        return Piece(re.sub(r"\^(-?\d+)", lambda power: power[1].translate(SUPERSCRIPTS), super().unit(name).code))

    def coefficient(self, numerator: Piece, denominator: Piece) -> Piece:
        """½, or (5/12)."""
        code = f"{numerator.code}/{denominator.code}"
        return Piece(_VULGAR[code]) if code in _VULGAR else Piece(f"({code})")

    def between(self, before: Piece, after: Piece) -> str:
        """A space, but 2x; 2 (a + b)² as 2 (a + b)."""
        usual = super().between(before, after)
        counts = (
            before.code.replace(".", "").isdigit() and after.tight and after.code.lstrip(START)[:1] not in tuple("([{")
        )
        return "" if counts and usual == self.times else usual

    def applied(self, function: str, argument: str, raised: bool) -> Piece:
        """`sin θ`, `sin²θ`."""
        return Piece(f"{function}{argument}" if raised else f"{function} {argument}", Precedence.APPLICATION)

    def bracketed(self, code: str) -> str:
        """Round brackets; around a sum that has some, square ones, then braces."""
        left, right = brackets(code)
        return f"{left}{code}{right}"

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power; the base has its brackets already."""
        if exponent.code.isdigit():
            return Piece(base + exponent.code.translate(SUPERSCRIPTS), Precedence.POWER, tight=True)
        inner = exponent.code if exponent.level >= Precedence.ATOM else f"({exponent.code})"
        return Piece(f"{base}^{plain(inner)}", Precedence.POWER, tight=True)

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A fraction on one line; a long one may be broken before the line."""
        piece = super().fraction(numerator, denominator)
        if BREAK not in numerator.code:
            return piece
        above = self.bracketed(numerator.code) if numerator.level <= Precedence.DIVISION else numerator.code
        return Piece(f"{START}{above}{BREAK}{piece.code.removeprefix(above)}{END}", Precedence.DIVISION)

    def exponential(self, exponent: Piece) -> Piece:
        """e^(μ β), or exp(...) of what is long."""
        code = plain(exponent.code)
        return self.power("e", exponent) if len(code) <= LONGEST_EXPONENT else super().exponential(exponent)

    def root(self, inner: Piece) -> Piece:
        """A square root."""
        code = inner.code if inner.level == Precedence.ATOM else f"({inner.code})"
        return Piece("√" + code, Precedence.POWER, tight=True)

    def absolute(self, inner: Piece) -> Piece:
        """An absolute value."""
        return Piece(f"|{inner.code}|")

    def dot(self, a: Piece, b: Piece) -> Piece:
        """A scalar product."""
        return Piece(f"{self._operand(a)}·{self._operand(b)}", Precedence.DIVISION)

    def cross(self, a: Piece, b: Piece) -> Piece:
        """A vector product."""
        return Piece(f"{self._operand(a)} × {self._operand(b)}", Precedence.DIVISION)

    def wedge(self, forms: Sequence[Piece]) -> Piece:
        """An exterior product."""
        return Piece(" ∧ ".join(self._operand(f) for f in forms), Precedence.PRODUCT)

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative."""
        above, below = self._differentials("∂", "", inner, variables)
        where = self.arguments(at) if at else ""
        return Piece(f"{above}/{below}{where}", Precedence.DIVISION)

    def rate(self, inner: Piece) -> Piece:
        """A total time derivative."""
        if inner.level == Precedence.ATOM and len(inner.code) < LONGEST_RATE and "(" not in inner.code:
            return Piece(f"d{inner.code}/dt", Precedence.DIVISION)
        return Piece(f"d/dt {self.bracketed(inner.code)}", Precedence.DIVISION)

    def integral(self, body: Piece, start: Piece, end: Piece) -> Piece:
        """A definite integral on one line: ∫_0^π dθ/√(1 + sin²θ)."""
        low, high = (p.code if p.level == Precedence.ATOM else f"({plain(p.code)})" for p in (start, end))
        return Piece(f"∫_{low}^{high} {body.code}", Precedence.DIVISION)

    def _operand(self, piece: Piece) -> str:
        return self.bracketed(piece.code) if piece.level <= Precedence.DIVISION else piece.code

    def _differentials(self, sign: str, gap: str, inner: Piece, variables: Sequence[str]) -> tuple[str, str]:
        """∂²f and ∂X∂Y; ∂X² if a variable occurs twice."""
        counts = {v: variables.count(v) for v in variables}
        raised = self.power(sign, Piece(str(len(variables)))).code if len(variables) > 1 else sign
        pieces = []
        for variable, n in counts.items():
            code = self.name(variable).code
            pieces.append(f"{sign}{gap}{self.power(code, Piece(str(n))).code if n > 1 else code}")
        body = inner.code if inner.level == Precedence.ATOM else self.bracketed(inner.code)
        return f"{raised}{gap}{body}", gap.join(pieces)


class BoldVectors(Unicode):
    """A page on the terminal: vectors have bold letters, `m 𝐫̈ = 𝐅 + 𝐑`."""

    def name(self, name: str, vector: bool = False) -> Piece:
        """A symbol."""
        if not vector:
            return super().name(name)
        return Piece(unicode_name(WrittenName.of(name), bold=True))
