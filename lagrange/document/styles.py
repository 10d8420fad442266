"""The tables behind the one walker of `mathematics`: how text, Unicode and LaTeX spell what it finds.

A style spells, and decides nothing about order or structure. This is the plainest one, and what the others
share.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import ClassVar

import sympy as sp

from lagrange.document.pieces import Level, Piece

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


class Text:
    """The language of problem files: `2*x*d(x)`, `l*theta'' + g*sin(theta)`."""

    column: ClassVar[int] = 0
    plus: ClassVar[str] = " + "
    minus: ClassVar[str] = " - "
    sign: ClassVar[str] = "-"
    times: ClassVar[str] = "*"
    between_numbers: ClassVar[str] = "*"
    constants: ClassVar[Mapping[str, str]] = {"Pi": "pi", "Exp1": "exp(1)", "Infinity": "oo"}
    by_hand: ClassVar[bool] = False  # fractions in front, sin θ without parentheses, nested brackets
    stacked: ClassVar[bool] = False  # fractions have their line, and are arguments without parentheses

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
        return Piece(f"{float(number):.6g}" if isinstance(number, sp.Float) else str(int(number)))

    def coefficient(self, numerator: Piece, denominator: Piece) -> Piece:
        """A number such as 1/2 in front of a product."""
        return self.fraction(numerator, denominator)

    def between(self, before: Piece, after: Piece) -> str:
        """What stands between two factors."""
        numbers = before.code[-1].isdigit() and after.code[0].isdigit()
        return self.between_numbers if numbers or before.code == "0" else self.times

    def applied(self, function: str, argument: str, raised: bool) -> Piece:
        """A function with a short argument, where it needs no parentheses."""
        del raised
        return Piece(f"{function} {argument}", Level.APPLICATION)

    def bracketed(self, code: str) -> str:
        """Brackets around a sum."""
        return f"({code})"

    def arguments(self, codes: Sequence[str]) -> str:
        """The argument list of a function."""
        return f"({', '.join(codes)})"

    def fraction(self, numerator: Piece, denominator: Piece) -> Piece:
        """A fraction on one line."""
        above = self.bracketed(numerator.code) if numerator.level <= Level.DIVISION else numerator.code
        below = self.bracketed(denominator.code) if denominator.level <= Level.PRODUCT else denominator.code
        return Piece(f"{above}/{below}", Level.DIVISION)

    def power(self, base: str, exponent: Piece) -> Piece:
        """A power of what needs no brackets."""
        inner = exponent.code if exponent.level >= Level.ATOM else f"({exponent.code})"
        return Piece(f"{base}^{inner}", Level.POWER)

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

    def wedge(self, forms: Sequence[Piece]) -> Piece:
        """An exterior product."""
        return Piece("wedge" + self.arguments([f.code for f in forms]))

    def partial(self, inner: Piece, variables: Sequence[str], at: Sequence[str] = ()) -> Piece:
        """A partial derivative; `at`: the arguments where it is taken, when that has to be said."""
        code = inner.code + (self.arguments(at) if at else "")
        for variable in variables:
            code = f"diff({code}, {self.name(variable).code})"
        return Piece(code)

    def rate(self, inner: Piece) -> Piece:
        """A total time derivative."""
        return Piece(f"diff({inner.code}, t)")

    def zero_vector(self) -> Piece:
        """The vector 0."""
        return Piece("0")
