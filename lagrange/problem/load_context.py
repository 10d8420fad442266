"""The context in which a problem file is read: what is declared so far, and how its expressions are read.

Every expression of a file goes through here: it is read in the scope of what is declared before it, and checked for
quantities that are not allowed at its place. An expression that uses a name whose declaration has failed is skipped
without a message.

What a particle or body is called in sentences: the name of the file, and the words that the file gives for it.

A file names a particle by a letter or a short word, from which its symbols are formed (P1: r_P1, T_P1). `name:` gives
the words for a sentence ("upper particle"). They travel with the name, so that whatever has the one has the other; in
every other respect the name is an ordinary text.

The names of a problem file: what is declared, where, and which declarations have failed.

Symbols share one namespace, with the vectors that particles, bodies and frames add (`r_P`, `omega_B`, `e_r`) and the
names of reactions. Particles with bodies, constraints, forces and choices have their own. A name is kept in its
canonical spelling: `θ₁` is `theta_1`.

A name whose declaration has failed is remembered, and an expression that uses it is not examined: its errors would
follow from the one that was reported.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import TypeVar

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity, Span
from lagrange.core.expression_size import Sizes
from lagrange.core.records import record
from lagrange.core.symbols import base
from lagrange.core.units import split_number, unit_of
from lagrange.core.vectors import Vector
from lagrange.expressions.bounded_arithmetic import WorkBudget
from lagrange.expressions.characters import VARIANTS
from lagrange.expressions.limits import MAX_CHARACTERS
from lagrange.expressions.reader import EquationRead, Value, read_equation, read_scalar, read_value, read_vector
from lagrange.expressions.scope import RESERVED, UNITS, Scope
from lagrange.expressions.syntax_tree import FUNCTIONS, OPERATIONS
from lagrange.expressions.tokens import Token, TokenKind, tokens
from lagrange.problem.diagnostic_collector import Diagnostics, EnoughError
from lagrange.problem.limits import MAX_NAME_LENGTH, MAX_NAMES, MAX_WRITTEN_OUT, MOST_REDUCED, MOST_TESTED
from lagrange.problem.sections import (
    ANYTHING,
    POSITION,
    Allowed,
    AllowedQuantity,
    first_refused,
    items_of,
    scalar_of,
    wrong_kind,
)
from lagrange.problem.yaml.nodes import ListNode, Node, Scalar, ScalarText, scalars

T = TypeVar("T", bound=sp.Expr | Vector | EquationRead)
FragmentReader = Callable[[Fragment, Scope, list[Diagnostic]], T]


class LoadContext:
    """The state of reading a file: what has been declared so far.

    things    the names of particles and bodies; `bodies` are those of bodies only
    called    the names of those for which the file has words, with the words
    points    their positions, by name; None if one could not be read
    shapes    their shapes, still to be read
    values    the numbers that the file gives to parameters
    without_inertia  the bodies with a mass and without a moment of inertia
    """

    def __init__(self, diagnostics: Diagnostics) -> None:
        self.diagnostics = diagnostics
        self.names = DeclaredNames(diagnostics)
        self.things = Namespace(self.names)
        self.constraints = Namespace(self.names)
        self.forces = Namespace(self.names)
        self.choices = Namespace(self.names)
        self.scope = Scope()
        self.budget = WorkBudget()
        self.unknowns: tuple[sp.Symbol, ...] = ()
        self.values: dict[sp.Symbol, sp.Expr] = {}
        self.called: dict[str, SpokenName] = {}
        self.points: dict[str, Vector | None] = {}
        self.shapes: dict[str, Node] = {}
        self.without_inertia: dict[str, Span] = {}
        self.bodies: list[str] = []
        self._tested = 0
        self._reduced = 0
        self._written_out = 0
        self._sizes: dict[str, int] = {}

    def scalar(self, node: Node, what: str, allowed: Allowed, scope: Scope | None = None) -> sp.Expr:
        """A scalar expression. Raises ProblemError if it cannot be read, or a quantity in it is not allowed."""
        fragment = _text(node, what)
        value = self._read(read_scalar, fragment, scope)
        self._check(value, fragment, what, allowed, scope)
        return value

    def vector(self, node: Node, what: str, allowed: Allowed = POSITION) -> Vector:
        """A vector: one expression, or a list of components. Raises as `scalar`."""
        if isinstance(node, ListNode):
            return self._components(node, what, allowed)
        fragment = _text(node, what)
        value = self._read(read_vector, fragment)
        self._check(value, fragment, what, allowed)
        return value

    def value(self, node: Node, what: str) -> Value:
        """A scalar or a vector. Raises as `scalar`."""
        if isinstance(node, ListNode):
            return self._components(node, what, ANYTHING)
        return self._read(read_value, _text(node, what))

    def equation(self, fragment: Fragment, scope: Scope | None = None) -> EquationRead:
        """An equation. Raises as `scalar`."""
        return self._read(read_equation, fragment, scope)

    def _components(self, node: ListNode, what: str, allowed: Allowed) -> Vector:
        items = items_of(node, what, "[x, y]")
        if len(items) not in (2, 3):
            message = f"{what} has {len(items)} component{'s' if len(items) != 1 else ''}"
            raise ProblemError(wrong_kind(node, message, "give two or three"))
        parts = [self.diagnostics.attempt(lambda i=i: self.scalar(i, what, allowed)) for i in items]  # type: ignore[misc]
        if None in parts:
            raise ProblemError(())
        x, y, z = (p if p is not None else sp.S.Zero for p in (*parts, sp.S.Zero)[:3])
        return Vector((x, y, z))

    def is_known(self, name: str) -> bool:
        """Whether a name may be used in an expression, or could if its declaration had not failed."""
        return self.names.has_failed(name) or name in self.scope.names() or name in UNITS

    def is_zero(self, expression: sp.Expr) -> bool | None:
        """Whether an expression is identically zero; None where testing it would take too long.

        Raises DivisionByZeroError if it divides by what is identically zero.
        """
        length = expanded_size(expression)
        self._tested += length
        return is_zero(expression) if length <= MOST_TESTED and self._tested <= 5 * MOST_TESTED else None

    def may_reduce(self, expression: sp.Expr) -> bool:
        """Whether a constraint is small enough to be reduced, after those that already were."""
        length = expanded_size(expression)
        self._reduced += length
        return length <= MOST_REDUCED and self._reduced <= 10 * MOST_REDUCED

    # -- scope -------------------------------------------------------------------------------------------------------

    def add_scalars(self, more: Mapping[str, sp.Expr]) -> None:
        """Adds scalars to the scope."""
        self.scope = replace(self.scope, scalars={**self.scope.scalars, **more})
        self._sizes.update({name: expanded_size(value) for name, value in more.items() if value.args})

    def add_vectors(self, more: Mapping[str, Vector]) -> None:
        """Adds vectors to the scope, apart from those whose names symbols have."""
        more = {name: vector for name, vector in more.items() if not self.names.is_symbol(name)}
        self.scope = replace(self.scope, vectors={**self.scope.vectors, **more})
        self._sizes.update({name: sum(expanded_size(c) for c in v.components) for name, v in more.items()})

    # -- reading -----------------------------------------------------------------------------------------------------

    def _read(self, reader: FragmentReader[T], fragment: Fragment, scope: Scope | None = None) -> T:
        notes: list[Diagnostic] = []
        value = self.read_quietly(reader, fragment, scope or self.scope, notes)
        self.diagnostics.report_all(notes)
        return value

    def read_quietly(self, reader: FragmentReader[T], fragment: Fragment, scope: Scope, notes: list[Diagnostic]) -> T:
        """The text as a reader of expressions understands it; remarks on the reading are appended to `notes`.

        Raises ProblemError; without a diagnostic where the declaration of a name has failed, or the work budget is
        used up.
        """
        if self.names.uses_failed(fragment.text) or self.budget.left < 0:
            raise ProblemError(())
        self.diagnostics.report_all(_halved_primes(fragment))
        self._charge(fragment)
        try:
            return reader(fragment, replace(scope, budget=self.budget), notes)
        except ProblemError as error:
            raise _with_advice_on_units(error, fragment) from None

    def _charge(self, fragment: Fragment) -> None:
        """Counts the sizes of abbreviations wherever they are used; a derivative is about four times as large."""
        if not self._sizes:
            return
        if self._written_out > MAX_WRITTEN_OUT:
            raise ProblemError(())  # it has been reported
        self._written_out += sum(self._sizes.get(name, 0) * 4**order for name, order in derivatives_in(fragment.text))
        if self._written_out > MAX_WRITTEN_OUT:
            message = "the abbreviations and positions of this file, written out where they are used, are too large"
            help_ = "use simpler ones"
            span = fragment.span(0, len(fragment.text))
            raise ProblemError(Diagnostic("expression-too-large", message, span, help=help_))

    def _check(
        self, value: sp.Expr | Vector, fragment: Fragment, what: str, allowed: Allowed, scope: Scope | None = None
    ) -> None:
        """Raises ProblemError if an expression contains a quantity that is not allowed."""
        slots = (scope or self.scope).slots
        for part in value.components if isinstance(value, Vector) else (value,):
            refused = first_refused(part, allowed, slots, self.unknowns)
            if refused is not None:
                raise ProblemError(_refusal(*refused, what, fragment, allowed))

    def check(self, equation: EquationRead, fragment: Fragment, what: str, allowed: Allowed) -> None:
        """Refuses quantities that do not belong into an equation."""
        for side in (equation.lhs, equation.rhs):
            self._check(side, fragment, what, allowed)


def _with_advice_on_units(error: ProblemError, fragment: Fragment) -> ProblemError:
    """The error; of `0.6 m` in an expression, where m is no name, it says where numbers with units belong."""
    parts = split_number(fragment.text)
    if {d.code for d in error.diagnostics} != {"unknown-symbol"}:
        return error
    is_measured = parts is not None and unit_of(parts[1]) is not None
    measured = fragment.text if is_measured else _number_with_unit(error, fragment)
    if not measured:
        return error
    help_ = f"a number with its unit is the `value` of a parameter: `parameters: {{a: {{value: {measured}}}}}`"
    return ProblemError([replace(d, help=help_) for d in error.diagnostics[:1]])


def _number_with_unit(error: ProblemError, fragment: Fragment) -> str:
    """`4 ft` of `l*cos(beta) = 4 ft`, where `ft` is not declared; empty if it is no unit after a number."""
    names = {re.split("`", d.message)[1] for d in error.diagnostics[:1] if d.message.startswith("`")}
    found = re.search(r"(?<![\w.])\d+(?:\.\d+)?\s*([A-Za-z°]+)(?![\w'(])", fragment.text)
    return found[0] if found and found[1] in names and unit_of(found[1]) is not None else ""


def _text(node: Node, what: str) -> Fragment:
    """The text of an expression."""
    if isinstance(node, Scalar):
        return scalar_of(node, what).fragment
    raise ProblemError(wrong_kind(node, f"{what} is an expression", "write it as one text, in quotes if it has commas"))


def _refusal(symbol: sp.Symbol, kind: AllowedQuantity, what: str, fragment: Fragment, allowed: Allowed) -> Diagnostic:
    named = f"`{symbol}`" if kind is AllowedQuantity.TIME else f"{kind} `{symbol}`"
    place = place_of_symbol(symbol, fragment)
    if allowed.code == "not-constant":
        help_ = allowed.help
        if kind is AllowedQuantity.UNKNOWN:
            help_ = f"declare `{symbol}` under `parameters:`; conditions may be solved for it in the answers"
        return Diagnostic(allowed.code, f"{what} must be constant, but {named} varies", place, help=help_)
    return Diagnostic(allowed.code, f"{what} contains {named}", place, help=allowed.help)


def _halved_primes(fragment: Fragment) -> list[Diagnostic]:
    """`'x'' = 0'`: in single quotes YAML takes two apostrophes for one. Four that become two are what was meant."""
    if not isinstance(fragment, ScalarText) or fragment.style != "'" or len(fragment.text) > MAX_CHARACTERS:
        return []
    try:
        primes = [token for token in tokens(fragment)[0] if token.kind is TokenKind.PRIMES]
    except ProblemError:
        return []
    if not primes or any(token.count > 1 for token in primes):
        return []
    message = "YAML takes two apostrophes for one in single quotes: this is a first derivative"
    span = fragment.span(primes[0].start, primes[0].end)
    help_ = "put the value in double quotes, where primes are read as they are written"
    return [Diagnostic("read-as", message, span, help=help_, level=Severity.NOTE)]


def place_of_symbol(symbol: sp.Symbol, fragment: Fragment) -> Span:
    """The place of a symbol with its primes in a text; the whole text where an abbreviation contains the symbol."""
    try:
        read, _ = tokens(fragment)
    except ProblemError:
        return fragment.whole
    primes = len(symbol.name) - len(base(symbol).name)
    for token, after in pairwise(read):
        if token.kind is TokenKind.NAME and token.text == base(symbol).name:
            primed = after.count if after.kind is TokenKind.PRIMES else 0
            if primed == primes:
                return fragment.span(token.start, after.end if primed else token.end)
    return fragment.span(0, len(fragment.text))


def expanded_size(expression: sp.Expr) -> int:
    """The number of parts of an expression with everything written out."""
    return Sizes().of(expression).size


# Names in sentences


class SpokenName(str):
    """The name of a particle or body, with the words for it; a plain text is a name without any."""

    words: str

    def __new__(cls, name: str, words: str = "") -> SpokenName:
        """The name with its words."""
        called = super().__new__(cls, name)
        called.words = words
        return called


# Declared names


_ONE_MEANING = "give one of the two another name: a symbol means one thing in a file"
_SYMBOLS = ("a parameter", "a coordinate")
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
        """The canonical spelling of a new symbol, or None if it cannot be one (reported)."""
        name = self.symbol(scalar, what)
        return name if name is not None and self.add(name, what, scalar.span) else None

    def symbol(self, scalar: Scalar, what: str) -> str | None:
        """The canonical spelling of what may be a symbol, or None if it cannot be one (reported)."""
        name = self.spelled(scalar, what)
        if name in RESERVED:
            message = f"`{scalar.text}` cannot be the name of {what}: it is {_predefined(name)}"
            self.diagnostics.report(Diagnostic("reserved-name", message, scalar.span, help="choose another name"))
            return None
        return name

    def add(self, name: str, what: str, span: Span) -> bool:
        """Declares a name of good spelling; False if it is declared already (reported).

        Raises EnoughError if the file declares too many names (reported).
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

    def is_symbol(self, name: str) -> bool:
        """Whether a name is that of a parameter or coordinate of the file."""
        return name in self.declared and self.declared[name].what in _SYMBOLS

    def report_symbol(self, name: str, vector: str, span: Span) -> None:
        """Notes that a name is that of a symbol and not of a vector: the radius r_A of a gear A, its first omega_A."""
        message = f"`{name}` is {self.declared[name].what} here, not {vector}"
        help_ = "give the symbol another name where the vector is needed"
        self.diagnostics.report(Diagnostic("read-as", message, span, help=help_, level=Severity.NOTE))

    def spelled(self, scalar: Scalar, what: str) -> str | None:
        """The canonical spelling of a name, or None if it cannot be one (reported)."""
        read = _tokens(scalar.text)
        if len(read) != 1 or read[0].kind is not TokenKind.NAME:
            message, help_ = _misspelling(scalar.text, read, what)
        elif len(read[0].text) > MAX_NAME_LENGTH:
            message = f"a name may have at most {MAX_NAME_LENGTH} characters; this one has {len(read[0].text)}"
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
        """The canonical spelling of a new name, or None if it cannot be one (reported)."""
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
    """The names in a text, in their order and in each spelling that they may have; none if it cannot be read."""
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
    """The tokens of a text without the last, which marks its end; none if it cannot be read or is too long."""
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
        words = [token.text for token in read]
        if what in ("a parameter", "a coordinate"):
            return f"`{text}` is not one name", f"several names are separated by commas: `[{', '.join(words)}]`"
        return f"`{text}` is not one name", f"write `{'_'.join(words)}`"
    if kinds == [TokenKind.NAME, TokenKind.PRIMES]:
        help_ = f"declare `{read[0].text}`; its derivatives need no declaration"
        return f"`{text}` cannot be the name of {what}", help_
    return f"`{text}` cannot be the name of {what}", _SPELLING


def _predefined(name: str) -> str:
    if name in FUNCTIONS or name in OPERATIONS:
        return "a function of the language"
    return {"t": "time", "pi": "the number π"}.get(name, "a unit vector")
