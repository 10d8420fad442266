"""Text -> SymPy: the one small language of problem files and answers. No text is ever evaluated as code.

`tokens` or `latex_lexer` splits the text, `parser` builds a tree, and `meaning` evaluates the tree with the names that
`scope` declares: nothing else has a meaning. Whatever the text, reading takes a bounded time (`limits`,
`bounded_arithmetic`), and the value is real, finite and of moderate size.

Inequalities `left >= right`: the equation of their limit, and the side that they permit.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from typing import TypeAlias, TypeVar

import sympy as sp

from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError, Severity
from lagrange.core.records import record
from lagrange.core.vectors import Vector
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.limits import MAX_CHARACTERS, MAX_NAME
from lagrange.expressions.meaning import DIFFERENTIALS, TextMeaning
from lagrange.expressions.parser import Parser
from lagrange.expressions.scope import RESERVED, FunctionDeclaration, Scope
from lagrange.expressions.syntax_tree import FUNCTIONS, INVERSE_HYPERBOLIC, OPERATIONS, Call, Name, Tree, parts
from lagrange.expressions.tokens import Token, TokenKind, tokens

__all__ = [
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
    """An equation of scalars or of vectors; with `latex` it may be in LaTeX, as answers may.

    Raises ProblemError at the place that cannot be read.
    """
    return _read(fragment, scope, notes, limit, lambda reading: reading.equation(), latex)


def read_otherwise(fragment: Fragment, scope: Scope, limit: int = MAX_CHARACTERS) -> EquationRead | None:
    """An equation of an answer in the other reading of `a/b c` and `sin x^2`; None if it has no other.

    Raises ProblemError at the place that cannot be read.
    """
    return _read(fragment, scope, None, limit, lambda reading: reading.otherwise(), latex=True)


def read_value_otherwise(fragment: Fragment, scope: Scope) -> Value | None:
    """A value in the other reading of `a/b c` and `sin x^2`; None if it has no other.

    Raises ProblemError at the place that cannot be read.
    """
    return _read(fragment, scope, None, MAX_CHARACTERS, lambda reading: reading.value_otherwise(), latex=True)


def token_texts(fragment: Fragment, scope: Scope) -> list[str]:
    """The tokens of a part of an answer as texts, primes as `'`. Raises ProblemError at what has no meaning."""
    return _read(fragment, scope, None, MAX_CHARACTERS, lambda reading: reading.texts(), latex=True)


def canonical_name(text: str) -> str | None:
    """The canonical spelling of a name (`θ` is `theta`); None if it cannot be declared."""
    text = text.strip()
    if len(text) > MAX_NAME:
        return None
    try:
        name, *rest = tokens(Fragment.of(text))[0]
    except ProblemError:
        return None
    if len(rest) != 1 or name.kind is not TokenKind.NAME or name.text in RESERVED or len(name.text) > MAX_NAME:
        return None
    return name.text


def _read(
    fragment: Fragment, scope: Scope, notes: Notes, limit: int, what: Callable[[_Reading], T], latex: bool = False
) -> T:
    try:
        reading = _Reading(fragment, scope, limit, latex)
        value = what(reading)
    except RecursionError:
        message, help_ = "this nests too deeply", "introduce abbreviations"
        span = fragment.span(0, len(fragment.text))
        raise ProblemError(Diagnostic("nested-too-deep", message, span, help=help_)) from None
    if notes is not None:
        notes.extend(dict.fromkeys(reading.notes))
    return value


def _at_one_instant(read: list[Token], scope: Scope) -> list[Token]:
    """`ẋ₀`, read as x_0 with a prime, is the velocity x'_0 where that is declared and x_0 is not."""
    merged: list[Token] = []
    for token in read:
        before = merged[-1] if merged else None
        if token.kind is TokenKind.PRIMES and before is not None and before.kind is TokenKind.NAME:
            stem, _, index = before.text.rpartition("_")
            name = f"{stem}{chr(39) * token.count}_{index}"
            if stem and name in scope.scalars and before.text not in scope.names():
                merged[-1] = replace(before, text=name, end=token.end)
                continue
        merged.append(token)
    return merged


