"""Plain text -> tokens: numbers, names, primes, operators, with Unicode characters read as they look.

`θ̈₁` is the name theta_1 with two primes, `x²` is x ^ 2, `−·×√′″` are - * * sqrt ' ''. A run of Latin letters, digits
and underscores is one name and is never split; a Greek letter, or a letter with dots, begins a name of its own, so
that `ωt` and `mẍ` are products. `latex_lexer` makes the same tokens for the same parser.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace
from enum import Enum, auto

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity
from lagrange.core.records import record
from lagrange.expressions.characters import (
    DOT,
    FRACTIONS,
    GREEK,
    PRIMES,
    SUBSCRIPTS,
    SUPERSCRIPTS,
    normalized,
    suggestion_for_character,
)
from lagrange.expressions.limits import MAX_DIGITS, MAX_POWER_OF_TEN


class TokenKind(Enum):
    """The kinds of tokens."""

    NUMBER = auto()  # digits with a decimal point or a power of ten, or a fraction of two digits
    NAME = auto()
    PRIMES = auto()  # `count` of them
    OPERATOR = auto()  # + - * / ^ = ( ) [ ] , | and in LaTeX ⋅ ⨯, which multiply vectors too
    END = auto()


@record
class Token:
    """A token and its place in the fragment.

    loose   a name with several spellings, written with a subscript or as a variant (θ₁, ϑ): it means theta_1 or
            theta1, vartheta or theta, whichever is declared
    tight   a function that takes one factor only (√)
    hidden  a parenthesis that is not written as one: the braces of LaTeX
    """

    kind: TokenKind
    text: str
    start: int
    end: int
    count: int = 0
    loose: bool = False
    tight: bool = False
    hidden: bool = False


def _any_of(characters: Iterable[str]) -> str:
    return f"[{re.escape(''.join(characters))}]"


# A letter with dots is a name by itself, so a run of plain letters stops in front of one: `mẍ` is m ẍ.
_RUN = rf"(?:[A-Za-z_](?!{DOT})|[0-9])*"
_NAME = (
    rf"(?:[A-Za-z](?!{DOT}){_RUN}|(?:[A-Za-z]{DOT}+|{_any_of(GREEK)}{DOT}*)(?:(?=[_0-9]){_RUN})?){DOT}*"
    rf"(?:{_any_of(SUBSCRIPTS)}{DOT}*)*"
)
_TOKEN = re.compile(
    rf"(?P<space>\ +)|(?P<name>{_NAME})|(?P<number>[0-9]+\.?[0-9]*|\.[0-9]+)|(?P<primes>{_any_of(PRIMES)}+)"
    rf"|(?P<superscript>{_any_of(SUPERSCRIPTS)}+)|(?P<fraction>{_any_of(FRACTIONS)})|(?P<root>√)|(?P<degree>°)"
    r"|(?P<inequality><=|>=|!=|[<>≤≥≠≪≫⩽⩾])|(?P<double>\*\*|==)|(?P<operator>[-+*/^=()\[\],|])"
)
_INDEX = re.compile(r"_[0-9]{1,3}(?![A-Za-z0-9_])")
_POWER_OF_TEN = re.compile(r"[eE]([-+]?)([0-9]+)")


def tokens(fragment: Fragment, scientific: bool = True) -> tuple[list[Token], list[Diagnostic]]:
    """The tokens of a text, the last of kind END, and notes about surprising readings.

    scientific  whether `2e3` is the number 2000; false where `e` is declared

    Raises ProblemError at a character that has no meaning here.
    """
    lexer = _Lexer(fragment, scientific)
    return lexer.run(), lexer.notes


class _Lexer:
    def __init__(self, fragment: Fragment, scientific: bool) -> None:
        self.fragment = fragment
        self.scientific = scientific
        self.normalized = normalized(fragment)
        self.text = self.normalized.text
        self.at = 0
        self.tokens: list[Token] = []
        self.notes: list[Diagnostic] = []

    def run(self) -> list[Token]:
        while self.at < len(self.text):
            match = _TOKEN.match(self.text, self.at)
            if match is None:
                raise self._unexpected()
            start, self.at = self.at, match.end()
            self._read(match.lastgroup or "", match[0], start)
        end = self.tokens[-1].end if self.tokens else 0
        return [*self.tokens, Token(TokenKind.END, "", end, end)]

    def _read(self, kind: str, text: str, start: int) -> None:
        match kind:
            case "name":
                self._name(text, start)
            case "operator":
                self._add(TokenKind.OPERATOR, text, start)
            case "number":
                self._number(text, start)
            case "primes":
                self._primes(text, start)
            case "superscript":
                self._superscript(text, start)
            case "fraction":
                self._add(TokenKind.NUMBER, FRACTIONS[text], start)
            case "root":
                self._add(TokenKind.NAME, "sqrt", start, tight=True)
            case "degree":
                self._add(TokenKind.NAME, text, start)
            case "double":
                self._double(text, start)
            case "inequality":
                raise self._inequality(text, start)

    def _name(self, text: str, start: int) -> None:
        dots = text.count(DOT)
        plain = text.replace(DOT, "")
        stem = plain.rstrip("".join(SUBSCRIPTS))
        name = GREEK.get(stem[0], stem[0]) + stem[1:]
        if stem != plain:
            name = f"{name}_{''.join(SUBSCRIPTS[c] for c in plain[len(stem) :])}"
        self._add(TokenKind.NAME, name, start, loose=stem != plain or plain[0] in "ϑϱςℓ")
        if dots:
            self._add(TokenKind.PRIMES, "'" * dots, start, count=dots)

    def _primes(self, text: str, start: int) -> None:
        """Primes; followed by an index, x'_0, they and the letter are the name of a velocity at one instant."""
        count = sum(PRIMES[c] for c in text)
        before = self.tokens[-1] if self.tokens else None
        index = _INDEX.match(self.text, self.at)
        if index is None or before is None or before.kind is not TokenKind.NAME or self.text[start - 1] == " ":
            self._add(TokenKind.PRIMES, "'" * count, start, count=count)
            return
        self.at = index.end()
        _, last = self.normalized.written(start, self.at)
        self.tokens[-1] = replace(before, text=f"{before.text}{chr(39) * count}{index[0]}", end=last)

    def _number(self, text: str, start: int) -> None:
        integer, _, decimals = text.partition(".")
        exponent, places = "", 0
        if self.scientific and (power := _POWER_OF_TEN.match(self.text, self.at)):
            self.at = power.end()
            exponent = f"e{power[1].strip('+')}{power[2]}"
            places = int(power[2]) if len(power[2]) <= 4 else MAX_POWER_OF_TEN + 1
        if self.text.startswith(".", self.at):
            help_ = "a component of a vector is `dot(a, i)`; decimal points occur in numbers only"
            raise self._error("bad-number", "a number has one decimal point", self.at, self.at + 1, help_)
        if len(integer) + len(decimals) > MAX_DIGITS or places > MAX_POWER_OF_TEN:
            raise self._too_long(start)
        self._add(TokenKind.NUMBER, f"{integer or '0'}{'.' + decimals if decimals else ''}{exponent}", start)

    def _superscript(self, text: str, start: int) -> None:
        digits = "".join(SUPERSCRIPTS[c] for c in text)
        number = digits.removeprefix("-")
        if not number.isdigit():
            message = "this exponent cannot be read"
            raise self._error("bad-exponent", message, start, self.at, "write it as `^2`")
        if len(number) > MAX_DIGITS:
            raise self._too_long(start)
        self._add(TokenKind.OPERATOR, "^", start)
        if number != digits:
            self._add(TokenKind.OPERATOR, "-", start)
        self._add(TokenKind.NUMBER, number, start)

    def _double(self, text: str, start: int) -> None:
        self._add(TokenKind.OPERATOR, "^" if text == "**" else "=", start)
        if text == "==":
            span = self.fragment.span(self.tokens[-1].start, self.tokens[-1].end)
            self.notes.append(Diagnostic("read-as", "`==` is read as `=`", span, level=Severity.NOTE))

    def _add(
        self, kind: TokenKind, text: str, start: int, count: int = 0, loose: bool = False, tight: bool = False
    ) -> None:
        """Add a token from `start` to here."""
        first, last = self.normalized.written(start, self.at)
        self.tokens.append(Token(kind, text, first, last, count, loose, tight))

    # -- errors ----------------------------------------------------------------------------------------------

    def _unexpected(self) -> ProblemError:
        char = self.text[self.at]
        before = self.tokens[-1] if self.tokens else None
        command = re.compile(r"[A-Za-z]{1,20}").match(self.text, self.at + 1)
        help_ = suggestion_for_character(char)
        if char == "." and before and before.kind in (TokenKind.NAME, TokenKind.PRIMES):
            help_ = "a component of a vector is `dot(r, i)`; a product is written `*`"
        elif char == "\\" and command:
            help_ = f"LaTeX is read in answers only: write `{command[0]}` without a backslash"
        elif char == DOT:
            help_ = "dots are placed over letters: `ẋ`"
        return self._error("unexpected-character", f"`{char}` has no meaning here", self.at, self.at + 1, help_)

    def _inequality(self, sign: str, start: int) -> ProblemError:
        help_ = "write an equation with `=`"
        if sign[0] in "<>≤≥⩽⩾":
            help_ += "; one-sided constraints are written with `<=` or `>=` under `constraints`"
        return self._error("inequality", f"`{sign}` is not an equation", start, self.at, help_)

    def _too_long(self, start: int) -> ProblemError:
        message, help_ = (
            f"a number may have at most {MAX_DIGITS} digits, and a power of ten up to {MAX_POWER_OF_TEN}",
            "round it, or declare a parameter instead",
        )
        return self._error("number-too-long", message, start, self.at, help_)

    def _error(self, code: str, message: str, start: int, end: int, help_: str) -> ProblemError:
        span = self.fragment.span(*self.normalized.written(start, end))
        return ProblemError(Diagnostic(code, message, span, help=help_))
