r"""LaTeX as characters and groups: what is skipped, where braces close, what a command takes, what a subscript is.

A position is an index into the normalized text (`characters`), and `limit` is where the group being read ends. Braces
are matched once for the whole text, so that no search for a closing brace is repeated and the time stays proportional
to the length.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator
from contextlib import contextmanager

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity
from lagrange.core.records import record
from lagrange.expressions.characters import DOT, GREEK, PRIMES, SUBSCRIPTS, SUPERSCRIPTS, normalized
from lagrange.expressions.latex_names import LETTERS, MARKS, NOTHING, SPACES, WORDS
from lagrange.expressions.limits import MAX_NESTING

TextRange = tuple[int, int]
"""Where something begins and ends (exclusive)."""

_COMMAND = re.compile(r"\\([A-Za-z]+\*?|.)", re.DOTALL)
_ROW = re.compile(r"\\\\\*?(?:\[[0-9a-z. ]{1,20}\])?")
_BRACED = re.compile(r"\s*\{[^{}]{0,200}\}")
_WORD = re.compile(r"[A-Za-z0-9]+")
_SUBSCRIPT = re.compile(rf"[{''.join(SUBSCRIPTS)}]+")
_PRIMES_ONLY = re.compile(r"(?:\s|\\prime(?![A-Za-z])|['′’ʹ″‴⁗])+")


@record
class Scripts:
    """What is attached to a letter or a bracket: the count of primes, the parts of its subscript, and places.

    end  where the last of them ends
    """

    primes: int = 0
    parts: tuple[str, ...] = ()
    exponent: TextRange | None = None
    end: int = 0
    subscript: TextRange | None = None


class Scanner:
    """A text in LaTeX, and how far it has been read.

    steps  how often a character or factor has been looked at, so that a test can hold the time to the length
    """

    def __init__(self, fragment: Fragment) -> None:
        self.fragment = fragment
        self.normalized = normalized(fragment)
        self.text = self.normalized.text
        self.at = 0
        self.limit = len(self.text)
        self.notes: list[Diagnostic] = []
        self.steps = 0
        self._closings = self._closing_braces()

    def _closing_braces(self) -> dict[int, int]:
        """The position of the closing brace for that of each opening one."""
        closings: dict[int, int] = {}
        opened: list[int] = []
        at = 0
        while at < len(self.text):
            char = self.text[at]
            if char == "\\":
                at += 1
            elif char == "%":
                at = self._line_end(at)
                continue
            elif char == "{":
                opened.append(at)
                if len(opened) > MAX_NESTING:
                    message = f"this is nested more than {MAX_NESTING} deep"
                    raise self.error("nested-too-deep", message, at, at + 1, "introduce abbreviations")
            elif char == "}":
                if not opened:
                    help_ = "remove it, or add the opening bracket"
                    raise self.error("not-opened", "this `}` closes nothing", at, at + 1, help_)
                closings[opened.pop()] = at
            at += 1
        if opened:
            raise self.error("not-closed", "this `{` is not closed", opened[-1], opened[-1] + 1, "add `}`")
        return closings

    def _line_end(self, at: int) -> int:
        end = self.fragment.text.find("\n", self.normalized.places[at])
        return len(self.text) if end < 0 else bisect_left(self.normalized.places, end)

    # -- reading on ------------------------------------------------------------------------------------------

    def ends(self) -> bool:
        """Whether the group has been read."""
        return self.at >= self.limit

    @contextmanager
    def within(self, first: int, last: int) -> Iterator[None]:
        """Read between two positions, then go back to where reading was."""
        outer = self.at, self.limit
        self.at, self.limit = first, last
        try:
            yield
        finally:
            self.at, self.limit = outer

    def skip(self) -> bool:
        """Skip blanks, comments, marks and spaces; return whether one of them is a space that is visible in print."""
        visible = False
        while self.at < self.limit:
            self.steps += 1
            char = self.text[self.at]
            if char in " &$":
                self.at += 1
            elif char == "~":
                self.at, visible = self.at + 1, True
            elif char == "%":
                self.at = min(self._line_end(self.at), self.limit)
            elif char == "\\":
                end = self._end_of_ignored()
                if not end:
                    break
                visible = visible or self.command() in SPACES
                self.at = min(end, self.limit)
            else:
                break
        return visible

    def skip_blanks(self) -> None:
        """Skip blanks alone."""
        while self.at < self.limit and self.text[self.at] == " ":
            self.at += 1

    def _end_of_ignored(self) -> int:
        """Where a command without a meaning ends; 0 if the command has one."""
        name = self.command()
        end = self.at + 1 + len(name)
        if name == "\\":
            row = _ROW.match(self.text, self.at)
            return row.end() if row else end
        if name in ("(", ")"):
            return end
        if name in MARKS and (braced := _BRACED.match(self.text, end)):
            return braced.end()
        return end if name in SPACES or name in NOTHING else 0

    def command(self) -> str:
        """The command at this position without its backslash; empty if there is none."""
        match = _COMMAND.match(self.text, self.at, self.limit)
        return match[1] if match else ""

    def looking_at(self, text: str) -> bool:
        """Whether the text continues with this one."""
        return self.at < self.limit and self.text.startswith(text, self.at)

    def group_end(self, at: int) -> int:
        """The position of the brace that closes the one at `at`."""
        return self._closings[at]

    def argument(self, owner: int) -> TextRange:
        """Read the argument of a command, or of `^`, at `owner`: a group in braces, or one letter, digit or command."""
        self.skip()
        if self.ends() or self.text[self.at] in "^_)]=&|+*/,":
            written = self.written(owner, owner + 1 + len(_command_at(self.text, owner)))
            message = f"`{written}` takes an argument in braces"
            help_ = f"write `{written}{{...}}`"
            raise self.error("latex-argument", message, owner, owner + max(1, len(written)), help_)
        start = self.at
        if self.text[start] == "{":
            end = self.group_end(start)
            self.at = end + 1
            return start + 1, end
        name = self.command()
        self.at = start + (1 + len(name) if name else 1)
        if name in WORDS or name in ("mathbf", "boldsymbol", "vec", "hat", "bm"):
            self.argument(start)
        elif name and name not in LETTERS and name not in ("prime", "{", "}"):
            message = f"`\\{name}` is used where one letter, or a group in braces, is expected"
            raise self.error("latex-argument", message, start, self.at, "put braces around the argument")
        while self.at < self.limit and self.text[self.at] == DOT:
            self.at += 1
        return start, self.at

    # -- scripts ---------------------------------------------------------------------------------------------

    def scripts(self, at: int) -> Scripts:
        """The primes, the subscript and the exponent after position `at`; the scanner does not move."""
        start, self.at = self.at, at
        primes = 0
        parts: tuple[str, ...] = ()
        exponent: TextRange | None = None
        subscript: TextRange | None = None
        end = at
        while True:
            self.skip_blanks()
            char = self.text[self.at] if self.at < self.limit else ""
            mark = self.at
            if char and char in PRIMES:
                primes += PRIMES[char]
                self.at += 1
            elif char == DOT:
                primes += 1
                self.at += 1
            elif char == "^":
                self.at += 1
                first, last = self.argument(mark)
                # x^{\prime}, x^{''}: primes in an exponent are derivatives, and an exponent may follow them.
                if first < last and _PRIMES_ONLY.fullmatch(self.text, first, last):
                    inside = self.text[first:last]
                    primes += inside.count("\\prime") + sum(PRIMES.get(c, 0) for c in inside)
                elif exponent is not None:
                    help_ = "put braces around the base"
                    raise self.error("double-script", "a second exponent", mark, self.at, help_)
                else:
                    exponent = first, last
                    self._refuse_digits(mark, first, last)
            elif char == "_" or (char and char in SUBSCRIPTS):
                if parts:
                    raise self.error("double-script", "a second subscript", mark, self.at + 1, "write `_{1,2}`")
                parts = self._subscript(mark)
                subscript = mark, self.at
            elif char and char in SUPERSCRIPTS and exponent is None:
                last = self.at
                while last < self.limit and self.text[last] in SUPERSCRIPTS:
                    last += 1
                exponent, self.at = (self.at, last), last
            else:
                break
            end = self.at
        self.at = start
        return Scripts(primes, parts, exponent, end, subscript)

    def _refuse_digits(self, mark: int, first: int, last: int) -> None:
        """Refuse `x^23`, which LaTeX prints as x² 3."""
        if last == self.at and self.text[first].isdigit() and self.text[last : last + 1].isdigit():
            end = last
            while end < self.limit and self.text[end].isdigit():
                end += 1
            written = self.text[first:end]
            message = f"only the first digit of `{self.text[mark]}{written}` is raised or lowered in print"
            raise self.error("latex-argument", message, mark, end, f"write `{self.text[mark]}{{{written}}}`")

    def _subscript(self, mark: int) -> tuple[str, ...]:
        """Read a subscript; its parts: `_{1,B}` is 1, B."""
        if subscript := _SUBSCRIPT.match(self.text, self.at, self.limit):
            self.at = subscript.end()
            return ("".join(SUBSCRIPTS[c] for c in subscript[0]),)
        self.at += 1
        first, last = self.argument(mark)
        self._refuse_digits(mark, first, last)
        parts = self._parts(first, last)
        if not parts:
            help_ = "write the index there"
            raise self.error("empty-brackets", "these braces are empty", mark, self.at, help_)
        return parts

    def _parts(self, first: int, last: int) -> tuple[str, ...]:
        """The words, digits and letters of a subscript, separated by commas and spaces; that of `x_{1}` in it too."""
        parts: list[str] = []
        joined = False
        at = first
        while at < last:
            if word := _WORD.match(self.text, at, last):
                parts[len(parts) - joined :] = ["".join(parts[len(parts) - joined :]) + word[0]]
                at, joined = word.end(), True
                continue
            char = self.text[at]
            command = _command_at(self.text, at)
            if char in GREEK:
                parts.append(GREEK[char])
            elif command in LETTERS:
                parts.append(LETTERS[command])
            elif not (char in " ,_{}.~" or command in (*SPACES, *WORDS, "!")):
                end = at + 1 + len(command)
                message = f"`{self.written(at, end)}` is not allowed in a subscript"
                raise self.error("bad-subscript", message, at, end, "an index consists of letters and digits")
            joined = False
            at += 1 + len(command)
        return tuple(parts)

    # -- places ----------------------------------------------------------------------------------------------

    def written(self, start: int, end: int) -> str:
        """The text between two positions, as it was written."""
        first, last = self.place(start, end)
        return self.fragment.text[first:last]

    def place(self, start: int, end: int) -> TextRange:
        """The place in the text as it was written."""
        return self.normalized.written(min(start, len(self.text)), min(end, len(self.text)))

    def error(self, code: str, message: str, start: int, end: int, help_: str) -> ProblemError:
        """An error at a place."""
        return ProblemError(Diagnostic(code, message, self.fragment.span(*self.place(start, end)), help=help_))

    def note(self, message: str, start: int, end: int, help_: str) -> None:
        """Report how something was read."""
        span = self.fragment.span(*self.place(start, end))
        self.notes.append(Diagnostic("read-as", message, span, help=help_, level=Severity.NOTE))


def _command_at(text: str, at: int) -> str:
    match = _COMMAND.match(text, at)
    return match[1] if match else ""
