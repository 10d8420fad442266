"""One equation of an answer, or one side of it, read in whatever notation it is written.

Equations that cannot be read, and why: undeclared names, or the method quoted without its Lagrangian.
"""

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
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft, closings
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.limits import MAX_ANSWER_CHARACTERS
from lagrange.expressions.reader import read_otherwise
from lagrange.expressions.scope import Scope

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
    """The text in all notations it may be written in, each produced only if the previous one cannot be read."""
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
    message = f"an expression may have at most {MAX_ANSWER_CHARACTERS:,} characters; this one has {length:,}"
    help_ = "write it shorter, or with abbreviations where there is a `let:`"
    return ProblemError(Diagnostic("expression-too-long", message, fragment.span(0, 20), help=help_))


def without_braces(draft: Draft) -> None:
    """The equation without the braces of TeX around the whole of it, `{x = 1}`."""
    start = len(draft.text) - len(draft.text.lstrip(" $"))
    end = len(draft.text.rstrip(" $"))
    if draft.text[start : start + 1] == "{" and closings(draft.text).get(start) == end - 1:
        draft.keep(start + 1, end - 1)


def tried(side: Fragment, scope: Scope, read: Callable[[Fragment], T]) -> T:
    """One side, parsed in the first notation that fits. Raises the first ProblemError."""
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


# What cannot be read


_ENERGY = r"(?:[LTVUEH]|\\?L|ℒ|𝓛|\\(?:mathcal|mathscr|mathfrak|cal)\s*\{?\s*[LTVU]\s*\}?)"
_QUOTED = re.compile(
    rf"(?:[d∂]|\\partial|\\mathrm\s*\{{\s*d\s*\}}|\bdiff\(|\bD\[|\bDerivative\(|\\p?dv\s*\{{)"
    rf"\s*\(?\{{?\s*(?P<name>{_ENERGY})(?:\(t\)|\[t\])?\s*\}}?\)?\s*(?:/|,|\}}\s*\{{|\{{)"
)


def quotes_the_method(reading: Reading | None, text: str, scope: Scope) -> bool:
    """Whether an unreadable line has derivatives of a Lagrangian, or an energy, that is not given anywhere."""
    if reading is None or reading.error is None:
        return False
    names = [m["name"][-2:].strip("{} ")[-1:] for m in _QUOTED.finditer(text)]
    return bool(names) and all(scope.scalar("L" if n in "ℒ𝓛" else n) is None for n in names)


def undeclared(reading: Reading | None, text: str) -> list[str]:
    """The undeclared names for which an equation could not be read; none if there is another reason."""
    if reading is None or reading.error is None:
        return []
    names = []
    for d in reading.error.diagnostics:
        match = re.match(r"`(\w+)` is (?:not declared|neither a function)", d.message)
        if d.code not in ("unknown-symbol", "unknown-function") or match is None:
            return []
        if d.code == "unknown-function" and not _multiplies(match[1], text):
            return []
        names.append(match[1])
    return names


def _multiplies(name: str, text: str) -> bool:
    """Whether a name before a parenthesis may be a factor, as in `S(x - a)`: a letter, and not applied to a number."""
    letters = {name, *(c for c, n in GREEK.items() if n == name)}
    calls = re.findall(rf"(?:{'|'.join(map(re.escape, letters))})\s*\(([^()]*)\)?", text)
    return (len(name) <= 3 or len(letters) > 1) and not any(re.fullmatch(r"\s*(?:\d+|t)\s*", c) for c in calls)


def is_name(text: str) -> bool:
    """Whether a text may be a name."""
    return bool(text) and (text[0].isalpha()) and text.replace("_", "").isalnum()
