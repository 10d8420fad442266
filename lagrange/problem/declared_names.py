"""The names of a problem file: what is declared, where, and which declarations have failed.

Symbols share one namespace, with the vectors that particles, bodies and frames add (`r_P`, `omega_B`, `e_r`) and the
names of reactions. Particles with bodies, constraints, forces and choices have their own. A name is kept in its
canonical spelling: `θ₁` is `theta_1`.

A name whose declaration has failed is remembered, and an expression that uses it is not examined: its errors would
follow from the one that was reported.
"""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Span
from lagrange.core.records import record
from lagrange.expressions.characters import VARIANTS
from lagrange.expressions.limits import MAX_CHARACTERS
from lagrange.expressions.reader import RESERVED
from lagrange.expressions.syntax_tree import FUNCTIONS, OPERATIONS
from lagrange.expressions.tokens import Token, TokenKind, tokens
from lagrange.problem.diagnostic_collector import Diagnostics, EnoughError
from lagrange.problem.limits import MAX_NAME_LENGTH, MAX_NAMES
from lagrange.problem.yaml.nodes import Node, Scalar, scalars

_ONE_MEANING = "give one of the two another name: a symbol means one thing in a file"
_SPELLING = "a name begins with a letter and has letters, digits and `_`"


@record
class Declaration:
    """Where a name is declared, and as what."""

    what: str
    span: Span


class DeclaredNames:
    """The symbols and vectors declared so far; `parameters` are those that ranges of coordinates may contain."""

    def __init__(self, diagnostics: Diagnostics) -> None:
        self.diagnostics = diagnostics
        self.parameters: tuple[sp.Symbol, ...] = ()
        self.declared: dict[str, Declaration] = {}
        self._failed: set[str] = set()

    def declare(self, scalar: Scalar, what: str) -> str | None:
        """The canonical spelling of a new symbol, or None where it cannot be one (reported)."""
        name = self.symbol(scalar, what)
        return name if name is not None and self.add(name, what, scalar.span) else None

    def symbol(self, scalar: Scalar, what: str) -> str | None:
        """The canonical spelling of what may be a symbol, or None where it cannot be one (reported)."""
        name = self.spelled(scalar, what)
        if name in RESERVED:
            message = f"`{scalar.text}` cannot be the name of {what}: it is {_predefined(name)}"
            self.diagnostics.report(Diagnostic("reserved-name", message, scalar.span, help="choose another name"))
            return None
        return name

    def add(self, name: str, what: str, span: Span) -> bool:
        """Declares a name of good spelling; False where it is declared already (reported).

        Raises EnoughError where the file declares too many names (reported).
        """
        if len(self.declared) >= MAX_NAMES:
            message = f"a problem may declare {MAX_NAMES:,} names"
            self.diagnostics.report(Diagnostic("too-many-names", message, span, help="is this the file you meant?"))
            raise EnoughError
        known = self.declared.get(name)
        if known is None:
            self.declared[name] = Declaration(what, span)
            return True
        if known.what != what:
            self.fail(name)
        first, second = sorted((known, Declaration(what, span)), key=lambda d: d.span.start)
        message = f"`{name}` is {first.what} and {second.what}" if known.what != what else f"`{name}` is declared twice"
        help_ = f"`{name}` always is {what}: rename one of the two" if name.startswith("r_") else _ONE_MEANING
        self.diagnostics.report(Diagnostic("declared-twice", message, second.span, _first_on(first.span), help_))
        return False

    def spelled(self, scalar: Scalar, what: str) -> str | None:
        """The canonical spelling of a name, or None where it cannot be one (reported)."""
        read = _tokens(scalar.text)
        if len(read) != 1 or read[0].kind is not TokenKind.NAME:
            message, help_ = _misspelling(scalar.text, read, what)
        elif len(read[0].text) > MAX_NAME_LENGTH:
            message = f"a name may have {MAX_NAME_LENGTH} characters, and this one has {len(read[0].text)}"
            help_ = "put the explanation into `meaning`"
        else:
            return read[0].text
        self.fail_all(scalar)
        self.fail(scalar.text)
        self.diagnostics.report(Diagnostic("bad-name", message, scalar.span, help=help_))
        return None

    def fail(self, *names: str) -> None:
        """Remembers names whose declaration has failed."""
        self._failed.update(names)

    def fail_all(self, node: Node) -> None:
        """Remembers everything that looks like a name in a part of the file that could not be read."""
        for scalar in scalars(node):
            self._failed.update(names_in(scalar.text))

    def has_failed(self, name: str) -> bool:
        """Whether the declaration of a name, or of a text that is no name, has failed."""
        return name in self._failed

    def uses_failed(self, text: str) -> bool:
        """Whether a text uses a name whose declaration has failed."""
        return not self._failed.isdisjoint(names_in(text)) if self._failed else False


