r"""LaTeX as characters and groups: what is passed over, where braces close, what a command takes, what is a subscript.

A position is an index into the text as it looks (`characters`), and `limit` is where the group being read ends. Braces
are matched once for the whole text, so that nothing is looked for twice.
"""

from __future__ import annotations

import re
from bisect import bisect_left

from lagrange.core.diagnostics import Diagnostic, Fragment, Level, ProblemError
from lagrange.core.records import record
from lagrange.expressions.characters import DOT, GREEK, PRIMES, SUBSCRIPTS, SUPERSCRIPTS, looks
from lagrange.expressions.latex_commands import LETTERS, MARKS, NOTHING, SPACES, WORDS
from lagrange.expressions.stream import MAX_NESTING

_COMMAND = re.compile(r"\\([A-Za-z]+\*?|.)", re.DOTALL)
_ROW = re.compile(r"\\\\\*?(?:\[[0-9a-z. ]{1,20}\])?")
_BRACED = re.compile(r"\s*\{[^{}]{0,200}\}")
_WORD = re.compile(r"[A-Za-z0-9]+")
_SUBSCRIPT = re.compile(rf"[{''.join(SUBSCRIPTS)}]+")
_PRIMES_ONLY = re.compile(r"(?:\s|\\prime(?![A-Za-z])|['′’ʹ″‴⁗])+")


@record
class Scripts:
    """What hangs on a letter or a bracket: primes, subscripts, and where its exponent stands.

    end     where all of it ends
    before  where the primes and subscripts end, ahead of the exponent or behind it
    """

    primes: int = 0
    parts: tuple[str, ...] = ()
    exponent: tuple[int, int] | None = None
    end: int = 0
    subscript: tuple[int, int] | None = None


