r"""LaTeX -> the tokens of the expression language, for the same parser: `\ddot{\theta}_1` is theta_1 ''.

    \frac{a}{b}             ( a / b )                   \sin^2\theta           sin ^ 2 ( theta )
    \dot x^2                x ' ^ 2                     \sqrt[3]{x}            ( x ^ ( 1 / 3 ) )
    \frac{d}{dt}(...)       diff ( ( ... ) , t )        \mathrm{e}^{-ct}       exp ( - c t )

Braces become parentheses that are not written (`hidden`); every token knows its place in the LaTeX, and no text is
rewritten. Commands have the meanings of `latex_commands`, and nothing is expanded. The time is
proportional to the length.
"""

from __future__ import annotations

import re
from dataclasses import replace

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.expressions.characters import FRACTIONS as FRACTION_SIGNS
from lagrange.expressions.characters import GREEK, PRIMES, cure
from lagrange.expressions.latex_brackets import LatexBrackets
from lagrange.expressions.latex_commands import (
    ACCENTS,
    FRACTIONS,
    FRAMES,
    FUNCTIONS,
    LETTERS,
    NAMED_FUNCTIONS,
    OPERATORS,
    VECTORS,
    WORDS,
    help_for_command,
    is_inequality,
)  # fmt: skip
from lagrange.expressions.scope import Scope
from lagrange.expressions.stream import MAX_NESTING
from lagrange.expressions.tokens import Kind, Token

_SIGNS = "+-*/=,|"
_WORD = re.compile(r"[A-Za-z0-9_ ]*")


def latex_tokens(fragment: Fragment, scope: Scope) -> tuple[list[Token], list[Diagnostic]]:
    """The tokens of a text in LaTeX, the last of kind END, and notes about surprising readings.

    Raises ProblemError at what has no meaning here.
    """
    lexer = LatexLexer(fragment, scope)
    return lexer.run(), lexer.notes


