r"""Atoms in LaTeX -> tokens: numbers, names, brackets and groups, with the primes and exponents attached to them.

    m_{12}, \ddot{\theta}_1, \omega^2_0, \lambda_{\text{rod}}, \mathbf{r}_P      names
    \left( \right), \bigl[ \bigr], \{ \}, \lvert \rvert                           brackets

Braces become parentheses that are not written (`hidden`). Square brackets and `\{ \}` group, unless commas make a list
of components. `\lvert x \rvert` is abs(x) and `\lVert a \rVert` is norm(a); a bare `|` is left to the parser.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from lagrange.core.diagnostics import ProblemError
from lagrange.core.records import record
from lagrange.expressions.characters import DOT, GREEK, SUPERSCRIPTS
from lagrange.expressions.latex_names import ACCENTS, LETTERS, SIZES, VECTORS, WORDS, LatexNames, spellings
from lagrange.expressions.latex_scanner import Scanner, Scripts
from lagrange.expressions.limits import MAX_DIGITS, MAX_POWER_OF_TEN
from lagrange.expressions.scope import UNITS, Scope
from lagrange.expressions.syntax_tree import FUNCTIONS, Role
from lagrange.expressions.tokens import Token, TokenKind

_NUMBER = re.compile(r"(?P<integer>[0-9]*)(?:(?P<point>\.|\{,\})(?P<decimals>[0-9]*))?")
_POWER_OF_TEN = re.compile(r"[eE]([-+]?)([0-9]{1,4})(?![0-9A-Za-z])")
_PLAIN = re.compile(rf"[A-Za-z](?!{DOT})(?:[A-Za-z0-9_](?!{DOT}))*")
_RUN = re.compile(rf"[A-Za-z](?!{DOT})(?:[A-Za-z0-9](?!{DOT}))*|[A-Za-z]")
_MOVING = (Role.COORDINATE, Role.PRESCRIBED)

_CLOSES = {")": ")", "]": "]", "\\}": "}", "\\rbrace": "}", "\\rbrack": "]", "\\rvert": "|", "\\rVert": "‖", "|": "|",
    "\\vert": "|", "\\|": "‖", "\\rangle": ">", ".": "."}  # fmt: skip
_OPENS = {"(": ")", "[": "]", "\\{": "}", "\\lbrace": "}", "\\lbrack": "]", "\\lvert": "|", "\\lVert": "‖", "|": "|",
    "\\vert": "|", "\\|": "‖", ".": "."}  # fmt: skip
_DELIMITER = re.compile(r"\\[A-Za-z]+|\\[{}|]|[()\[\]|.]")
_SIZED = re.compile(r"\\[A-Za-z]+\s?(?:\\?.)?")
_ENDING = (")", "]", "\\}", "\\rbrace", "\\rbrack", "\\rvert", "\\rVert")


class TokenList(list[Token]):
    """The tokens of a text, added at positions of its scanner.

    moving  how many coordinates, prescribed motions and t are among them
    """

    def __init__(self, scanner: Scanner, scope: Scope) -> None:
        super().__init__()
        self.moving = 0
        self._scanner = scanner
        self._scope = scope

    def add(self, kind: TokenKind, text: str, start: int, end: int, count: int = 0, hidden: bool = False) -> None:
        """Add a token for characters `start` to `end`."""
        first, last = self._scanner.place(start, end)
        self.append(Token(kind, text, first, last, count, hidden=hidden))

    def add_operator(self, text: str, start: int, end: int, hidden: bool = False) -> None:
        """Add an operator, a bracket or a comma."""
        self.add(TokenKind.OPERATOR, text, start, end, hidden=hidden)

    def add_name(self, text: str, start: int, end: int) -> None:
        """Add a name."""
        self.add(TokenKind.NAME, text, start, end)
        if text == "t" or self._scope.role(text) in _MOVING:
            self.moving += 1

    def open(self, start: int, end: int, applied: bool = False) -> None:
        """Open a parenthesis that is not written; unless it is applied, it multiplies what precedes it."""
        before = self[-1] if self else None
        ends_factor = before is not None and (
            before.kind in (TokenKind.NUMBER, TokenKind.NAME, TokenKind.PRIMES) or before.text in (")", "]")
        )
        if ends_factor and not applied:
            self.add_operator("*", start, start, hidden=True)
        self.add_operator("(", start, end, hidden=True)

    def close(self, start: int, end: int) -> None:
        """Close a parenthesis that is not written."""
        self.add_operator(")", start, end, hidden=True)


@record
class Stem:
    """A name without the scripts outside its braces; `vector` is the command that marks it as a vector."""

    letter: str
    parts: tuple[str, ...] = ()
    primes: int = 0
    vector: str = ""


class NameReader:
    """Finds the declared names at positions of a scanner; adds no tokens."""

    def __init__(self, scanner: Scanner, scope: Scope) -> None:
        self.scanner = scanner
        self.scope = scope
        self._names = LatexNames(scope)
        self._pieces: dict[int, tuple[int, str, bool]] = {}

    def is_declared(self, name: str) -> bool:
        """Whether a name means something."""
        return self._names.is_declared(name)

    def is_product(self, letters: str) -> bool:
        """Whether a run of letters is a product of declared names."""
        run = self._names.run(letters)
        return len(run.pieces) > 1 and all(self.is_declared(name) for _, name in run.pieces)

    def piece(self) -> tuple[int, str, bool]:
        """Where the name at the head of a run of letters ends, the name, and whether the run ends there too."""
        if self.scanner.at not in self._pieces:
            self._split_run()
        return self._pieces[self.scanner.at]

    def _split_run(self) -> None:
        """Split the run of letters here into declared names, once: its pieces are looked up as they are reached."""
        scanner = self.scanner
        start = scanner.at
        plain = _PLAIN.match(scanner.text, start, scanner.limit)
        written = plain[0].rstrip("_") if plain else ""
        if "_" in written and self._names.is_declared(written):
            self._pieces[start] = start + len(written), written, True
            return
        letters = _RUN.match(scanner.text, start, scanner.limit)
        assert letters is not None
        run = self._names.run(letters[0], scanner.scripts(letters.end()).parts)
        if run.several:
            first, second, *_ = run.several
            message = f"`{letters[0]}` is `{first}` or `{second}`"
            help_ = f"write `{first}`, with a space"
            raise scanner.error("ambiguous-product", message, start, letters.end(), help_)
        if run.surprises or any(len(n) > 1 for _, n in run.pieces[:-1]):
            reading = " ".join(n for _, n in run.pieces)
            message = f"`{letters[0]}` is read as `{reading}`"
            scanner.note(message, start, letters.end(), "write spaces between the factors")
        at = start
        for end, name in run.pieces:
            self._pieces[at] = start + end, name, start + end == letters.end()
            at = start + end

    def spelled(self, letter: str, parts: tuple[str, ...]) -> str:
        """The declared name of a letter with subscripts, or the usual spelling where none is declared."""
        return self._names.spelled(letter, parts) or spellings(letter, parts)[0]

    def stem(self, first: int, last: int) -> Stem | None:
        """The name between two positions; None if there is anything else."""
        scanner = self.scanner
        with scanner.within(first, last):
            stem = self._stem()
            return stem if stem is not None and not scanner.text[scanner.at : last].strip() else None

    def _stem(self) -> Stem | None:
        scanner = self.scanner
        scanner.skip_blanks()
        if scanner.ends():
            return None
        start, char, command = scanner.at, scanner.text[scanner.at], scanner.command()
        if char.isascii() and char.isalpha():
            letters = _RUN.match(scanner.text, start, scanner.limit)
            assert letters is not None
            inner = Stem(letters[0])
            scanner.at = letters.end()
            if len(letters[0]) > 1 and self._names.spelled(letters[0], scanner.scripts(scanner.at).parts) is None:
                return None
        elif char in GREEK:
            inner, scanner.at = Stem(GREEK[char]), start + 1
        elif command in LETTERS:
            inner, scanner.at = Stem(LETTERS[command]), start + 1 + len(command)
        elif command in WORDS or command in VECTORS or command in ACCENTS or char == "{":
            scanner.at = start + (1 + len(command) if command else 0)
            inside = self.stem(*scanner.argument(start))
            if inside is None:
                return None
            vector = inside.vector or (command if command in VECTORS else "")
            inner = replace(inside, primes=inside.primes + ACCENTS.get(command, 0), vector=vector)
        else:
            return None
        scripts = scanner.scripts(scanner.at)
        if scripts.exponent is not None or (scripts.parts and inner.parts):
            return None
        scanner.at = max(scripts.end, scanner.at)
        return Stem(inner.letter, inner.parts + scripts.parts, inner.primes + scripts.primes, inner.vector)

    def vector(self, stem: Stem, parts: tuple[str, ...], start: int, end: int) -> str:
        r"""The name of the vector of a bold letter: `\mathbf{r}_P`, `\hat{k}`; `\hat{x}` may be e_x."""
        letter = stem.letter
        if letter in UNITS and not parts:
            return letter if self.scope.vector(letter) is not None else f"e_{'xyz'['ijk'.index(letter)]}"
        unit = spellings("e", (letter, *parts)) if stem.vector == "hat" else ()
        for name in (*spellings(letter, parts), *unit):
            if self.scope.vector(name) is not None or self.scope.role(name) is Role.VECTOR:
                return name
        name = self.spelled(letter, parts)
        if self._names.is_declared(name):
            message = f"`{name}` is a scalar, but is written as a vector"
            help_ = "leave the arrow, the hat or the bold type out"
            raise self.scanner.error("not-a-vector", message, start, end, help_)
        return name


class AtomReader:
    """Reads numbers, names, brackets and groups into tokens.

    read_factor  reads one factor or operator of any kind: the way back to the lexer from inside brackets
    """

    def __init__(self, scanner: Scanner, tokens: TokenList, names: NameReader, read_factor: Callable[[], None]) -> None:
        self.scanner = scanner
        self.tokens = tokens
        self.names = names
        self.read_factor = read_factor
        self._open_norms = 0  # `\|` opens and closes alike

    # -- groups ----------------------------------------------------------------------------------------------

    def everything(self, first: int, last: int) -> None:
        """Read everything between two positions."""
        scanner = self.scanner
        with scanner.within(first, last):
            self._factors()
            if not scanner.ends():
                written = self._closing_here()
                message, help_ = f"this `{written}` closes nothing", "remove it, or add the opening bracket"
                raise scanner.error("not-opened", message, scanner.at, scanner.at + len(written), help_)

    def _factors(self) -> None:
        while True:
            self.scanner.skip()
            if self.stops():
                return
            self.read_factor()

    def stops(self) -> bool:
        """Whether the group ends here, or a bracket closes."""
        scanner = self.scanner
        if scanner.ends():
            return True
        command = scanner.command()
        if command in SIZES and command[-1] not in "lrt":
            delimiter = _DELIMITER.match(scanner.text, scanner.at + 1 + len(command), scanner.limit)
            return delimiter is not None and delimiter[0] in _ENDING
        if command in SIZES:
            return command[-1] != "l" and command != "left"
        return (
            scanner.text[scanner.at] in ")]" or "\\" + command in _ENDING or (command == "|" and self._open_norms > 0)
        )

    def grouped(self, first: int, last: int, applied: bool = False, always: bool = False) -> None:
        """Read what is between two positions, in parentheses unless it is one number or name."""
        index = len(self.tokens)
        brace = max(first - 1, 0)
        self.tokens.open(brace, first, applied)
        opened = len(self.tokens)
        self.everything(first, last)
        inside = self.tokens[opened:]
        if not inside:
            help_ = "write an expression there"
            raise self.scanner.error("empty-brackets", "these braces are empty", brace, last + 1, help_)
        single = inside[0] if len(inside) == 1 and inside[0].kind in (TokenKind.NUMBER, TokenKind.NAME) else None
        if single is not None and single.text not in FUNCTIONS and not always and "/" not in single.text:
            self.tokens[index:] = inside
        else:
            self.tokens.close(last, last + 1)

    # -- brackets --------------------------------------------------------------------------------------------

    def at_bracket(self) -> bool:
        """Whether a bracket opens here."""
        command = self.scanner.command()
        return (
            self.scanner.looking_at("(")
            or self.scanner.looking_at("[")
            or command in ("{", "lbrace", "lvert", "lVert", "|")
            or (command in SIZES and not command.endswith("r") and command != "right")
        )

    def bracket(self, applied: bool = False) -> None:
        """Read a bracket and its content; an applied one groups even where commas make a list."""
        start = self.scanner.at
        sized, delimiter = self._delimiter()
        closing = _OPENS.get(delimiter)
        if closing is None or closing == ".":
            raise self._bad_delimiter(delimiter, start)
        opened = self.scanner.at
        if closing in ("|", "‖"):
            self.tokens.add(TokenKind.NAME, "abs" if closing == "|" else "norm", start, opened)
        index = len(self.tokens)
        self.tokens.add_operator("[" if closing == "]" else "(", start, opened)
        self._open_norms += closing == "‖" and not sized
        self._factors()
        self._open_norms -= closing == "‖" and not sized
        self._close(closing, start, opened)
        if closing == "]" and (applied or not self._has_comma(index)):
            first, last = self.tokens[index], self.tokens[-1]
            self.tokens[index] = Token(TokenKind.OPERATOR, "(", first.start, first.end)
            self.tokens[-1] = Token(TokenKind.OPERATOR, ")", last.start, last.end)

    def _has_comma(self, index: int) -> bool:
        """Whether there is a comma in the bracket that opens at token `index`, and not in a bracket inside it."""
        level = 0
        for token in self.tokens[index:]:
            if token.kind is TokenKind.OPERATOR:
                level += (token.text in "([") - (token.text in ")]")
                if token.text == "," and level == 1:
                    return True
        return False

    def _delimiter(self) -> tuple[bool, str]:
        """Read a bracket; whether a size such as `\\left` precedes it, and the bracket, empty if there is none."""
        scanner = self.scanner
        sized = scanner.command() in SIZES
        if sized:
            scanner.at += 1 + len(scanner.command())
            scanner.skip_blanks()
        delimiter = _DELIMITER.match(scanner.text, scanner.at, scanner.limit)
        if delimiter is None:
            return sized, ""
        scanner.at = delimiter.end()
        return sized, delimiter[0]

    def _close(self, closing: str, start: int, opened: int) -> None:
        scanner = self.scanner
        opening = scanner.written(start, opened)
        place = scanner.at
        if scanner.ends():
            help_ = f"add `{closing if closing != '‖' else chr(92) + '|'}`"
            raise scanner.error("not-closed", f"this `{opening}` is not closed", start, opened, help_)
        _, delimiter = self._delimiter()
        if _CLOSES.get(delimiter) != closing:
            if delimiter in ("", "."):
                raise self._bad_delimiter(delimiter, place)
            message = f"`{opening}` is closed by `{scanner.written(place, scanner.at)}`"
            raise scanner.error("not-closed", message, place, scanner.at, f"write `{closing}`")
        self.tokens.add_operator("]" if closing == "]" else ")", place, scanner.at)

    def _bad_delimiter(self, delimiter: str, start: int) -> ProblemError:
        end = max(self.scanner.at, start + 1)
        written = self.scanner.written(start, end)
        if delimiter == ".":
            message, help_ = f"`{written}` is not a bracket here", r"brackets come in pairs: `\left( ... \right)`"
        else:
            message, help_ = f"`{written}` must be followed by a bracket", r"write `\left( ... \right)`"
        return self.scanner.error("latex-argument", message, start, end, help_)

    def _closing_here(self) -> str:
        scanner = self.scanner
        command = scanner.command()
        if command in ("right", *SIZES):
            sized = _SIZED.match(scanner.text, scanner.at, scanner.limit)
            return sized[0] if sized else command
        return "\\" + command if command else scanner.text[scanner.at]

    # -- scripts ---------------------------------------------------------------------------------------------

    def attach(self, scripts: Scripts, more: int = 0) -> None:
        """Add primes, `more` of them from accents, and the exponent; read on after the scripts."""
        count = scripts.primes + more
        if count:
            end = scripts.exponent[0] if scripts.exponent else scripts.end
            self.tokens.add(TokenKind.PRIMES, "'" * count, max(end - 1, 0), max(end, 1), count)
        if scripts.exponent is not None:
            self._exponent(*scripts.exponent)
        self.scanner.at = scripts.end

    def _exponent(self, first: int, last: int) -> None:
        self.tokens.add_operator("^", max(first - 1, 0), first)
        inside = self.scanner.text[first:last]
        if inside and all(c in SUPERSCRIPTS for c in inside):
            self._superscript(first, last)
            return
        if "circ" in inside:
            help_ = r"angles are in radians: `30\pi/180`"
            raise self.scanner.error("unknown-command", "degrees are not read", first, last, help_)
        if re.fullmatch(r"\([2-9]\)", inside):
            message = f"`^{{{inside}}}` is read as a power"
            self.scanner.note(message, first, last, r"a derivative is written `\ddot{x}` or `x''`")
        self.grouped(first, last, applied=True)

    def _superscript(self, first: int, last: int) -> None:
        digits = "".join(SUPERSCRIPTS[c] for c in self.scanner.text[first:last])
        number = digits.removeprefix("-")
        if not number.isdigit():
            message, help_ = "this exponent cannot be read", "write it as `^2`"
            raise self.scanner.error("bad-exponent", message, first, last, help_)
        if number != digits:
            self.tokens.add_operator("-", first, last)
        self.tokens.add(TokenKind.NUMBER, number, first, last)

    def tail(self) -> Scripts:
        """Read what is attached to a bracket, a fraction or a number; they take no subscript."""
        scripts = self.scanner.scripts(self.scanner.at)
        if scripts.subscript is not None:
            message, help_ = "this subscript belongs to no name", r"an index belongs to a letter: `\theta_{1}`"
            raise self.scanner.error("bad-subscript", message, *scripts.subscript, help_)
        self.attach(scripts)
        return scripts

    # -- numbers and names -----------------------------------------------------------------------------------

    def number(self) -> None:
        """Read a number; `9{,}81` has a decimal comma."""
        scanner = self.scanner
        start = scanner.at
        digits = _NUMBER.match(scanner.text, start, scanner.limit)
        assert digits is not None
        integer, decimals = digits["integer"], digits["decimals"] or ""
        scanner.at = digits.end()
        exponent, places = "", 0
        scientific = self.names.scope.scalar("e") is None
        if scientific and (power := _POWER_OF_TEN.match(scanner.text, scanner.at, scanner.limit)):
            scanner.at, exponent, places = power.end(), f"e{power[1].strip('+')}{power[2]}", int(power[2])
        if scanner.looking_at("."):
            help_ = "decimal points occur in numbers only; a product is written `\\cdot`"
            raise scanner.error("bad-number", "a number has one decimal point", scanner.at, scanner.at + 1, help_)
        if len(integer) + len(decimals) > MAX_DIGITS or places > MAX_POWER_OF_TEN:
            message = f"a number may have at most {MAX_DIGITS} digits, and a power of ten up to {MAX_POWER_OF_TEN}"
            help_ = "round it, or declare a parameter instead"
            raise scanner.error("number-too-long", message, start, scanner.at, help_)
        text = f"{integer or '0'}{'.' + decimals if decimals else ''}{exponent}"
        self.tokens.add(TokenKind.NUMBER, text, start, scanner.at)
        self.tail()

    def letters(self) -> None:
        """Read the first name of a run of plain letters."""
        start = self.scanner.at
        end, name, last = self.names.piece()
        scripts = self.scanner.scripts(end) if last else Scripts(end=end)
        if name == "e" and last and scripts.exponent is not None and not self.names.is_declared("e"):
            self.exponential(start, end)
        else:
            self._name(name, start, end, scripts)

    def exponential(self, start: int, end: int) -> None:
        """Read e^x, at the exponent, or e alone."""
        scripts = self.scanner.scripts(end)
        self.tokens.add(TokenKind.NAME, "exp", start, end)
        if scripts.exponent is None:
            self.tokens.open(start, start, applied=True)
            self.tokens.add(TokenKind.NUMBER, "1", start, end)
            self.tokens.close(end, end)
        else:
            self.grouped(*scripts.exponent, applied=True, always=True)
        self.scanner.at = max(scripts.end, end)

    def greek(self, letter: str, start: int) -> None:
        """Read what is attached to a Greek letter that ends here."""
        end = self.scanner.at
        scripts = self.scanner.scripts(end)
        self._name(self.names.spelled(letter, scripts.parts), start, end, scripts)

    def braced_name(self, stem: Stem, start: int, order: int = 0) -> None:
        """Read what is attached to a name whose letter is in braces, which end here; differentiate it `order` times."""
        end = self.scanner.at
        scripts = self.scanner.scripts(end)
        if stem.parts and scripts.subscript is not None:
            message, help_ = "a second subscript", "write `_{1,2}`"
            raise self.scanner.error("double-script", message, *scripts.subscript, help_)
        parts = stem.parts + scripts.parts
        name = self.names.vector(stem, parts, start, end) if stem.vector else self.names.spelled(stem.letter, parts)
        self._name(name, start, end, scripts, order + stem.primes)

    def accented(self, order: int, start: int) -> None:
        r"""Read `\ddot{\theta}_1`, `\dot x`, or the derivative of something in braces, after the command."""
        self.scanner.skip()
        first, last = self.scanner.argument(start)
        stem = self.names.stem(first, last)
        if stem is not None:
            self.braced_name(stem, start, order)
            return
        self.grouped(first, last, always=True)
        self.tokens.add(TokenKind.PRIMES, "'" * order, start, self.scanner.at, order)
        self.tail()

    def vector_name(self, command: str, start: int) -> None:
        r"""Read `\mathbf{r}_P`, `\vec{F}`, `\hat{k}` after the command."""
        first, last = self.scanner.argument(start)
        stem = self.names.stem(first, last)
        if stem is not None:
            self.braced_name(replace(stem, vector=stem.vector if stem.vector == "hat" else command), start)
        else:
            self.grouped(first, last)
            self.tail()

    def _name(self, name: str, start: int, end: int, scripts: Scripts, more: int = 0) -> None:
        # The caret of a name includes a subscript that precedes the exponent: all of `\omega_0` in `\omega_0^2`.
        if scripts.subscript is not None and scripts.subscript[0] <= (scripts.exponent or (self.scanner.limit,))[0]:
            end = scripts.subscript[1]
        self.tokens.add_name(name, start, end)
        self.attach(scripts, more)