class Scanner:
    """A text in LaTeX, and how far it has been read."""

    def __init__(self, fragment: Fragment) -> None:
        self.fragment = fragment
        self.looks = looks(fragment)
        self.text = self.looks.text
        self.at = 0
        self.limit = len(self.text)
        self.notes: list[Diagnostic] = []
        self.steps = 0
        self.depth = 0
        self._matching = self._braces()

    def _braces(self) -> dict[int, int]:
        """Where the brace that opens at a place closes."""
        found: dict[int, int] = {}
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
                    message = f"this nests deeper than {MAX_NESTING}"
                    raise self.mistake("nested-too-deep", message, at, at + 1, "introduce abbreviations")
            elif char == "}":
                if not opened:
                    help_ = "remove it, or open it before"
                    raise self.mistake("not-opened", "this `}` closes nothing", at, at + 1, help_)
                found[opened.pop()] = at
            at += 1
        if opened:
            raise self.mistake("not-closed", "this `{` is not closed", opened[-1], opened[-1] + 1, "add `}`")
        return found

    def _line_end(self, at: int) -> int:
        """Where the line ends that a place is in."""
        end = self.fragment.text.find("\n", self.looks.places[at])
        return len(self.text) if end < 0 else bisect_left(self.looks.places, end)

    # -- reading on ------------------------------------------------------------------------------------------

    def ends(self) -> bool:
        """Whether the group has been read."""
        return self.at >= self.limit

    def skip(self) -> bool:
        """Passes over blanks, comments, marks and spaces. Whether a space was among them that is seen in print."""
        seen = False
        while self.at < self.limit:
            self.steps += 1
            char = self.text[self.at]
            if char in " &$":
                self.at += 1
            elif char == "~":
                self.at, seen = self.at + 1, True
            elif char == "%":
                self.at = min(self._line_end(self.at), self.limit)
            elif char == "\\":
                end = self._passed_over()
                if not end:
                    break
                seen = seen or self.command() in SPACES
                self.at = min(end, self.limit)
            else:
                break
        return seen

    def _passed_over(self) -> int:
        """Where a command that means nothing ends; 0 where the command means something."""
        name = self.command()
        end = self.at + 1 + len(name)
        if name == "\\":
            found = _ROW.match(self.text, self.at)
            return found.end() if found else end
        if name in ("(", ")"):
            return end
        if name in MARKS and (braced := _BRACED.match(self.text, end)):
            return braced.end()
        return end if name in SPACES or name in NOTHING else 0

    def command(self) -> str:
        """The command that stands here, without its backslash; empty if none does."""
        found = _COMMAND.match(self.text, self.at, self.limit)
        return found[1] if found else ""

    def looking_at(self, text: str) -> bool:
        """Whether a text stands here."""
        return self.at < self.limit and self.text.startswith(text, self.at)

    def group_end(self, at: int) -> int:
        """Where the brace closes that opens at a place."""
        return self._matching[at]

    def argument(self, owner: int) -> tuple[int, int]:
        """What a command, or `^`, at `owner` takes from here: what stands in braces, or one letter, digit or command.

        Gives where it begins and ends, and reads on behind it.
        """
        self.skip()
        if self.ends() or self.text[self.at] in "^_)]=&|+*/,":
            written = self.written(owner, owner + 1 + len(_command_at(self.text, owner)))
            message = f"`{written}` takes what stands behind it in braces"
            raise self.mistake(
                "latex-argument", message, owner, owner + max(1, len(written)), f"write `{written}{{...}}`"
            )
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
            message = f"`\\{name}` stands where one letter, or something in braces, belongs"
            raise self.mistake("latex-argument", message, start, self.at, "put braces around what is meant")
        while self.at < self.limit and self.text[self.at] == DOT:
            self.at += 1
        return start, self.at

    # -- scripts ---------------------------------------------------------------------------------------------

    def scripts(self, at: int) -> Scripts:
        """The primes, subscripts and the exponent that hang on what ends at a place; nothing is read."""
        start, self.at = self.at, at
        primes = 0
        parts: tuple[str, ...] = ()
        exponent: tuple[int, int] | None = None
        where: tuple[int, int] | None = None
        end = at
        while True:
            self._blanks()
            char = self.text[self.at] if self.at < self.limit else ""
            mark = self.at
            if char in PRIMES and char:
                primes += PRIMES[char]
                self.at += 1
            elif char == DOT:
                primes += 1
                self.at += 1
            elif char == "^":
                self.at += 1
                first, last = self.argument(mark)
                if first < last and _PRIMES_ONLY.fullmatch(self.text, first, last):
                    inside = self.text[first:last]
                    primes += inside.count("\\prime") + sum(PRIMES.get(c, 0) for c in inside)
                elif exponent is not None:
                    help_ = "put braces around what is raised"
                    raise self.mistake("double-script", "a second exponent", mark, self.at, help_)
                else:
                    exponent = first, last
                    self._no_digits(mark, first, last)
            elif char == "_" or (char and char in SUBSCRIPTS):
                if parts:
                    raise self.mistake("double-script", "a second subscript", mark, self.at + 1, "write `_{1,2}`")
                parts = self._subscript(mark)
                where = mark, self.at
            elif char and char in SUPERSCRIPTS and exponent is None:
                last = self.at
                while last < self.limit and self.text[last] in SUPERSCRIPTS:
                    last += 1
                exponent, self.at = (self.at, last), last
            else:
                break
            end = self.at
        self.at = start
        return Scripts(primes, parts, exponent, end, where)

    def _blanks(self) -> None:
        while self.at < self.limit and self.text[self.at] == " ":
            self.at += 1

    def _no_digits(self, mark: int, first: int, last: int) -> None:
        """`x^23` is x² 3 in print: it is said, and not read so."""
        if last == self.at and self.text[first].isdigit() and self.text[last : last + 1].isdigit():
            end = last
            while end < self.limit and self.text[end].isdigit():
                end += 1
            written = self.text[first:end]
            message = f"only the first digit of `{self.text[mark]}{written}` is raised or lowered in print"
            raise self.mistake("latex-argument", message, mark, end, f"write `{self.text[mark]}{{{written}}}`")

    def _subscript(self, mark: int) -> tuple[str, ...]:
        """The parts of a subscript: `_{1,B}` is 1, B."""
        if found := _SUBSCRIPT.match(self.text, self.at, self.limit):
            self.at = found.end()
            return ("".join(SUBSCRIPTS[c] for c in found[0]),)
        self.at += 1
        first, last = self.argument(mark)
        self._no_digits(mark, first, last)
        parts = self._parts(first, last)
        if not parts:
            raise self.mistake(
                "empty-brackets", "nothing stands in these braces", mark, self.at, "write the index there"
            )
        return parts

    def _parts(self, first: int, last: int) -> tuple[str, ...]:
        """The words, digits and letters of a subscript; commas and spaces part them, `x_{1}` in it too."""
        found: list[str] = []
        joined = False
        at = first
        while at < last:
            if word := _WORD.match(self.text, at, last):
                found[len(found) - joined :] = ["".join(found[len(found) - joined :]) + word[0]]
                at, joined = word.end(), True
                continue
            char = self.text[at]
            command = _command_at(self.text, at)
            if char in GREEK:
                found.append(GREEK[char])
            elif command in LETTERS:
                found.append(LETTERS[command])
            elif not (char in " ,_{}.~" or command in (*SPACES, *WORDS, "!")):
                message = f"`{self.written(at, at + 1 + len(command))}` cannot stand in a subscript"
                raise self.mistake(
                    "bad-subscript", message, at, at + 1 + len(command), "an index has letters and digits"
                )
            joined = False
            at += 1 + len(command)
        return tuple(found)

    # -- places ----------------------------------------------------------------------------------------------

    def written(self, start: int, end: int) -> str:
        """The text as it was written."""
        first, last = self.place(start, end)
        return self.fragment.text[first:last]

    def place(self, start: int, end: int) -> tuple[int, int]:
        """Where characters stand in the text as it was written."""
        return self.looks.written(min(start, len(self.text)), min(end, len(self.text)))

    def mistake(self, code: str, message: str, start: int, end: int, help_: str) -> ProblemError:
        """An error at a place."""
        return ProblemError(Diagnostic(code, message, self.fragment.span(*self.place(start, end)), help=help_))

    def note(self, message: str, start: int, end: int, help_: str) -> None:
        """Says how something was read."""
        span = self.fragment.span(*self.place(start, end))
        self.notes.append(Diagnostic("read-as", message, span, help=help_, level=Level.NOTE))


def _command_at(text: str, at: int) -> str:
    found = _COMMAND.match(text, at)
    return found[1] if found else ""
