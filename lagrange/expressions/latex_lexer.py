r"""LaTeX -> the tokens of the expression language, for the same parser: `\ddot{\theta}_1` is theta_1 ''.

    \frac{a}{b}             ( a / b )                   \sin^2\theta           sin ^ 2 ( theta )
    \dot x^2                x ' ^ 2                     \sqrt[3]{x}            ( x ^ ( 1 / 3 ) )
    \frac{d}{dt}(...)       diff ( ( ... ) , t )        \mathrm{e}^{-ct}       exp ( - c t )
    \mathrm{d}x             d ( x )                     \frac{\partial f}{\partial x}   diff ( f , x )

Every token has its place in the LaTeX, and no text is rewritten. Commands have the meanings of `latex_names`, and
nothing is expanded. The time is proportional to the length.

A function without brackets is applied to what follows it: numbers and constants as far as they touch, and one
coordinate or t. `\sin\omega t` is sin(omega t), `\sin\theta\dot\phi` is sin(theta) phi'. `\frac{d}{dt}` is applied to
the bracket that follows it, or else to everything up to the next sign, and is carried out, as `diff(e, t)` is.
"""

from __future__ import annotations

import re

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.expressions.characters import FRACTIONS as FRACTION_SIGNS
from lagrange.expressions.characters import GREEK, PRIMES, suggestion_for_character
from lagrange.expressions.latex_names import (
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
)
from lagrange.expressions.latex_scanner import Scanner, TextRange
from lagrange.expressions.latex_tokens import AtomReader, NameReader, TokenList
from lagrange.expressions.limits import MAX_NESTING
from lagrange.expressions.scope import Scope
from lagrange.expressions.syntax_tree import Role
from lagrange.expressions.tokens import Token, TokenKind

_SIGNS = "+-*/=,|"
_WORDS = re.compile(r"[A-Za-z0-9_ ]*")
_OF_TIME = re.compile(r"\s*(?:\(\s*t\s*\)|\\left\s*\(\s*t\s*\\right\s*\))")
_EXPONENTIAL = re.compile(r"e\s*\^|\\mathrm\s*\{\s*[ed]\s*\}")  # and a differential
_NUMERIC_FRACTION = re.compile(r"\\[tdc]?frac(?:\s*[0-9]|\s*\{[0-9]{1,9}\}){2}")

_D = r"(?:d|\\mathrm\s*\{\s*d\s*\}|\\mathrm\s+d|\\text\s*\{d\}|\{\s*\\rm\s+d\s*\}|\\rm\s+d|\\dd(?![A-Za-z]))"
_ORDER = r"(?:\s*\^\s*(?:(?P<one>[1-9])|\{\s*(?P<braced>[1-9])\s*\}))?"
_D_ABOVE = re.compile(rf"\s*{_D}{_ORDER}\s*")
_D_TIME_BELOW = re.compile(rf"\s*(?:{_D}\s*t|\\mathrm\s*\{{\s*dt\s*\}}){_ORDER}\s*")
_PARTIAL_ABOVE = re.compile(rf"\s*\\partial(?![A-Za-z]){_ORDER}\s*")
_PARTIAL = re.compile(r"\\partial(?![A-Za-z])")
_ORDER_AT_END = re.compile(rf"{_ORDER}\s*\Z")


def latex_tokens(fragment: Fragment, scope: Scope) -> tuple[list[Token], list[Diagnostic]]:
    """The tokens of a text in LaTeX, the last of kind END, and notes about surprising readings.

    Raises ProblemError at what has no meaning here.
    """
    lexer = LatexLexer(fragment, scope)
    return lexer.run(), lexer.scanner.notes


