r"""Numbers and names in LaTeX: `m_{12}`, `\ddot{\theta}_1`, `\omega^2_0`, `\lambda_{\text{rod}}`, `\mathbf{r}_P`."""

from __future__ import annotations

import re
from abc import abstractmethod
from dataclasses import replace

from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.records import record
from lagrange.expressions.characters import DOT, GREEK, PRIMES, SUPERSCRIPTS
from lagrange.expressions.latex_commands import ACCENTS, LETTERS, VECTORS, WORDS
from lagrange.expressions.latex_names import Names, spellings
from lagrange.expressions.latex_scanner import Scanner, Scripts
from lagrange.expressions.lexicon import FUNCTIONS, Role
from lagrange.expressions.scope import UNITS, Scope
from lagrange.expressions.tokens import MAX_DIGITS, Kind, Token

_NUMBER = re.compile(r"(?P<whole>[0-9]*)(?:(?P<point>\.|\{,\})(?P<decimals>[0-9]*))?")
_POWER_OF_TEN = re.compile(r"[eE]([-+]?)([0-9]{1,4})(?![0-9A-Za-z])")
_PLAIN = re.compile(rf"[A-Za-z](?!{DOT})(?:[A-Za-z0-9_](?!{DOT}))*")
_RUN = re.compile(rf"[A-Za-z](?!{DOT})(?:[A-Za-z0-9](?!{DOT}))*|[A-Za-z]")
_MOVING = (Role.COORDINATE, Role.PRESCRIBED)


@record
class Stem:
    """A name without what hangs outside its braces; `vector` is the command that makes it bold."""

    letter: str
    parts: tuple[str, ...] = ()
    primes: int = 0
    vector: str = ""