class Namespace:
    """Names that are not symbols: particles and bodies, constraints, forces, choices. Maps each to what it is."""

    def __init__(self, names: DeclaredNames) -> None:
        self.names = names
        self._declared: dict[str, Declaration] = {}

    def declare(self, scalar: Scalar, what: str) -> str | None:
        """The canonical spelling of a new name, or None where it cannot be one (reported)."""
        name = self.names.spelled(scalar, what)
        if name is None:
            return None
        known = self._declared.setdefault(name, Declaration(what, scalar.span))
        if known.span is scalar.span:
            return name
        message = f"`{name}` is {known.what} and {what}" if known.what != what else f"`{name}` is declared twice"
        help_ = "give one of the two another name"
        self.names.diagnostics.report(Diagnostic("declared-twice", message, scalar.span, _first_on(known.span), help_))
        return None

    def reserve(self, name: str, what: str, span: Span) -> None:
        """Takes a name, and for the component C.x of a vector equation the name C."""
        self._declared.setdefault(name.partition(".")[0], Declaration(what, span))

    def known(self) -> tuple[str, ...]:
        """The names, whether or not what they name could be read."""
        return tuple(self._declared)


def canonical(text: str, known: Collection[str] = ()) -> str:
    """The spelling in which a name is known, or would be declared; the text itself where it cannot be a name."""
    read = _tokens(text)
    if len(read) != 1 or read[0].kind is not TokenKind.NAME:
        return text
    return next((spelling for spelling in _spellings(read[0]) if spelling in known), read[0].text)


def names_in(text: str) -> tuple[str, ...]:
    """The names in a text, in their order and in each spelling that they may have; none where it cannot be read."""
    return tuple(spelling for token in _tokens(text) if token.kind is TokenKind.NAME for spelling in _spellings(token))


def _spellings(token: Token) -> tuple[str, ...]:
    """What a name may be declared as: θ₁ as theta_1 or theta1, ϑ as vartheta or theta."""
    if not token.loose:
        return (token.text,)
    stem, _, index = token.text.rpartition("_")
    stem, index = (stem, index) if stem else (index, "")
    letters = (stem, VARIANTS[stem]) if stem in VARIANTS else (stem,)
    return tuple(s for letter in letters for s in ((f"{letter}_{index}", f"{letter}{index}") if index else (letter,)))


def derivatives_in(text: str) -> tuple[tuple[str, int], ...]:
    """The names in a text, each with how often it may be differentiated there."""
    read = _tokens(text)
    following = [*read[1:], None]
    everywhere = min(2, sum(token.text in ("d", "delta", "diff") for token in read))
    return tuple(
        (token.text, everywhere + (after.count if after is not None and after.kind is TokenKind.PRIMES else 0))
        for token, after in zip(read, following, strict=False)
        if token.kind is TokenKind.NAME
    )


def _tokens(text: str) -> list[Token]:
    """The tokens of a text without the last, which marks its end; none where it cannot be read or is too long."""
    if len(text) > MAX_CHARACTERS:
        return []
    try:
        return tokens(Fragment.of(text))[0][:-1]
    except ProblemError:
        return []


def _first_on(span: Span) -> str:
    line, _ = span.source.position(span.start)
    return f"first on line {line}"


def _misspelling(text: str, read: list[Token], what: str) -> tuple[str, str]:
    if not text.strip():
        return f"the name of {what} is missing", _SPELLING
    kinds = [token.kind for token in read]
    if "=" in text:
        return f"`{text}` has no name", "every entry is `name: ...`, and a comma begins the next one"
    if len(read) > 1 and set(kinds) == {TokenKind.NAME}:
        listed = ", ".join(token.text for token in read)
        return f"`{text}` is not one name", f"several names are separated by commas: `[{listed}]`"
    if kinds == [TokenKind.NAME, TokenKind.PRIMES]:
        help_ = f"declare `{read[0].text}`; its derivatives need no declaration"
        return f"`{text}` cannot be the name of {what}", help_
    return f"`{text}` cannot be the name of {what}", _SPELLING


def _predefined(name: str) -> str:
    if name in FUNCTIONS or name in OPERATIONS:
        return "a function of the language"
    return {"t": "time", "pi": "the number π"}.get(name, "a unit vector")
