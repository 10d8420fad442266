r"""Fractions in LaTeX, and the derivatives and differentials that are written with them.

`\frac{d}{dt}` is applied to the brackets behind it, or else to everything up to the next sign; carried out, as
`diff(e, t)` is. `\frac{\partial f}{\partial x}` is `diff(f, x)`, `\mathrm{d}x` is `d(x)`.
"""

from __future__ import annotations

import re

from lagrange.expressions.latex_commands import ACCENTS, VECTORS, WORDS
from lagrange.expressions.latex_functions import LatexFunctions
from lagrange.expressions.lexicon import Role
from lagrange.expressions.tokens import Kind

_D = r"(?:d|\\mathrm\s*\{\s*d\s*\}|\\mathrm\s+d|\\text\s*\{d\}|\{\s*\\rm\s+d\s*\}|\\rm\s+d|\\dd(?![A-Za-z]))"
_ORDER = r"(?:\s*\^\s*(?:(?P<one>[1-9])|\{\s*(?P<braced>[1-9])\s*\}))?"
_RISE = re.compile(rf"\s*{_D}{_ORDER}\s*")
_BY_TIME = re.compile(rf"\s*(?:{_D}\s*t|\\mathrm\s*\{{\s*dt\s*\}}){_ORDER}\s*")
_PARTIAL = re.compile(rf"\s*\\partial(?![A-Za-z]){_ORDER}\s*")
_BY_PARTIAL = re.compile(r"\\partial(?![A-Za-z])")
_ORDER_BEHIND = re.compile(rf"{_ORDER}\s*\Z")


class LatexDerivatives(LatexFunctions):
    """Reads fractions, derivatives and differentials."""

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
