r"""Functions and roots in LaTeX.

Without brackets, a function is applied to what stands next to it: numbers and constants as far as they touch, and one
coordinate or t. `\sin\omega t` is sin(omega t), `\sin\theta\dot\phi` is sin(theta) phi'.
"""

from __future__ import annotations

import re
from abc import abstractmethod

from lagrange.expressions.latex_atoms import LatexAtoms
from lagrange.expressions.latex_commands import ACCENTS, FRACTIONS, FUNCTIONS, NAMED_FUNCTIONS, SIZES, VECTORS
from lagrange.expressions.lexicon import Role
from lagrange.expressions.tokens import Kind

_OF_TIME = re.compile(r"\s*(?:\(\s*t\s*\)|\\left\s*\(\s*t\s*\\right\s*\))")


class LatexFunctions(LatexAtoms):
    """Reads what is applied to something."""

    @abstractmethod
    def factor(self) -> None:
        """Reads one factor."""

    @abstractmethod
    def bracket(self, applied: bool = False) -> None:
        """Reads a bracket and what stands in it."""

    @abstractmethod
    def stops(self) -> bool:
        """Whether no factor stands here."""

    @abstractmethod
    def at_operator(self) -> str:
        """The operator that stands here, if one does."""

    def at_bracket(self) -> bool:
        """Whether a bracket opens here."""
        command = self.command()
        return (
            self.looking_at("(")
            or self.looking_at("[")
            or command in ("{", "lbrace", "lvert", "lVert", "|")
            or (command in SIZES and not command.endswith("r") and command != "right")
        )

    # -- functions -------------------------------------------------------------------------------------------

    def function(self, name: str, start: int) -> None:
        """A function whose name has been read, and what it is applied to."""
        named = self.at
        self.put(Kind.NAME, name, start, named)
        scripts = self.scripts(named)
        if scripts.subscript is not None:
            message, help_ = f"`{name}` has no subscript", r"the logarithm is `\ln`"
            raise self.mistake("bad-subscript", message, *scripts.subscript, help_)
        if scripts.exponent is not None:
            self._check_exponent(name, *scripts.exponent)
        self.hang(scripts)
        self.at = max(self.at, named)
        self.skip()
        if self.at_bracket():
            self.bracket(applied=True)
            self.tail()
        elif self.looking_at("{") and not self._is_number(self.at):
            end = self.group_end(self.at)
            self.grouped(self.at + 1, end, applied=True, always=True)
            self.at = end + 1
            if self.tail().exponent is not None:
                self._said(start, f"({self.written(start, end + 1)})^", "put the exponent next to the function")
        elif not self.stops() and self.at_operator() != "|":
            self._argument(name, start)

    def _check_exponent(self, name: str, first: int, last: int) -> None:
        inside = self.text[first:last].strip()
        if inside.isdigit():
            return
        help_ = rf"write `(\{name} x)^n`"
        if inside in ("-1", "⁻¹") and f"a{name}" in NAMED_FUNCTIONS:
            help_ = rf"the inverse function is `\arc{name}`, the reciprocal `1/\{name} x`"
        message = f"an exponent behind `{name}` must be a whole number"
        raise self.mistake("function-exponent", message, first, last, help_)

    def _is_number(self, at: int) -> bool:
        return self.text[at + 1 : self.group_end(at)].strip().isdigit()

    def _argument(self, name: str, start: int) -> None:
        """What a function without brackets is applied to."""
        begins, moving, index = self.at, self.moving, len(self.found)
        self.open(begins, begins, applied=True)
        symbols, cut_short = 0, False
        while True:
            gap = self.skip()
            if self.stops() or self.at_operator():
                break
            kind = self._next()
            number = kind == "number"
            ends = bool(symbols) or (kind == "function" and len(self.found) > index + 1)
            if symbols and self.moving == moving and kind == "name":
                ends = gap and not self.looking_at("t")
            if ends:
                cut_short = kind in ("name", "bracket") and not gap
                break
            before, first = len(self.found), self.at
            if kind == "bracket":
                self.bracket()
                self.tail()
            else:
                self.factor()
                if self.moving > moving and kind == "name" and _OF_TIME.match(self.text, self.at, self.limit):
                    self.bracket(applied=True)
            end = self.at
            symbols += not number
            last = (before, first, end)
        if len(self.found) == index + 1:
            del self.found[index:]
            return
        self.close(last[2], last[2])
        self._surprises(name, start, begins, last, symbols, cut_short)

    def _next(self) -> str:
        """What stands here, so far as it matters for where an argument ends."""
        char, command = self.text[self.at], self.command()
        if char.isdigit() or char == ".":
            return "number"
        if self.at_bracket():
            return "bracket"
        if command in FRACTIONS:
            return "number" if self._is_numeric_fraction() else "apart"
        if char.isascii() and char.isalpha():
            _, name, _ = self.piece_here()
            role = self.scope.role(name)
            if role is Role.UNDECLARED and name in NAMED_FUNCTIONS:
                return "function"
            return "apart" if role in (Role.VECTOR, Role.FUNCTION) else "name"
        if command in FUNCTIONS or command in ("operatorname", "partial", "delta") or command in ACCENTS:
            return "apart"
        return "apart" if command in VECTORS or command == "sqrt" else "name"

    def _is_numeric_fraction(self) -> bool:
        found = re.compile(r"\\[tdc]?frac(?:\s*[0-9]|\s*\{[0-9]{1,9}\}){2}").match(self.text, self.at, self.limit)
        return found is not None

    def _surprises(
        self, name: str, start: int, begins: int, last: tuple[int, int, int], symbols: int, cut_short: bool
    ) -> None:
        """Says what the argument is, where another reader might end it elsewhere."""
        index, first, end = last
        factor = self.found[index:-1]
        help_ = "put brackets around what belongs to it"
        scripts = any(t.kind is Kind.PRIMES for t in factor) or any(t.text == "^" for t in factor)
        time = self.written(first, end).strip() == "t"
        if scripts or (symbols > 1 and not time):
            reading = f"{self.written(start, begins).strip()}({self.written(begins, end).strip()})"
            self._said(start, reading, help_, end)
        elif cut_short or self.looking_at("/"):
            message = f"the argument of `{name}` ends before the `{self.written(self.at, self.at + 1)}`"
            self.note(message, start, self.at + 1, help_)

    def _said(self, start: int, reading: str, help_: str, end: int = 0) -> None:
        written = " ".join(self.written(start, end or self.at).split())
        self.note(f"`{written}` is read as `{' '.join(reading.split())}`", start, end or self.at, help_)

    # -- roots ---------------------------------------------------------------------------------------------

    def root(self, start: int) -> None:
        r"""`\sqrt{x}`, `\sqrt[3]{x}`, read up to here."""
        self.skip()
        if not self.looking_at("["):
            self.put(Kind.NAME, "sqrt", start, self.at)
            self.grouped(*self.argument(start), applied=True, always=True)
            self.tail()
            return
        end = self.text.find("]", self.at, min(self.at + 40, self.limit))
        index = self.text[self.at + 1 : end].strip() if end > 0 else ""
        if not (index.isascii() and index.isdigit()) or len(index) > 2 or int(index) == 0:
            message = "a root has a whole number as its index"
            raise self.mistake("bad-root", message, start, self.at + 1, r"write `\sqrt[3]{x}`")
        place = self.at + 1, end
        self.at = end + 1
        self.open(start, start + 5)
        self.grouped(*self.argument(start))
        self.operator("^", *place, hidden=True)
        self.open(*place, applied=True)
        self.put(Kind.NUMBER, "1", *place)
        self.operator("/", *place, hidden=True)
        self.put(Kind.NUMBER, index, *place)
        self.close(*place)
        self.close(self.at - 1, self.at)
        self.tail()