class LatexLexer(LatexBrackets):
    """One reading of one text in LaTeX."""

    def run(self) -> list[Token]:
        """All tokens."""
        self.everything(0, len(self.text))
        end = self.found[-1].end if self.found else 0
        return [*self.found, Token(Kind.END, "", end, end)]

    def at_operator(self) -> str:
        """The operator that stands here, as plain text; empty where there is none."""
        if self.ends():
            return ""
        char, command = self.text[self.at], self.command()
        if command in OPERATORS:
            return OPERATORS[command]
        if command == "vert":
            return "|"
        return char if char in _SIGNS or char in "<>≤≥≠:;!?#@\"^_'" else ""

    def factor(self) -> None:
        """One factor, or one operator."""
        self.depth += 1
        if self.depth > MAX_NESTING + 1:
            message = f"this nests deeper than {MAX_NESTING}"
            raise self.mistake("nested-too-deep", message, self.at, self.at + 1, "introduce abbreviations")
        self._factor()
        self.depth -= 1

    def _factor(self) -> None:
        self.steps += 1
        start, char = self.at, self.text[self.at]
        if self.at_operator():
            self._operator(start, char)
        elif (char.isdigit() and char.isascii()) or (char == "." and self.text[start + 1 : start + 2].isdigit()):
            self.number()
        elif char.isascii() and char.isalpha():
            self._word_or_letters(start)
        elif char in GREEK:
            self.at += 1
            self.greek(GREEK[char], start)
        elif char == "{":
            self._braces_here(start)
        elif char in "([":
            self.bracket()
            self.tail()
        elif char in FRACTION_SIGNS:
            self.at += 1
            self.put(Kind.NUMBER, FRACTION_SIGNS[char], start, self.at)
            self.tail()
        elif char == "√":
            self.at += 1
            self.found.append(Token(Kind.NAME, "sqrt", *self.place(start, start + 1), tight=True))
        elif char == "\\":
            self._command(start, self.command())
        else:
            raise self.mistake("unexpected-character", f"`{char}` has no meaning here", start, start + 1, cure(char))

    def _word_or_letters(self, start: int) -> None:
        """Letters; a function may be written without its backslash."""
        end, name, _ = self.piece_here()
        if name in NAMED_FUNCTIONS and not self.names.is_declared(name):
            self.at = end
            self.function(NAMED_FUNCTIONS[name], start)
        else:
            self.letters()

    def _braces_here(self, start: int) -> None:
        """Braces group; an empty pair is nothing."""
        end = self.group_end(start)
        self.at = end + 1
        if self.text[start + 1 : end].strip():
            self.grouped(start + 1, end)
            self.tail()

    def _operator(self, start: int, char: str) -> None:
        command = self.command()
        self.at += 1 + len(command) if command else 1
        if command == "vert":
            self.operator("|", start, self.at)
        elif command == "prime" or char in PRIMES:
            self.at = start if char in PRIMES else self.at
            self.primes_here()
        elif command:
            self.operator(OPERATORS[command], start, self.at)
        elif char in _SIGNS:
            if char == "=" and self.looking_at("="):
                self.at += 1
                self.note("`==` is read as `=`", start, self.at, "")
            self.operator(char, start, self.at)
        elif char == "^":
            self.at -= 1
            self.operator("^", start, self.at)
            self.at += 1
        elif char in "<>≤≥≠":
            raise self._inequality(char, start)
        elif char == "_":
            message, help_ = "this subscript hangs on no name", r"an index belongs to a letter: `\theta_{1}`"
            raise self.mistake("bad-subscript", message, start, self.at, help_)
        else:
            raise self.mistake("unexpected-character", f"`{char}` has no meaning here", start, self.at, cure(char))

    def _inequality(self, written: str, start: int) -> ProblemError:
        return self.mistake(
            "inequality", f"`{written}` is not an equation", start, self.at, "write an equation with `=`"
        )

    # -- commands --------------------------------------------------------------------------------------------

    def _command(self, start: int, name: str) -> None:
        if self.at_bracket():
            self.bracket()
            self.tail()
            return
        self.at += 1 + len(name)
        if name == "delta" and not self.names.is_declared("delta") and self._varies():
            self.differential("delta", start)
        elif name in LETTERS:
            self.greek(LETTERS[name], start)
        elif name in FUNCTIONS:
            self.function(FUNCTIONS[name], start)
        elif name in ACCENTS:
            self._accent(ACCENTS[name], start)
        elif name in FRACTIONS:
            self.fraction(start)
        elif name == "sqrt":
            self.root(start)
        elif name in WORDS:
            self._word(start)
        elif name in VECTORS:
            self._vector_name(start, name)
        elif name.rstrip("*") == "operatorname":
            self._word(start)
        elif name == "partial":
            self.slope(start)
        elif name in FRAMES:
            self.everything(*self.argument(start))
        elif name in ("abs", "norm"):
            self.put(Kind.NAME, name, start, self.at)
            self.grouped(*self.argument(start), applied=True, always=True)
            self.tail()
        elif is_inequality(name):
            raise self._inequality("\\" + name, start)
        else:
            raise self._unknown(start, name)

    def _unknown(self, start: int, name: str) -> ProblemError:
        if name in ("begin", "end"):
            message, help_ = f"`\\{name}` does not stand in an equation", "an environment has whole equations in it"
        else:
            message, help_ = f"`\\{name[:40]}` is not a command that is known here", help_for_command(name)
        return self.mistake("unknown-command", message, start, self.at, help_)

    def _varies(self) -> bool:
        r"""Whether what follows `\delta` is what a virtual displacement belongs to, and no subscript."""
        at = self.at
        self.skip()
        found = not self.stops() and not self.at_operator()
        self.at = at
        return found

    def _accent(self, order: int, start: int) -> None:
        r"""`\ddot{\theta}_1`, `\dot x`, and the derivative of something in braces."""
        self.skip()
        first, last = self.argument(start)
        stem = self.stem(first, last)
        if stem is not None:
            self.whole_name(stem, start, order)
            return
        self.grouped(first, last, always=True)
        self.put(Kind.PRIMES, "'" * order, start, self.at, order)
        self.tail()

    def _word(self, start: int) -> None:
        r"""`\mathrm{rod}`, `\operatorname{sgn}`: one name, or a function; `\mathrm{d}x` is a differential."""
        first, last = self.argument(start)
        inside = self.text[first:last].strip()
        if inside == "d" and not self._followed_by_script():
            if self.names.is_declared("d"):
                message = "`d` is declared, and this is read neither as it nor as a differential"
                raise self.mistake("not-a-differential", message, start, self.at, "write `d` for the symbol")
            self.differential("d", start)
        elif inside == "e":
            self.exponential(start, self.at)
        elif inside in NAMED_FUNCTIONS:
            self.function(NAMED_FUNCTIONS[inside], start)
        elif (stem := self.stem(first, last)) is not None:
            self.whole_name(stem, start)
        elif not _WORD.fullmatch(inside):
            self.grouped(first, last)
            self.tail()
        elif " " in inside or not inside:
            message, help_ = "words stand in the equation", "leave them out, or put them beside it"
            raise self.mistake("words-in-equation", message, start, self.at, help_)
        else:
            run = self.names.run(inside)
            if len(run.pieces) > 1 and all(self.names.is_declared(name) for _, name in run.pieces):
                self.grouped(first, last)
                self.tail()
            else:
                self.name(inside, start, self.at)
                self.tail()

    def _followed_by_script(self) -> bool:
        return self.looking_at("_") or self.looking_at("^")

    def _vector_name(self, start: int, command: str) -> None:
        r"""`\mathbf{r}_P`, `\vec{F}`, `\hat{k}`."""
        first, last = self.argument(start)
        stem = self.stem(first, last)
        if stem is not None:
            self.whole_name(replace(stem, vector=stem.vector if stem.vector == "hat" else command), start)
        else:
            self.grouped(first, last)
            self.tail()