class LatexAtoms(Scanner):
    """Reads numbers and names into tokens; what stands in braces is left to the reader of everything."""

    def __init__(self, fragment: Fragment, scope: Scope) -> None:
        super().__init__(fragment)
        self.scope = scope
        self.names = Names(scope)
        self.found: list[Token] = []
        self.moving = 0  # how many coordinates, prescribed motions and t have been read
        self._pieces: dict[int, tuple[int, str, bool]] = {}

    @abstractmethod
    def everything(self, first: int, last: int) -> None:
        """Reads all that stands between two places."""

    # -- tokens ----------------------------------------------------------------------------------------------

    def put(self, kind: Kind, text: str, start: int, end: int, count: int = 0, hidden: bool = False) -> None:
        """A token for characters `start` to `end`."""
        first, last = self.place(start, end)
        self.found.append(Token(kind, text, first, last, count, hidden=hidden))

    def operator(self, text: str, start: int, end: int, hidden: bool = False) -> None:
        """An operator, a bracket or a comma."""
        self.put(Kind.OPERATOR, text, start, end, hidden=hidden)

    def open(self, start: int, end: int, applied: bool = False) -> None:
        """A parenthesis that is not written; it multiplies what stands before it, unless that is applied."""
        before = self.found[-1] if self.found else None
        ends_factor = before is not None and (
            before.kind in (Kind.NUMBER, Kind.NAME, Kind.PRIMES) or before.text in (")", "]")
        )
        if ends_factor and not applied:
            self.operator("*", start, start, hidden=True)
        self.operator("(", start, end, hidden=True)

    def close(self, start: int, end: int) -> None:
        """The parenthesis that closes one that is not written."""
        self.operator(")", start, end, hidden=True)

    def grouped(self, first: int, last: int, applied: bool = False, always: bool = False) -> None:
        """What stands between two places, in parentheses unless it is one number or name."""
        index = len(self.found)
        self.open(max(first - 1, 0), first, applied)
        opened = len(self.found)
        self.everything(first, last)
        added = self.found[opened:]
        if not added:
            help_ = "write an expression there"
            place = max(first - 1, 0)
            raise self.mistake("empty-brackets", "nothing stands in these braces", place, last + 1, help_)
        single = len(added) == 1 and added[0].kind in (Kind.NUMBER, Kind.NAME) and added[0].text not in FUNCTIONS
        if single and not always and "/" not in added[0].text:
            self.found[index:] = added
        else:
            self.close(last, last + 1)

    def name(self, text: str, start: int, end: int) -> None:
        """A name."""
        self.put(Kind.NAME, text, start, end)
        if text == "t" or self.scope.role(text) in _MOVING:
            self.moving += 1

    def hang(self, scripts: Scripts, more: int = 0) -> None:
        """Primes and the exponent, behind what they hang on; reads on behind them."""
        count = scripts.primes + more
        if count:
            end = scripts.exponent[0] if scripts.exponent else scripts.end
            self.put(Kind.PRIMES, "'" * count, max(end - 1, 0), max(end, 1), count)
        if scripts.exponent is not None:
            self.raised(*scripts.exponent)
        self.at = scripts.end

    def raised(self, first: int, last: int) -> None:
        """An exponent."""
        self.operator("^", max(first - 1, 0), first)
        if self.text[first:last] and all(c in SUPERSCRIPTS for c in self.text[first:last]):
            self._superscript(first, last)
            return
        inside = self.text[first:last]
        if "circ" in inside:
            help_ = r"angles are in radians: `30\pi/180`"
            raise self.mistake("unknown-command", "degrees are not read", first, last, help_)
        if re.fullmatch(r"\([2-9]\)", inside):
            message = f"`^{{{inside}}}` is read as a power"
            self.note(message, first, last, r"a derivative is written `\ddot{x}` or `x''`")
        self.grouped(first, last, applied=True)

    def _superscript(self, first: int, last: int) -> None:
        digits = "".join(SUPERSCRIPTS[c] for c in self.text[first:last])
        number = digits.removeprefix("-")
        if not number.isdigit():
            message, help_ = "this exponent cannot be read", "write it as `^2`"
            raise self.mistake("bad-exponent", message, first, last, help_)
        if number != digits:
            self.operator("-", first, last)
        self.put(Kind.NUMBER, number, first, last)

    def tail(self) -> Scripts:
        """What hangs on a bracket, a fraction or a number; a subscript may not."""
        scripts = self.scripts(self.at)
        if scripts.subscript is not None:
            message, help_ = "this subscript hangs on no name", r"an index belongs to a letter: `\theta_{1}`"
            raise self.mistake("bad-subscript", message, *scripts.subscript, help_)
        self.hang(scripts)
        return scripts

    # -- numbers ---------------------------------------------------------------------------------------------

    def number(self) -> None:
        """A number; `9{,}81` has a decimal comma."""
        start = self.at
        found = _NUMBER.match(self.text, start, self.limit)
        assert found is not None
        whole, decimals = found["whole"], found["decimals"] or ""
        self.at = found.end()
        exponent, places = "", 0
        if self.scope.scalar("e") is None and (power := _POWER_OF_TEN.match(self.text, self.at, self.limit)):
            self.at, exponent, places = power.end(), f"e{power[1].strip('+')}{power[2]}", int(power[2])
        if self.looking_at("."):
            help_ = "points stand in numbers only; a product is written `\\cdot`"
            raise self.mistake("bad-number", "a number has one decimal point", self.at, self.at + 1, help_)
        if len(whole) + len(decimals) + places > MAX_DIGITS:
            message, help_ = f"a number may have {MAX_DIGITS} digits", "round it, or declare a parameter in its place"
            raise self.mistake("number-too-long", message, start, self.at, help_)
        self.put(Kind.NUMBER, f"{whole or '0'}{'.' + decimals if decimals else ''}{exponent}", start, self.at)
        self.tail()

    # -- letters ---------------------------------------------------------------------------------------------

    def piece_here(self) -> tuple[int, str, bool]:
        """The name with which a run of letters begins, where it ends, and whether the run ends there too."""
        if self.at not in self._pieces:
            self._take_apart()
        return self._pieces[self.at]

    def _take_apart(self) -> None:
        start = self.at
        plain = _PLAIN.match(self.text, start, self.limit)
        written = plain[0].rstrip("_") if plain else ""
        if "_" in written and self.names.is_declared(written):
            self._pieces[start] = start + len(written), written, True
            return
        found = _RUN.match(self.text, start, self.limit)
        assert found is not None
        scripts = self.scripts(found.end())
        run = self.names.run(found[0], scripts.parts)
        if run.several:
            first, second, *_ = run.several
            message = f"`{found[0]}` is `{first}` or `{second}`"
            raise self.mistake("ambiguous-product", message, start, found.end(), f"write `{first}`, with a space")
        if run.surprises or any(len(n) > 1 for _, n in run.pieces[:-1]):
            reading = " ".join(n for _, n in run.pieces)
            self.note(f"`{found[0]}` is read as `{reading}`", start, found.end(), "write spaces between the factors")
        at = start
        for end, name in run.pieces:
            self._pieces[at] = start + end, name, start + end == found.end()
            at = start + end

    def letters(self) -> str:
        """A name of plain letters, the first of its run; gives the name."""
        start = self.at
        end, name, last = self.piece_here()
        scripts = self.scripts(end) if last else Scripts(end=end)
        if name == "e" and last and scripts.exponent is not None and not self.names.is_declared("e"):
            self.exponential(start, end)
            return name
        self._named(name, start, end, scripts)
        return name

    def exponential(self, start: int, end: int) -> None:
        """e^x, at the exponent or without one."""
        scripts = self.scripts(end)
        self.put(Kind.NAME, "exp", start, end)
        if scripts.exponent is None:
            self.open(start, start, applied=True)
            self.put(Kind.NUMBER, "1", start, end)
            self.close(end, end)
        else:
            self.grouped(*scripts.exponent, applied=True, always=True)
        self.at = max(scripts.end, end)

    def _named(self, name: str, start: int, end: int, scripts: Scripts, more: int = 0) -> None:
        if scripts.subscript is not None and scripts.subscript[0] <= (scripts.exponent or (self.limit,))[0]:
            end = scripts.subscript[1]
        self.name(name, start, end)
        self.hang(scripts, more)

    def greek(self, letter: str, start: int) -> None:
        """A Greek letter, read up to here."""
        scripts = self.scripts(self.at)
        self._named(self._declared(letter, scripts.parts), start, self.at, scripts)

    def _declared(self, letter: str, parts: tuple[str, ...]) -> str:
        return self.names.spelled(letter, parts) or spellings(letter, parts)[0]

    # -- names in braces -------------------------------------------------------------------------------------

    def stem(self, first: int, last: int) -> Stem | None:
        """The name that alone stands between two places; None where something else does."""
        at, limit = self.at, self.limit
        self.at, self.limit = first, last
        try:
            found = self._stem()
            return found if found is not None and not self.text[self.at : last].strip() else None
        finally:
            self.at, self.limit = at, limit

    def _stem(self) -> Stem | None:
        self._blanks()
        if self.ends():
            return None
        start, char, command = self.at, self.text[self.at], self.command()
        if char.isascii() and char.isalpha():
            found = _RUN.match(self.text, start, self.limit)
            assert found is not None
            inner = Stem(found[0])
            self.at = found.end()
            if len(found[0]) > 1 and self.names.spelled(found[0], self.scripts(self.at).parts) is None:
                return None
        elif char in GREEK:
            inner, self.at = Stem(GREEK[char]), start + 1
        elif command in LETTERS:
            inner, self.at = Stem(LETTERS[command]), start + 1 + len(command)
        elif command in WORDS or command in VECTORS or command in ACCENTS or char == "{":
            self.at = start + (1 + len(command) if command else 0)
            inside = self.stem(*self.argument(start))
            if inside is None:
                return None
            bold = inside.vector or (command if command in VECTORS else "")
            inner = replace(inside, primes=inside.primes + ACCENTS.get(command, 0), vector=bold)
        else:
            return None
        scripts = self.scripts(self.at)
        if scripts.exponent is not None or (scripts.parts and inner.parts):
            return None
        self.at = max(scripts.end, self.at)
        return Stem(inner.letter, inner.parts + scripts.parts, inner.primes + scripts.primes, inner.vector)

    def whole_name(self, stem: Stem, start: int, order: int = 0) -> None:
        """A name whose letter stands in braces, with what hangs outside; read up to the end of the braces."""
        end = self.at
        scripts = self.scripts(end)
        if stem.parts and scripts.subscript is not None:
            raise self.mistake("double-script", "a second subscript", *scripts.subscript, "write `_{1,2}`")
        parts = stem.parts + scripts.parts
        name = self._vector(stem, parts, start, end) if stem.vector else self._declared(stem.letter, parts)
        self._named(name, start, end, scripts, order + stem.primes)

    def _vector(self, stem: Stem, parts: tuple[str, ...], start: int, end: int) -> str:
        """The vector that a bold letter is: `\\mathbf{r}_P`, `\\hat{k}`, `\\hat{x}`."""
        letter = stem.letter
        if letter in UNITS and not parts:
            return letter if self.scope.vector(letter) is not None else f"e_{'xyz'['ijk'.index(letter)]}"
        unit = spellings("e", (letter, *parts)) if stem.vector == "hat" else ()
        for name in (*spellings(letter, parts), *unit):
            if self.scope.vector(name) is not None or self.scope.role(name) is Role.VECTOR:
                return name
        name = self._declared(letter, parts)
        if self.names.is_declared(name):
            raise self.not_a_vector(name, start, end)
        return name

    def not_a_vector(self, name: str, start: int, end: int) -> ProblemError:
        """A letter is bold that is a scalar."""
        message = f"`{name}` is a scalar, and is written as a vector"
        return self.mistake("not-a-vector", message, start, end, "leave the arrow, the hat or the bold type out")

    def primes_here(self) -> None:
        """Primes that hang on nothing: the parser says so."""
        start = self.at
        while not self.ends() and self.text[self.at] in PRIMES:
            self.at += 1
        self.put(Kind.PRIMES, "'" * (self.at - start), start, self.at, self.at - start)
