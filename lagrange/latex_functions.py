r"""Functions, roots, fractions and derivatives in LaTeX.

`\frac{d}{dt}` is applied to the brackets behind it, or else to everything up to the next sign; carried out, as
`diff(e, t)` is. `\frac{\partial f}{\partial x}` is `diff(f, x)`. Without brackets, a function is applied to what
stands next to it: numbers and constants as far as they touch, and one coordinate or t.
"""

from __future__ import annotations

import re
from abc import abstractmethod

from lagrange.latex_atoms import LatexAtoms
from lagrange.latex_commands import ACCENTS, FRACTIONS, FUNCTIONS, NAMED_FUNCTIONS, SIZES, VECTORS, WORDS
from lagrange.lexicon import Role
from lagrange.tokens import Kind

_D = r"(?:d|\\mathrm\s*\{\s*d\s*\}|\\mathrm\s+d|\\text\s*\{d\}|\{\s*\\rm\s+d\s*\}|\\rm\s+d|\\dd(?![A-Za-z]))"
_ORDER = r"(?:\s*\^\s*(?:(?P<one>[1-9])|\{\s*(?P<braced>[1-9])\s*\}))?"
_RISE = re.compile(rf"\s*{_D}{_ORDER}\s*")
_BY_TIME = re.compile(rf"\s*(?:{_D}\s*t|\\mathrm\s*\{{\s*dt\s*\}}){_ORDER}\s*")
_PARTIAL = re.compile(rf"\s*\\partial(?![A-Za-z]){_ORDER}\s*")
_BY_PARTIAL = re.compile(r"\\partial(?![A-Za-z])")
_OF_TIME = re.compile(r"\s*(?:\(\s*t\s*\)|\\left\s*\(\s*t\s*\\right\s*\))")
_ORDER_BEHIND = re.compile(rf"{_ORDER}\s*\Z")


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

    # -- roots and fractions ---------------------------------------------------------------------------------

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

    def fraction(self, start: int) -> None:
        r"""`\frac{a}{b}`, `\frac gl`, and the derivatives that are written so; read up to here."""
        above, below = self.argument(start), self.argument(start)
        if self._total(start, above, below) or self._partial(start, above, below):
            return
        before = self.found[-1] if self.found else None
        begun = len(self.found)
        self.open(start, start + 1)
        self.grouped(*above)
        self.operator("/", *above, hidden=True)
        self.grouped(*below)
        self.close(self.at - 1, self.at)
        mixed = before is not None and before.kind is Kind.NUMBER and len(self.found) - begun == 6
        if before is not None and mixed and self.found[-2].kind is self.found[-4].kind is Kind.NUMBER:
            written = self.written(start, self.at)
            message = f"`{before.text}` in front of `{written}` multiplies it"
            self.note(message, start, self.at, "write `+` between them for a mixed number")
        self.tail()

    # -- derivatives -----------------------------------------------------------------------------------------

    def _total(self, start: int, above: tuple[int, int], below: tuple[int, int]) -> bool:
        """Reads d/dt, if it is that."""
        rise = _RISE.match(self.text, *above)
        by = _BY_TIME.fullmatch(self.text, *below)
        if rise is None or by is None:
            return False
        order = int(rise["one"] or rise["braced"] or 1)
        if order != int(by["one"] or by["braced"] or 1):
            if self.names.is_declared("d"):
                return False
            message = "the orders above and below are not the same"
            help_ = r"write `\frac{d^2 x}{dt^2}`"
            raise self.mistake("bad-derivative", message, start, self.at, help_)
        for _ in range(order):
            self.put(Kind.NAME, "diff", start, self.at)
            self.operator("(", start, start + 1, hidden=True)
        if rise.end() < above[1]:
            self.everything(rise.end(), above[1])
        else:
            self._operand(start)
        for _ in range(order):
            self.operator(",", *below, hidden=True)
            self.put(Kind.NAME, "t", *below)
            self.close(*below)
        self.moving += 1
        self.tail()
        return True

    def _operand(self, start: int) -> None:
        """What an operator of differentiation is applied to."""
        end = self.at
        self.skip()
        if self.at_bracket():
            self.bracket(applied=True)
            if self.tail().exponent is not None:
                self._said(start, f"{self.written(start, end)} of the power", "put brackets around what is meant")
            return
        factors = 0
        while not (self.ends() or self.stops()):
            operator = self.at_operator()
            if operator and (operator not in "*/⋅⨯" or not factors):
                break
            factors += not operator
            self.factor()
            self.skip()
        if not factors:
            written = self.written(start, end)
            message = f"`{written}` has nothing to differentiate"
            raise self.mistake("no-argument", message, start, end, f"write `{written}(...)`")
        if factors > 1:
            written = " ".join(self.written(end, self.at).split())
            message = f"`{self.written(start, end)}` differentiates all of `{written}`"
            self.note(message, start, self.at, "put brackets around what it differentiates")

    def _partial(self, start: int, above: tuple[int, int], below: tuple[int, int]) -> bool:
        """Reads a partial derivative, if it is one."""
        rise = _PARTIAL.match(self.text, *above)
        places = [found.span() for found in _BY_PARTIAL.finditer(self.text, *below)]
        if rise is None or not places or self.text[below[0] : places[0][0]].strip():
            return False
        if "/" in self.text[slice(*below)] or _BY_PARTIAL.search(self.text, rise.end(), above[1]):
            return False  # a fraction of derivatives
        variables: list[tuple[int, int]] = []
        for n, (_, first) in enumerate(places):
            last = places[n + 1][0] if n + 1 < len(places) else below[1]
            order = _ORDER_BEHIND.search(self.text, max(first, last - 12), last)
            count = int((order and (order["one"] or order["braced"])) or 1)
            variables += [(first, order.start() if order else last)] * count
        if len(variables) != int(rise["one"] or rise["braced"] or 1):
            message, help_ = "the orders above and below are not the same", r"write `\frac{\partial^2 f}{\partial x^2}`"
            raise self.mistake("bad-derivative", message, start, self.at, help_)
        for _ in variables:
            self.put(Kind.NAME, "diff", start, self.at)
            self.operator("(", start, start + 1, hidden=True)
        if rise.end() < above[1]:
            self.everything(rise.end(), above[1])
            self._at_arguments()
        else:
            self._operand(start)
        for variable in variables:
            self.operator(",", *variable, hidden=True)
            self.everything(*variable)
            self.close(*variable)
        self.tail()
        return True

    def _at_arguments(self) -> None:
        """∂f/∂X (x, y) is that derivative, taken there."""
        last = self.found[-1]
        if last.kind is Kind.NAME and self.scope.role(last.text) is Role.FUNCTION:
            self.skip()
            if self.at_bracket():
                self.bracket(applied=True)

    def slope(self, start: int) -> None:
        r"""`\partial f / \partial x` on one line; `\partial` has been read."""
        index = len(self.found)
        self.put(Kind.NAME, "diff", start, self.at)
        self.operator("(", start, start + 1, hidden=True)
        self.skip()
        if not self.stops() and not self.at_operator():
            self.factor()
        self.skip()
        self._at_arguments()
        self.skip()
        if self.looking_at("/"):
            slash = self.at
            self.at += 1
            self.skip()
            if self.command() == "partial" and len(self.found) > index + 2:
                self.at += len("\\partial")
                self.skip()
                self.operator(",", slash, slash + 1, hidden=True)
                if not self.stops() and not self.at_operator():
                    self.factor()
                    self.close(self.at - 1, self.at)
                    return
        message, help_ = r"`\partial` stands in derivatives only", r"write `\frac{\partial f}{\partial x}`"
        raise self.mistake("bad-derivative", message, start, start + 8, help_)

    def differential(self, operator: str, start: int) -> None:
        """d(x) or delta(x), the operator having been read; what follows is a name."""
        end = self.at
        self.skip()
        command = self.command()
        begins = not self.ends() and (
            self.text[self.at].isalpha() or command in ACCENTS or command in (*VECTORS, *WORDS)
        )
        if not (begins or command or self.at_bracket()):
            help_ = f"write `{self.written(start, end)} x`"
            message = f"`{self.written(start, end)}` stands before nothing that could change"
            raise self.mistake("not-a-differential", message, start, end, help_)
        self.put(Kind.NAME, operator, start, end)
        if self.at_bracket():
            self.bracket(applied=True)
            return
        self.operator("(", end - 1, end, hidden=True)
        self.factor()
        self.close(self.at - 1, self.at)
