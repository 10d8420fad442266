"""A list of tokens being read: where the reader is, how deep, and how it says what is wrong or surprising."""

from __future__ import annotations

from lagrange.core.diagnostics import Diagnostic, Fragment, Level, ProblemError
from lagrange.expressions.lexicon import Lexicon
from lagrange.expressions.tokens import Kind, Token
from lagrange.expressions.trees import Tree

MAX_NESTING = 60

_MISPLACED = {
    ",": "a decimal point is `.`; a comma separates arguments and components",
    "=": "an equation has one `=`, outside parentheses",
    "|": "write `abs(...)` where bars are nested",
}


class TokenStream:
    """One reading of one list of tokens, which ends with END. Surprising readings go to `notes`."""

    def __init__(self, fragment: Fragment, found: list[Token], lexicon: Lexicon) -> None:
        self.fragment = fragment
        self.tokens = found
        self.lexicon = lexicon
        self.notes: list[Diagnostic] = []
        self._at = 0
        self._depth = 0
        self._step(0)

    def _step(self, count: int = 1) -> None:
        """On to the next token."""
        self._at += count
        self._here = self.tokens[self._at]
        self._operator = self._here.text if self._here.kind is Kind.OPERATOR else ""

    @property
    def _ends(self) -> bool:
        return self._here.kind is Kind.END

    def _is(self, operator: str) -> bool:
        return self._operator == operator

    def _ahead(self, count: int) -> Token:
        return self.tokens[min(self._at + count, len(self.tokens) - 1)]

    @property
    def _last_end(self) -> int:
        return self.tokens[self._at - 1].end

    def _text(self, start: int, end: int) -> str:
        return " ".join(self.fragment.text[start:end].split())

    def _unexpected(self) -> ProblemError:
        token = self._here
        if token.kind is Kind.END:
            message = "the expression ends where something must follow"
            return self._mistake("ends-early", message, token, "complete it")
        if token.kind is Kind.PRIMES:
            message = "a prime stands behind nothing that it could differentiate"
            return self._mistake("misplaced-prime", message, token, "write `x'`")
        if token.hidden:
            return self._mistake(
                "ends-early", "something must follow here, before the braces end", token, "complete it"
            )
        if token.text in (")", "]"):
            help_ = "remove it, or open it before"
            return self._mistake("not-opened", f"this `{token.text}` closes nothing", token, help_)
        message = f"`{self._text(token.start, token.end)}` cannot stand here"
        return self._mistake("misplaced-operator", message, token, _MISPLACED.get(token.text, "remove it"))

    def _mistake(self, code: str, message: str, place: Token | Tree, help_: str) -> ProblemError:
        span = self.fragment.span(place.start, max(place.end, place.start + 1))
        return ProblemError(Diagnostic(code, message, span, help=help_))

    def _read_as(self, start: int, end: int, reading: str, help_: str) -> None:
        """Says how something was read."""
        written = self._text(start, end)
        self._note(start, end, f"`{written}` is read as `{reading}`", help_)

    def _note(self, start: int, end: int, message: str, help_: str) -> None:
        span = self.fragment.span(start, end)
        self.notes.append(Diagnostic("read-as", message, span, help=help_, level=Level.NOTE))

    def _enter(self, token: Token) -> None:
        self._depth += 1
        if self._depth > MAX_NESTING:
            message = f"this nests deeper than {MAX_NESTING}"
            raise self._mistake("nested-too-deep", message, token, "introduce abbreviations")