class _Reading:
    """One text and its parse."""

    def __init__(self, fragment: Fragment, scope: Scope, limit: int, latex: bool = False) -> None:
        _check_length(fragment, limit)
        if latex and is_latex(fragment):
            from lagrange.expressions.latex_lexer import (
                latex_tokens,
            )  # loaded where an answer is in LaTeX

            written, notes = latex_tokens(fragment, scope)
        else:
            written, notes = tokens(fragment, scientific=scope.scalar("e") is None)
        resolved = [replace(w, text=scope.spelling(w.text)) if w.loose else w for w in written]
        resolved = _at_one_instant(resolved, scope)
        self._scope = scope
        self._fragment, self._tokens = fragment, resolved
        self._parser = Parser(fragment, resolved, scope)
        self._meaning = TextMeaning(fragment, scope, frozenset(r.text for r in resolved if r.kind is TokenKind.NAME))
        self._surprises = [*notes, *_powers_of_ten(fragment, scope, resolved)]

    @property
    def notes(self) -> list[Diagnostic]:
        """Notes about surprising readings."""
        return [*self._surprises, *self._parser.notes, *self._meaning.report.notes]

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

    def otherwise(self) -> EquationRead | None:
        """The whole text as an equation in the other reading; None if there is none."""
        self._parser.equation()
        if not self._parser.doubts:
            return None
        self._parser = Parser(self._fragment, self._tokens, self._scope, other=True)
        return self.equation()

    def value_otherwise(self) -> Value | None:
        """The whole text as a value in the other reading; None if there is none."""
        self._parser.expression()
        if not self._parser.doubts:
            return None
        self._parser = Parser(self._fragment, self._tokens, self._scope, other=True)
        return self.value()

    def texts(self) -> list[str]:
        """The texts of the tokens; hidden brackets are omitted."""
        return [w.text for w in self._tokens if w.kind is not TokenKind.END and not w.hidden]

    def _tree(self) -> Tree:
        tree = self._parser.expression()
        self._check_names(tree)
        return tree

    def _check_names(self, *trees: Tree) -> None:
        """Report all names that are not declared, each once."""
        undeclared: dict[str, Diagnostic] = {}
        waiting = [*reversed(trees)]
        while waiting:
            tree = waiting.pop()
            inside = parts(tree)
            if (self._meaning.virtual_rotation(tree) or self._meaning.quasi_variation(tree)) is not None:
                continue
            if isinstance(tree, Call) and not self._knows_function(tree.name):
                undeclared.setdefault(tree.name + "(", self._meaning.report.undeclared(tree))
                continue
            if isinstance(tree, Name) and not self._knows(tree.text):
                undeclared.setdefault(tree.text, self._meaning.report.undeclared(tree))
            if (
                isinstance(tree, Call) and tree.name == "diff"
            ):  # f in diff(f, X) may be undefined: X is then one of its arguments
                inside = tuple(a for n, a in enumerate(inside) if n == 0 or not self._is_argument(a))
            waiting.extend(reversed(inside))
        if undeclared:
            raise ProblemError(undeclared.values())

    def _knows(self, name: str) -> bool:
        scope = self._scope
        return scope.scalar(name) is not None or scope.vector(name) is not None or name in scope.functions

    def _knows_function(self, name: str) -> bool:
        known = (FUNCTIONS, OPERATIONS, INVERSE_HYPERBOLIC, DIFFERENTIALS, self._scope.functions)
        return any(name in names for names in known)

    def _is_argument(self, tree: Tree) -> bool:
        return isinstance(tree, Name) and self._meaning.is_argument_name(tree.text)


def _check_length(fragment: Fragment, limit: int) -> None:
    length = len(fragment.text)
    if length > limit:
        message = f"an expression may have at most {limit:,} characters; this one has {length:,}"
        help_ = "write it shorter, or with abbreviations where there is a `let:`"
        raise ProblemError(Diagnostic("expression-too-long", message, fragment.span(0, 20), help=help_))


def _powers_of_ten(fragment: Fragment, scope: Scope, read: list[Token]) -> list[Diagnostic]:
    """Notes that `2e3` was read as a number, where there is a symbol e3."""
    notes = []
    for number in read:
        written = re.fullmatch(r"([0-9.]+)([eE][0-9]+)", fragment.text[number.start : number.end])
        if number.kind is TokenKind.NUMBER and written and scope.spelling(written[2]) in scope.names():
            span = fragment.span(number.start, number.end)
            message = f"`{written[0]}` is read as a number, not as `{written[1]}*{written[2]}`"
            help_ = "write `*` for the product"
            notes.append(Diagnostic("read-as", message, span, help=help_, level=Severity.NOTE))
    return notes


# Relations


_SIDES = {">=": 1, "≥": 1, "⩾": 1, "<=": -1, "≤": -1, "⩽": -1}
_SIDES |= {rf"\{name}": side for side, end in ((1, "ge"), (-1, "le")) for name in (end, f"{end}q", f"{end}qslant")}
_STRICT = {">": 1, "<": -1}
_INEQUALITY = re.compile(r"[<>]=?|[≤≥⩽⩾]|\\[gl]e(?:q(?:slant)?)?(?![A-Za-z])")


def is_inequality(fragment: Fragment) -> bool:
    """Whether a text has one of the signs of an inequality."""
    return _INEQUALITY.search(fragment.text) is not None


def limit_of(fragment: Fragment, what: str, strict: bool = False) -> tuple[Fragment, int | None]:
    """The equation at the limit of an inequality, and its side: +1 for left ≥ right, −1 for ≤; an equation has None.

    strict  whether `<` and `>` are read as `<=` and `>=`

    Raises ProblemError if there are several relations.
    """
    signs = [*_INEQUALITY.finditer(fragment.text)]
    if not signs:
        return fragment, None
    first = signs[0]
    place = fragment.span(first.start(), first.end())
    if len(signs) > 1 or "=" in fragment.text[: first.start()] + fragment.text[first.end() :]:
        help_ = "write each by itself"
        if apart := re.search(r"[<>]\s+=", fragment.text):
            help_ = f"write `{apart[0][0]}=` without a space"
        raise ProblemError(Diagnostic("inequality", f"{what} has several relations", place, help=help_))
    if first[0] in _STRICT and not strict:
        message = f"`{first[0]}` excludes contact itself"
        help_ = f"write `{first[0]}=`: while there is contact, the two sides are equal"
        raise ProblemError(Diagnostic("inequality", message, place, help=help_))
    text = f"{fragment.text[: first.start()]}{'=':<{len(first[0])}}{fragment.text[first.end() :]}"
    return replace(fragment, text=text), (_SIDES | _STRICT)[first[0]]
