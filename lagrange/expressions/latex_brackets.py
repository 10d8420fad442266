r"""Brackets in LaTeX: `\left( \right)`, `\bigl[ \bigr]`, `\{ \}`, `\lvert \rvert`, and groups of all kinds.

Square brackets and braces group, unless commas make a list of components. `\lvert x \rvert` is abs(x), and
`\lVert a \rVert` is norm(a); a bare `|` is left to the parser.
"""

from __future__ import annotations

import re

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.latex_commands import SIZES
from lagrange.expressions.latex_derivatives import LatexDerivatives
from lagrange.expressions.scope import Scope
from lagrange.expressions.tokens import Kind, Token

_CLOSES = {")": ")", "]": "]", "\\}": "}", "\\rbrace": "}", "\\rbrack": "]", "\\rvert": "|", "\\rVert": "‖", "|": "|",
    "\\vert": "|", "\\|": "‖", "\\rangle": ">", ".": "."}  # fmt: skip
_OPENS = {"(": ")", "[": "]", "\\{": "}", "\\lbrace": "}", "\\lbrack": "]", "\\lvert": "|", "\\lVert": "‖", "|": "|",
    "\\vert": "|", "\\|": "‖", ".": "."}  # fmt: skip
_DELIMITER = re.compile(r"\\[A-Za-z]+|\\[{}|]|[()\[\]|.]")
_ENDING = (")", "]", "\\}", "\\rbrace", "\\rbrack", "\\rvert", "\\rVert")


class LatexBrackets(LatexDerivatives):
    """Reads brackets and what stands in them."""

    def __init__(self, fragment: Fragment, scope: Scope) -> None:
        super().__init__(fragment, scope)
        self._norms = 0  # how many `\|` are open

    def everything(self, first: int, last: int) -> None:
        """Reads all that stands between two places; what has been read before is left as it was."""
        at, limit = self.at, self.limit
        self.at, self.limit = first, last
        self._items()
        if not self.ends():
            written = self._written_here()
            help_ = "remove it, or open it before"
            raise self.mistake("not-opened", f"this `{written}` closes nothing", self.at, self.at + len(written), help_)
        self.at, self.limit = at, limit

    def _items(self) -> None:
        while True:
            self.skip()
            if self.stops():
                return
            self.factor()

    def stops(self) -> bool:
        """Whether the group ends here, or a bracket closes."""
        if self.ends():
            return True
        command = self.command()
        if command in SIZES and command[-1] not in "lrt":
            found = _DELIMITER.match(self.text, self.at + 1 + len(command), self.limit)
            return found is not None and found[0] in _ENDING
        if command in SIZES:
            return command[-1] != "l" and command != "left"
        return self.text[self.at] in ")]" or "\\" + command in _ENDING or (command == "|" and self._norms > 0)

    def bracket(self, applied: bool = False) -> None:
        """A bracket with what stands in it. Square brackets and braces group, unless commas make a list."""
        start = self.at
        sized, delimiter = self._delimiter()
        closing = _OPENS.get(delimiter)
        if closing is None or closing == ".":
            raise self._bad_delimiter(delimiter, start)
        opened = self.at
        if closing in ("|", "‖"):
            self.put(Kind.NAME, "abs" if closing == "|" else "norm", start, opened)
        index = len(self.found)
        self.operator("[" if closing == "]" else "(", start, opened, hidden=False)
        self._norms += closing == "‖" and not sized
        self._items()
        self._norms -= closing == "‖" and not sized
        self._close(closing, start, opened)
        if closing == "]" and (applied or not self._has_comma(index)):
            first, last = self.found[index], self.found[-1]
            self.found[index] = Token(Kind.OPERATOR, "(", first.start, first.end)
            self.found[-1] = Token(Kind.OPERATOR, ")", last.start, last.end)

    def _has_comma(self, index: int) -> bool:
        """Whether a comma stands in the bracket that opens at a token, and in none within it."""
        level = 0
        for token in self.found[index:]:
            if token.kind is Kind.OPERATOR:
                level += (token.text in "([") - (token.text in ")]")
                if token.text == "," and level == 1:
                    return True
        return False

    def _delimiter(self) -> tuple[bool, str]:
        """Reads the size of a bracket, if one is given, and the bracket."""
        sized = self.command() in SIZES
        if sized:
            self.at += 1 + len(self.command())
            self._blanks()
        found = _DELIMITER.match(self.text, self.at, self.limit)
        if found is None:
            return sized, ""
        self.at = found.end()
        return sized, found[0]

    def _close(self, closing: str, start: int, opened: int) -> None:
        written = self.written(start, opened)
        place = self.at
        if self.ends():
            help_ = f"add `{closing if closing != '‖' else chr(92) + '|'}`"
            raise self.mistake("not-closed", f"this `{written}` is not closed", start, opened, help_)
        _, delimiter = self._delimiter()
        if _CLOSES.get(delimiter) != closing:
            if delimiter in ("", "."):
                raise self._bad_delimiter(delimiter, place)
            shown = self.written(place, self.at)
            message = f"`{written}` is closed by `{shown}`"
            raise self.mistake("not-closed", message, place, self.at, f"write `{closing}`")
        self.operator("]" if closing == "]" else ")", place, self.at)

    def _bad_delimiter(self, delimiter: str, start: int) -> ProblemError:
        written = self.written(start, max(self.at, start + 1))
        if delimiter == ".":
            message, help_ = f"`{written}` is no bracket here", r"brackets stand in pairs: `\left( ... \right)`"
        else:
            message = f"`{written}` needs a bracket behind it"
            help_ = r"write `\left( ... \right)`"
        return self.mistake("latex-argument", message, start, max(self.at, start + 1), help_)

    def _written_here(self) -> str:
        command = self.command()
        if command in ("right", *SIZES):
            found = re.compile(r"\\[A-Za-z]+\s?(?:\\?.)?").match(self.text, self.at, self.limit)
            return found[0] if found else command
        return "\\" + command if command else self.text[self.at]