class LatexLexer:
    """One reading of one text in LaTeX: functions, fractions, derivatives, operators and commands."""

    def __init__(self, fragment: Fragment, scope: Scope) -> None:
        self.scope = scope
        self.scanner = Scanner(fragment)
        self.tokens = TokenList(self.scanner, scope)
        self.names = NameReader(self.scanner, scope)
        self.atoms = AtomReader(self.scanner, self.tokens, self.names, self.factor)
        self._depth = 0

    def run(self) -> list[Token]:
        """Read all tokens."""
        self.atoms.everything(0, len(self.scanner.text))
        end = self.tokens[-1].end if self.tokens else 0
        return [*self.tokens, Token(TokenKind.END, "", end, end)]

    def factor(self) -> None:
        """Read one factor, or one operator."""
        self._depth += 1
        if self._depth > MAX_NESTING + 1:
            message, at = f"this is nested more than {MAX_NESTING} deep", self.scanner.at
            raise self.scanner.error("nested-too-deep", message, at, at + 1, "introduce abbreviations")
        self._factor()
        self._depth -= 1

    def _factor(self) -> None:
        scanner = self.scanner
        scanner.steps += 1
        start, text = scanner.at, scanner.text
        char = text[start]
        if self._at_operator():
            self._operator(start, char)
        elif (char.isdigit() and char.isascii()) or (char == "." and text[start + 1 : start + 2].isdigit()):
            self.atoms.number()
        elif char.isascii() and char.isalpha():
            self._word_or_letters(start)
        elif char in GREEK:
            scanner.at += 1
            self.atoms.greek(GREEK[char], start)
        elif char == "{":
            self._braces(start)
        elif char in "([":
            self.atoms.bracket()
            self.atoms.tail()
        elif char in FRACTION_SIGNS:
            scanner.at += 1
            self.tokens.add(TokenKind.NUMBER, FRACTION_SIGNS[char], start, scanner.at)
            self.atoms.tail()
        elif char == "√":
            scanner.at += 1
            self.tokens.append(Token(TokenKind.NAME, "sqrt", *scanner.place(start, start + 1), tight=True))
        elif char == "\\":
            self._command(start, scanner.command())
        else:
            raise self._unexpected(char, start, start + 1)

    def _word_or_letters(self, start: int) -> None:
        """Read letters; a function may be written without its backslash."""
        end, name, _ = self.names.piece()
        if name in NAMED_FUNCTIONS and not self.names.is_declared(name):
            self.scanner.at = end
            self._function(NAMED_FUNCTIONS[name], start)
        else:
            self.atoms.letters()

    def _braces(self, start: int) -> None:
        """Read a group in braces; an empty pair is nothing."""
        end = self.scanner.group_end(start)
        self.scanner.at = end + 1
        if self.scanner.text[start + 1 : end].strip():
            self.atoms.grouped(start + 1, end)
            self.atoms.tail()

    # -- operators -------------------------------------------------------------------------------------------

    def _at_operator(self) -> str:
        """The operator at this position as plain text; empty if there is none."""
        if self.scanner.ends():
            return ""
        char, command = self.scanner.text[self.scanner.at], self.scanner.command()
        if command in OPERATORS:
            return OPERATORS[command]
        if command == "vert":
            return "|"
        return char if char in _SIGNS or char in "<>≤≥≠:;!?#@\"^_'" else ""

    def _at_factor(self) -> bool:
        return not self.atoms.stops() and not self._at_operator()

    def _operator(self, start: int, char: str) -> None:
        scanner, tokens = self.scanner, self.tokens
        command = scanner.command()
        scanner.at += 1 + len(command) if command else 1
        if command == "vert":
            tokens.add_operator("|", start, scanner.at)
        elif command == "prime" or char in PRIMES:
            first = scanner.at = start if char in PRIMES else scanner.at
            while not scanner.ends() and scanner.text[scanner.at] in PRIMES:
                scanner.at += 1
            count = scanner.at - first  # they follow neither a name nor a bracket, and the parser refuses them
            tokens.add(TokenKind.PRIMES, "'" * count, first, scanner.at, count)
        elif command:
            tokens.add_operator(OPERATORS[command], start, scanner.at)
        elif char in _SIGNS:
            if char == "=" and scanner.looking_at("="):
                scanner.at += 1
                scanner.note("`==` is read as `=`", start, scanner.at, "")
            tokens.add_operator(char, start, scanner.at)
        elif char == "^":
            tokens.add_operator("^", start, start)
        elif char in "<>≤≥≠":
            raise self._inequality(char, start)
        elif char == "_":
            message, help_ = "this subscript belongs to no name", r"an index belongs to a letter: `\theta_{1}`"
            raise scanner.error("bad-subscript", message, start, scanner.at, help_)
        else:
            raise self._unexpected(char, start, scanner.at)

    def _unexpected(self, char: str, start: int, end: int) -> ProblemError:
        message = f"`{char}` has no meaning here"
        return self.scanner.error("unexpected-character", message, start, end, suggestion_for_character(char))

    def _inequality(self, written: str, start: int) -> ProblemError:
        message, help_ = f"`{written}` is not an equation", "write an equation with `=`"
        return self.scanner.error("inequality", message, start, self.scanner.at, help_)

    # -- commands --------------------------------------------------------------------------------------------

    def _command(self, start: int, name: str) -> None:
        if self.atoms.at_bracket():
            self.atoms.bracket()
            self.atoms.tail()
            return
        self.scanner.at += 1 + len(name)
        if name == "delta" and not self.names.is_declared("delta") and self._varies():
            self._differential("delta", start)
        elif name in LETTERS:
            self.atoms.greek(LETTERS[name], start)
        elif name in FUNCTIONS:
            self._function(FUNCTIONS[name], start)
        elif name in ACCENTS:
            self.atoms.accented(ACCENTS[name], start)
        elif name in FRACTIONS:
            self._fraction(start)
        elif name == "sqrt":
            self._root(start)
        elif name in WORDS or name.rstrip("*") == "operatorname":
            self._word(start)
        elif name in VECTORS:
            self.atoms.vector_name(name, start)
        elif name == "partial":
            self._inline_partial(start)
        elif name in FRAMES:
            self.atoms.everything(*self.scanner.argument(start))
        elif name in ("abs", "norm"):
            self.tokens.add(TokenKind.NAME, name, start, self.scanner.at)
            self.atoms.grouped(*self.scanner.argument(start), applied=True, always=True)
            self.atoms.tail()
        elif is_inequality(name):
            raise self._inequality("\\" + name, start)
        else:
            raise self._unknown(start, name)

    def _unknown(self, start: int, name: str) -> ProblemError:
        if name in ("begin", "end"):
            message, help_ = f"`\\{name}` is not allowed inside an equation", "an environment has whole equations in it"
        else:
            message, help_ = f"`\\{name[:40]}` is not a known command", help_for_command(name)
        return self.scanner.error("unknown-command", message, start, self.scanner.at, help_)

    def _varies(self) -> bool:
        r"""Whether `\delta` is followed by something that it can vary, and not by a subscript."""
        at = self.scanner.at
        self.scanner.skip()
        varies = self._at_factor()
        self.scanner.at = at
        return varies

    def _word(self, start: int) -> None:
        r"""Read `\mathrm{rod}` or `\operatorname{sgn}`: one name, or a function; `\mathrm{d}x` is a differential."""
        scanner, atoms = self.scanner, self.atoms
        first, last = scanner.argument(start)
        inside = scanner.text[first:last].strip()
        if inside == "d" and not (scanner.looking_at("_") or scanner.looking_at("^")):
            if self.names.is_declared("d"):
                message = "`d` is declared, so this could be the symbol or a differential"
                raise scanner.error("not-a-differential", message, start, scanner.at, "write `d` for the symbol")
            self._differential("d", start)
        elif inside == "e":
            atoms.exponential(start, scanner.at)
        elif inside in NAMED_FUNCTIONS:
            self._function(NAMED_FUNCTIONS[inside], start)
        elif (stem := self.names.stem(first, last)) is not None:
            atoms.braced_name(stem, start)
        elif not _WORDS.fullmatch(inside) or self.names.is_product(inside):
            atoms.grouped(first, last)
            atoms.tail()
        elif " " in inside or not inside:
            message, help_ = "there are words in the equation", "leave them out, or put them beside it"
            raise scanner.error("words-in-equation", message, start, scanner.at, help_)
        else:
            self.tokens.add_name(inside, start, scanner.at)
            atoms.tail()

    # -- functions and roots ---------------------------------------------------------------------------------

    def _function(self, name: str, start: int) -> None:
        """Read the argument of a function whose name has just been read."""
        scanner, atoms = self.scanner, self.atoms
        name_end = scanner.at
        self.tokens.add(TokenKind.NAME, name, start, name_end)
        scripts = scanner.scripts(name_end)
        if scripts.subscript is not None:
            message, help_ = f"`{name}` has no subscript", r"the logarithm is `\ln`"
            raise scanner.error("bad-subscript", message, *scripts.subscript, help_)
        if scripts.exponent is not None:
            self._check_exponent(name, *scripts.exponent)
        atoms.attach(scripts)
        scanner.at = max(scanner.at, name_end)
        scanner.skip()
        if atoms.at_bracket():
            atoms.bracket(applied=True)
            atoms.tail()
        elif scanner.looking_at("{") and not self._is_number(scanner.at):
            end = scanner.group_end(scanner.at)
            atoms.grouped(scanner.at + 1, end, applied=True, always=True)
            scanner.at = end + 1
            if atoms.tail().exponent is not None:
                help_ = "put the exponent next to the function"
                self._note_reading(start, scanner.at, f"({scanner.written(start, end + 1)})^", help_)
        elif not atoms.stops() and self._at_operator() != "|":
            self._argument(name, start)

    def _check_exponent(self, name: str, first: int, last: int) -> None:
        inside = self.scanner.text[first:last].strip()
        if inside.isdigit():
            return
        help_ = rf"write `(\{name} x)^n`"
        if inside in ("-1", "⁻¹") and f"a{name}" in NAMED_FUNCTIONS:
            help_ = rf"the inverse function is `\arc{name}`, the reciprocal `1/\{name} x`"
        message = f"the exponent of `{name}` must be an integer"
        raise self.scanner.error("function-exponent", message, first, last, help_)

    def _is_number(self, at: int) -> bool:
        return self.scanner.text[at + 1 : self.scanner.group_end(at)].strip().isdigit()

    def _argument(self, name: str, start: int) -> None:
        """Read the argument of a function without brackets.

        It goes on until a coordinate or t has been read; a visible space, or something that is printed as a factor of
        its own (a function, a vector, a fraction of symbols), ends it before that.
        """
        scanner, tokens, atoms = self.scanner, self.tokens, self.atoms
        begins, moving, index = scanner.at, tokens.moving, len(tokens)
        tokens.open(begins, begins, applied=True)
        symbols, cut_short = 0, False
        while True:
            gap = scanner.skip()
            if not self._at_factor():
                break
            kind = self._kind_of_factor()
            ends = bool(symbols) or (kind == "function" and len(tokens) > index + 1)
            if symbols and tokens.moving == moving and kind == "name":
                ends = gap and not scanner.looking_at("t")
            if ends:
                cut_short = kind in ("name", "bracket") and not gap
                break
            before, first = len(tokens), scanner.at
            if kind == "bracket":
                atoms.bracket()
                atoms.tail()
            else:
                self.factor()
                if (
                    tokens.moving > moving
                    and kind == "name"
                    and _OF_TIME.match(scanner.text, scanner.at, scanner.limit)
                ):
                    atoms.bracket(applied=True)
            end = scanner.at
            symbols += kind != "number"
        if len(tokens) == index + 1:
            del tokens[index:]
            return
        tokens.close(end, end)
        last_factor = tokens[before:-1]
        scripts = any(t.kind is TokenKind.PRIMES or t.text == "^" for t in last_factor)
        time = scanner.written(first, end).strip() == "t"
        help_ = "put brackets around what belongs to it"
        if scripts or (symbols > 1 and not time):
            reading = f"{scanner.written(start, begins).strip()}({scanner.written(begins, end).strip()})"
            self._note_reading(start, end, reading, help_)
        elif cut_short or scanner.looking_at("/"):
            message = f"the argument of `{name}` ends before the `{scanner.written(scanner.at, scanner.at + 1)}`"
            scanner.note(message, start, scanner.at + 1, help_)

    def _kind_of_factor(self) -> str:
        """What comes next, so far as it matters for the end of an argument."""
        scanner = self.scanner
        char, command = scanner.text[scanner.at], scanner.command()
        if char.isdigit() or char == ".":
            return "number"
        if self.atoms.at_bracket():
            return "bracket"
        if command in FRACTIONS:
            return "number" if _NUMERIC_FRACTION.match(scanner.text, scanner.at, scanner.limit) else "apart"
        if char.isascii() and char.isalpha():
            _, name, _ = self.names.piece()
            role = self.scope.role(name)
            if role is Role.UNDECLARED and name in NAMED_FUNCTIONS:
                return "function"
            if _EXPONENTIAL.match(scanner.text, scanner.at, scanner.limit) and not self.names.is_declared("e"):
                return "apart"
            return "apart" if role in (Role.VECTOR, Role.FUNCTION) else "name"
        if command in FUNCTIONS or command in ACCENTS or command in VECTORS:
            return "apart"
        if _EXPONENTIAL.match(scanner.text, scanner.at, scanner.limit):
            return "apart"
        return "apart" if command in ("operatorname", "partial", "delta", "sqrt") else "name"

    def _note_reading(self, start: int, end: int, reading: str, help_: str) -> None:
        written = " ".join(self.scanner.written(start, end).split())
        self.scanner.note(f"`{written}` is read as `{' '.join(reading.split())}`", start, end, help_)

    def _root(self, start: int) -> None:
        r"""Read `\sqrt{x}` or `\sqrt[3]{x}` after the command."""
        scanner, tokens, atoms = self.scanner, self.tokens, self.atoms
        scanner.skip()
        if not scanner.looking_at("["):
            tokens.add(TokenKind.NAME, "sqrt", start, scanner.at)
            atoms.grouped(*scanner.argument(start), applied=True, always=True)
            atoms.tail()
            return
        end = scanner.text.find("]", scanner.at, min(scanner.at + 40, scanner.limit))
        index = scanner.text[scanner.at + 1 : end].strip() if end > 0 else ""
        if not (index.isascii() and index.isdigit()) or len(index) > 2 or int(index) == 0:
            message, help_ = "the index of a root must be a positive integer", r"write `\sqrt[3]{x}`"
            raise scanner.error("bad-root", message, start, scanner.at + 1, help_)
        place = scanner.at + 1, end
        scanner.at = end + 1
        tokens.open(start, start + 5)
        atoms.grouped(*scanner.argument(start))
        tokens.add_operator("^", *place, hidden=True)
        tokens.open(*place, applied=True)
        tokens.add(TokenKind.NUMBER, "1", *place)
        tokens.add_operator("/", *place, hidden=True)
        tokens.add(TokenKind.NUMBER, index, *place)
        tokens.close(*place)
        tokens.close(scanner.at - 1, scanner.at)
        atoms.tail()

    # -- fractions and derivatives ---------------------------------------------------------------------------

    def _fraction(self, start: int) -> None:
        r"""Read `\frac{a}{b}` or `\frac gl` after the command, and derivatives that are written so."""
        scanner, tokens = self.scanner, self.tokens
        above, below = scanner.argument(start), scanner.argument(start)
        if self._total_derivative(start, above, below) or self._partial_derivative(start, above, below):
            return
        before = tokens[-1] if tokens else None
        index = len(tokens)
        tokens.open(start, start + 1)
        self.atoms.grouped(*above)
        tokens.add_operator("/", *above, hidden=True)
        self.atoms.grouped(*below)
        tokens.close(scanner.at - 1, scanner.at)
        # `2\frac{1}{3}` adds the six tokens * ( 1 / 3 ), and might have been meant as the mixed number 2 + 1/3.
        mixed = before is not None and before.kind is TokenKind.NUMBER and len(tokens) - index == 6
        if before is not None and mixed and tokens[-2].kind is tokens[-4].kind is TokenKind.NUMBER:
            message = f"`{before.text}` in front of `{scanner.written(start, scanner.at)}` multiplies it"
            scanner.note(message, start, scanner.at, "write `+` between them for a mixed number")
        self.atoms.tail()

    def _total_derivative(self, start: int, above: TextRange, below: TextRange) -> bool:
        r"""Read a fraction as `\frac{d^n}{dt^n}`, if it is one."""
        d = _D_ABOVE.match(self.scanner.text, *above)
        by_time = _D_TIME_BELOW.fullmatch(self.scanner.text, *below)
        if d is None or by_time is None:
            return False
        order = _order(d)
        if order != _order(by_time):
            if self.names.is_declared("d"):
                return False
            raise self._orders_differ(start, r"write `\frac{d^2 x}{dt^2}`")
        self._open_derivatives(start, order)
        if d.end() < above[1]:
            self.atoms.everything(d.end(), above[1])
        else:
            self._operand(start)
        for _ in range(order):
            self.tokens.add_operator(",", *below, hidden=True)
            self.tokens.add(TokenKind.NAME, "t", *below)
            self.tokens.close(*below)
        self.tokens.moving += 1
        self.atoms.tail()
        return True

    def _partial_derivative(self, start: int, above: TextRange, below: TextRange) -> bool:
        """Read a fraction as a partial derivative, if it is one."""
        text = self.scanner.text
        partial = _PARTIAL_ABOVE.match(text, *above)
        places = [match.span() for match in _PARTIAL.finditer(text, *below)]
        if partial is None or not places or text[below[0] : places[0][0]].strip():
            return False
        if "/" in text[slice(*below)] or _PARTIAL.search(text, partial.end(), above[1]):
            return False  # a fraction of derivatives
        variables: list[TextRange] = []
        for n, (_, first) in enumerate(places):
            last = places[n + 1][0] if n + 1 < len(places) else below[1]
            order = _ORDER_AT_END.search(text, max(first, last - 12), last)
            variables += [(first, order.start() if order else last)] * (_order(order) if order else 1)
        if len(variables) != _order(partial):
            raise self._orders_differ(start, r"write `\frac{\partial^2 f}{\partial x^2}`")
        self._open_derivatives(start, len(variables))
        if partial.end() < above[1]:
            self.atoms.everything(partial.end(), above[1])
            self._at_arguments()
        else:
            self._operand(start)
        for variable in variables:
            self.tokens.add_operator(",", *variable, hidden=True)
            self.atoms.everything(*variable)
            self.tokens.close(*variable)
        self.atoms.tail()
        return True

    def _orders_differ(self, start: int, help_: str) -> ProblemError:
        message = "the orders in the numerator and the denominator differ"
        return self.scanner.error("bad-derivative", message, start, self.scanner.at, help_)

    def _open_derivatives(self, start: int, order: int) -> None:
        for _ in range(order):
            self.tokens.add(TokenKind.NAME, "diff", start, self.scanner.at)
            self.tokens.add_operator("(", start, start + 1, hidden=True)

    def _operand(self, start: int) -> None:
        """Read the operand of an operator of differentiation."""
        scanner, atoms = self.scanner, self.atoms
        end = scanner.at
        operator = scanner.written(start, end)
        scanner.skip()
        if atoms.at_bracket():
            atoms.bracket(applied=True)
            if atoms.tail().exponent is not None:
                help_ = "put brackets around the operand"
                self._note_reading(start, scanner.at, f"{operator} of the power", help_)
            return
        factors = 0
        while not atoms.stops():
            sign = self._at_operator()
            if sign and (sign not in "*/⋅⨯" or not factors):
                break
            factors += not sign
            self.factor()
            scanner.skip()
        if not factors:
            message = f"`{operator}` has nothing to differentiate"
            raise scanner.error("no-argument", message, start, end, f"write `{operator}(...)`")
        if factors > 1:
            operand = " ".join(scanner.written(end, scanner.at).split())
            message = f"`{operator}` differentiates all of `{operand}`"
            scanner.note(message, start, scanner.at, "put brackets around what it differentiates")

    def _at_arguments(self) -> None:
        """Read the point at which a derivative of an undefined function is taken: ∂f/∂X (x, y)."""
        last = self.tokens[-1]
        if last.kind is TokenKind.NAME and self.scope.role(last.text) is Role.FUNCTION:
            self.scanner.skip()
            if self.atoms.at_bracket():
                self.atoms.bracket(applied=True)

    def _inline_partial(self, start: int) -> None:
        r"""Read `\partial f / \partial x` on one line, after the first `\partial`."""
        scanner, tokens = self.scanner, self.tokens
        index = len(tokens)
        self._open_derivatives(start, 1)
        scanner.skip()
        if self._at_factor():
            self.factor()
        scanner.skip()
        self._at_arguments()
        scanner.skip()
        if scanner.looking_at("/"):
            slash = scanner.at
            scanner.at += 1
            scanner.skip()
            if scanner.command() == "partial" and len(tokens) > index + 2:
                scanner.at += len("\\partial")
                scanner.skip()
                tokens.add_operator(",", slash, slash + 1, hidden=True)
                if self._at_factor():
                    self.factor()
                    tokens.close(scanner.at - 1, scanner.at)
                    return
        message, help_ = r"`\partial` occurs in derivatives only", r"write `\frac{\partial f}{\partial x}`"
        raise scanner.error("bad-derivative", message, start, start + 8, help_)

    def _differential(self, operator: str, start: int) -> None:
        """Read d(x) or delta(x) after the operator: a name, or a bracket, follows."""
        scanner, tokens = self.scanner, self.tokens
        end = scanner.at
        scanner.skip()
        command = scanner.command()
        if not (command or self.atoms.at_bracket() or (not scanner.ends() and scanner.text[scanner.at].isalpha())):
            written = scanner.written(start, end)
            message = f"`{written}` is not followed by a variable"
            raise scanner.error("not-a-differential", message, start, end, f"write `{written} x`")
        tokens.add(TokenKind.NAME, operator, start, end)
        if self.atoms.at_bracket():
            self.atoms.bracket(applied=True)
            return
        tokens.add_operator("(", end - 1, end, hidden=True)
        self.factor()
        tokens.close(scanner.at - 1, scanner.at)


def _order(derivative: re.Match[str]) -> int:
    return int(derivative["one"] or derivative["braced"] or 1)
