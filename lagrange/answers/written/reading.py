"""One equation of an answer, or one side of it, read in whatever notation it is written."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import TypeVar

import sympy as sp

from lagrange.answers.readings import GivenEquation, Reading, read_answer
from lagrange.answers.written.notation.latex import rewritten_latex
from lagrange.answers.written.notation.plain import rewritten
from lagrange.core.diagnostics import Diagnostic, Fragment, ProblemError
from lagrange.core.vectors import Vector
from lagrange.expressions.edits import Draft, closings
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.reader import Scope, read_otherwise

T = TypeVar("T")


def read_as_written(
    fragment: Fragment, scope: Scope, text: str = "", rounded: Mapping[str, sp.Expr] | None = None
) -> Reading:
    """One equation of an answer in whatever notation it is; if none can be read, the error of the first.

    rounded  the names that are defined with decimals, in which these are symbols
    """
    first: Reading | None = None
    for candidate in _notations(fragment, scope):
        reading = read_answer(candidate, scope)
        if reading.error is None:
            shown = replace(reading, text=text or fragment.text.strip())
            if rounded and not isinstance(candidate, GivenEquation):
                wider = replace(scope, scalars={**scope.scalars, **rounded}, decimals="")
                shown = replace(shown, source=(candidate, wider))
            return replace(shown, other=_other(candidate, scope, shown))
        if first is None or _errors(reading) < _errors(first):
            first = reading
    assert first is not None
    return replace(first, text=text or fragment.text.strip())


def _errors(reading: Reading) -> tuple[bool, int]:
    """How far an equation is from being read: undeclared names may still be defined elsewhere."""
    errors = reading.error.diagnostics if reading.error else ()
    return any(e.code != "unknown-symbol" for e in errors), len(errors)


def _notations(fragment: Fragment, scope: Scope) -> Iterator[Fragment]:
    """The text in the notations in which it may be, each made and tried only if the one before it cannot be read."""
    if isinstance(fragment, GivenEquation) or len(fragment.text) > MAX_ANSWER_CHARACTERS:
        yield fragment
    elif is_latex(fragment):
        yield _rewritten(fragment, scope, rewritten_latex)
        if "cancel" in fragment.text:
            yield rewritten_latex(fragment, scope, keep_cancelled=True)
        yield fragment
    else:
        yield fragment
        in_language = _rewritten(fragment, scope, rewritten)
        if in_language is not fragment:
            yield in_language
        if re.search(r"[_^]\{", fragment.text):
            yield rewritten_latex(in_language, scope)


def _rewritten(fragment: Fragment, scope: Scope, rewrite: Callable[[Fragment, Scope], Fragment]) -> Fragment:
    """A text in the language; what was rewritten last is remembered, so that its reading is the same one, too."""
    for known, with_scope, made in _LATEST:
        if known is fragment and with_scope is scope:
            return made
    made = rewrite(fragment, scope)
    _LATEST.append((fragment, scope, made))
    return made


_LATEST: deque[tuple[Fragment, Scope, Fragment]] = deque(maxlen=32)


def too_long(fragment: Fragment) -> ProblemError:
    """The error of a text with more characters than an answer may have."""
    length = len(fragment.text)
    message = f"an expression may have {MAX_ANSWER_CHARACTERS:,} characters, and this one has {length:,}"
    help_ = "write it shorter, or with abbreviations where there is a `let:`"
    return ProblemError(Diagnostic("expression-too-long", message, fragment.span(0, 20), help=help_))


def without_braces(draft: Draft) -> None:
    """The equation without the braces of TeX around the whole of it, `{x = 1}`."""
    start = len(draft.text) - len(draft.text.lstrip(" $"))
    end = len(draft.text.rstrip(" $"))
    if draft.text[start : start + 1] == "{" and closings(draft.text).get(start) == end - 1:
        draft.keep(start + 1, end - 1)


def tried(side: Fragment, scope: Scope, read: Callable[[Fragment], T]) -> T:
    """What can be read of one side in the first notation in which it can be. Raises the first ProblemError."""
    first: ProblemError | None = None
    for candidate in _notations(side, scope):
        try:
            return read(candidate)
        except ProblemError as error:
            first = first or error
    assert first is not None
    raise first


def _other(fragment: Fragment, scope: Scope, reading: Reading) -> Reading | None:
    """The other reading of an equation; None if it has none."""
    if not reading.notes:
        return None
    try:
        equation = read_otherwise(fragment, scope, MAX_ANSWER_CHARACTERS)
    except ProblemError:
        return None
    if equation is None or isinstance(equation.lhs, Vector) or isinstance(equation.rhs, Vector):
        return None
    return replace(
        reading, components=(sp.Add(equation.lhs, -equation.rhs),), sides=(equation.lhs, equation.rhs), other=None
    )
