"""Text -> SymPy: the one small language of problem files and answers. No text is ever evaluated as code.

`tokens` cuts the text, `syntax` builds a tree, and `meaning` gives the tree its meaning with the names that
`scope` declares: nothing else has one. Whatever the text, reading takes a bounded time (`bounded`), and what
comes out is real, finite and of moderate size.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias, TypeVar

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, Level, ProblemError
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.lexicon import FUNCTIONS, OPERATIONS
from lagrange.expressions.meaning import DIFFERENTIALS
from lagrange.expressions.scope import RESERVED, FunctionDeclaration, Scope
from lagrange.expressions.syntax import Parser
from lagrange.expressions.tokens import Kind, Token, tokens
from lagrange.expressions.trees import Call, Name, Tree, parts
from lagrange.expressions.vector_meaning import Meaning

__all__ = [
    "MAX_ANSWER_CHARACTERS",
    "MAX_CHARACTERS",
    "RESERVED",
    "EquationRead",
    "FunctionDeclaration",
    "Scope",
    "Value",
    "canonical_name",
    "read_equation",
    "read_scalar",
    "read_value",
    "read_vector",
]

MAX_CHARACTERS = 10_000
MAX_ANSWER_CHARACTERS = 2_000
MAX_NAME = 60

Value: TypeAlias = "sp.Expr | Vector"
Notes: TypeAlias = "list[Diagnostic] | None"
T = TypeVar("T")


@record
class EquationRead:
    """Both sides of an equation: two scalars or two vectors."""

    lhs: Value
    rhs: Value


def read_scalar(fragment: Fragment, scope: Scope, notes: Notes = None, limit: int = MAX_CHARACTERS) -> sp.Expr:
    """A scalar expression.

    Raises ProblemError at the place that cannot be read; surprising readings go to `notes`.
    """
    return _read(fragment, scope, notes, limit, lambda reading: reading.scalar())


def read_vector(fragment: Fragment, scope: Scope, notes: Notes = None, limit: int = MAX_CHARACTERS) -> Vector:
    """A vector expression. Raises ProblemError at the place that cannot be read."""
    return _read(fragment, scope, notes, limit, lambda reading: reading.vector())


def read_value(fragment: Fragment, scope: Scope, notes: Notes = None, latex: bool = False) -> Value:
    """A scalar or a vector, whichever it is. Raises ProblemError at the place that cannot be read."""
    return _read(fragment, scope, notes, MAX_CHARACTERS, lambda reading: reading.value(), latex)


def read_equation(
    fragment: Fragment, scope: Scope, notes: Notes = None, limit: int = MAX_CHARACTERS, latex: bool = False
) -> EquationRead:
    """An equation of scalars or of vectors; `latex`: it may be in LaTeX, as answers may.

    Raises ProblemError at the place that cannot be read.
    """
    return _read(fragment, scope, notes, limit, lambda reading: reading.equation(), latex)


def canonical_name(text: str) -> str | None:
    """The spelling of a name that a file declares (`θ` is `theta`); None where it cannot be one."""
    text = text.strip()
    if len(text) > MAX_NAME:
        return None
    try:
        found, _ = tokens(Fragment.of(text))
    except ProblemError:
        return None
    name = found[0]
    if len(found) != 2 or name.kind is not Kind.NAME or name.text in RESERVED or len(name.text) > MAX_NAME:
        return None
    return name.text


def _read(
    fragment: Fragment, scope: Scope, notes: Notes, limit: int, what: Callable[[_Reading], T], latex: bool = False
) -> T:
    try:
        reading = _Reading(fragment, scope, limit, latex)
        value = what(reading)
    except RecursionError:
        message, help_ = "this nests too deeply to be read here", "introduce abbreviations"
        span = fragment.span(0, len(fragment.text))
        raise ProblemError(Diagnostic("nested-too-deep", message, span, help=help_)) from None
    if notes is not None:
        notes.extend(dict.fromkeys(reading.notes))
    return value


class _Reading:
    """One text being read."""

    def __init__(self, fragment: Fragment, scope: Scope, limit: int, latex: bool = False) -> None:
        _check_length(fragment, limit)
        if latex and is_latex(fragment):
            from lagrange.expressions.latex_input import latex_tokens  # many tables, wanted seldom

            found, notes = latex_tokens(fragment, scope)
        else:
            found, notes = tokens(fragment, scientific=scope.scalar("e") is None)
        found = [replace(f, text=scope.spelling(f.text)) if f.loose else f for f in found]
        self._scope = scope
        self._parser = Parser(fragment, found, scope)
        self._meaning = Meaning(fragment, scope, frozenset(f.text for f in found if f.kind is Kind.NAME))
        self._surprises = [*notes, *_powers_of_ten(fragment, scope, found)]

    @property
    def notes(self) -> list[Diagnostic]:
        """What could surprise in this reading."""
        return [*self._surprises, *self._parser.notes, *self._meaning.notes]

    def scalar(self) -> sp.Expr:
        """The whole text as a scalar."""
        return self._meaning.scalar(self._tree())

    def vector(self) -> Vector:
        """The whole text as a vector."""
        return self._meaning.vector(self._tree())

    def value(self) -> Value:
        """The whole text as a vector, if it is one, or as a scalar."""
        tree = self._tree()
        return self._meaning.vector(tree) if self._meaning.is_vector(tree) else self._meaning.scalar(tree)

    def equation(self) -> EquationRead:
        """The whole text as an equation."""
        left, right = self._parser.equation()
        self._check_names(left, right)
        if self._meaning.is_vector(left) or self._meaning.is_vector(right):
            return EquationRead(self._meaning.vector(left), self._meaning.vector(right))
        return EquationRead(self._meaning.scalar(left), self._meaning.scalar(right))

    def _tree(self) -> Tree:
        tree = self._parser.expression()
        self._check_names(tree)
        return tree

    def _check_names(self, *trees: Tree) -> None:
        """Finds all names that nobody declared, each once."""
        found: dict[str, Diagnostic] = {}
        waiting = [*reversed(trees)]
        while waiting:
            tree = waiting.pop()
            inside = parts(tree)
            if (self._meaning.virtual_rotation(tree) or self._meaning.quasi_variation(tree)) is not None:
                continue
            if isinstance(tree, Call) and not self._knows_function(tree.name):
                found.setdefault(tree.name + "(", self._meaning.undeclared(tree))
                continue
            if isinstance(tree, Name) and not self._knows(tree.text):
                found.setdefault(tree.text, self._meaning.undeclared(tree))
            if isinstance(tree, Call) and tree.name == "diff":  # its second argument may be one of a function
                inside = tuple(a for n, a in enumerate(inside) if n == 0 or not self._is_argument(a))
            waiting.extend(reversed(inside))
        if found:
            raise ProblemError(found.values())

    def _knows(self, name: str) -> bool:
        scope = self._scope
        return scope.scalar(name) is not None or scope.vector(name) is not None or name in scope.functions

    def _knows_function(self, name: str) -> bool:
        return name in FUNCTIONS or name in OPERATIONS or name in DIFFERENTIALS or name in self._scope.functions

    def _is_argument(self, tree: Tree) -> bool:
        return isinstance(tree, Name) and self._meaning.is_argument_name(tree.text)


def _check_length(fragment: Fragment, limit: int) -> None:
    length = len(fragment.text)
    if length > limit:
        message = f"an expression may have {limit:,} characters, and this one has {length:,}"
        help_ = "write it shorter, or with abbreviations where there is a `let:`"
        raise ProblemError(Diagnostic("expression-too-long", message, fragment.span(0, 20), help=help_))


def _powers_of_ten(fragment: Fragment, scope: Scope, found: list[Token]) -> list[Diagnostic]:
    """Says that `2e3` was read as a number, where a symbol is called e3."""
    notes = []
    for number in found:
        written = re.fullmatch(r"([0-9.]+)([eE][0-9]+)", fragment.text[number.start : number.end])
        if number.kind is Kind.NUMBER and written and scope.spelling(written[2]) in scope.names():
            span = fragment.span(number.start, number.end)
            message = f"`{written[0]}` is read as a number, not as `{written[1]}*{written[2]}`"
            help_ = "write `*` for the product"
            notes.append(Diagnostic("read-as", message, span, help=help_, level=Level.NOTE))
    return notes
