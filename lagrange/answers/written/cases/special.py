"""What an answer says of a special case beside its equations: `if M = 3 m, then T = 3 m g/2`.

The case is a relation between parameters, or the place of a coordinate (`T = 3 m g when theta = 0`), after `for`, `if`,
`when` and the like. It is no statement about every motion, and neither is what follows it on its line, or comes right
before it. A relation that every motion satisfies, `for r = R`, is a constraint and no case.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from lagrange.algebra.exact.zero_test import DivisionByZeroError
from lagrange.answers.limits import LONGEST_BEFORE_CASE
from lagrange.answers.readings import Reading
from lagrange.answers.references import Reference
from lagrange.core.diagnostics import Fragment
from lagrange.mechanics.dynamics.comparison import Standing, compare

_CASE = re.compile(
    r"(?:\b(?:for|if|when|where|in\s+(?:the|a)\s+(?:special\s+|limiting\s+)?case(?:\s+(?:of|that|where))?|case|check|setting"
    r"|wenn|für|falls|bei|im\s+fall|pour|si|at)\b|\\text\s*\{\s*(?:for|if|when|where|at)\s*\})[\s,:($\\]*\Z",
    re.IGNORECASE,
)
_JOINS = re.compile(
    r"[\s,($]*(?:\\[,;: ]|\\q?quad|\\text\s*\{)?\s*"
    r"(?:\b(?:for|if|when|in\s+the\s+case|wenn|für|falls|bei|at)\b)[\s}(:$]*\Z",
    re.IGNORECASE,
)


def about_special_cases(
    equations: Sequence[tuple[Fragment, Reading]], reference: Reference
) -> tuple[set[int], set[int]]:
    """Of equations in their order, the numbers of those that state a case, and of those that hold in one."""
    cases = {n for n, (f, r) in enumerate(equations) if _CASE.search(_before(f)) and _is_case(r, reference)}
    special: set[int] = set()
    for n in cases:
        case = equations[n][0].span(0, len(equations[n][0].text))
        before = [m for m in range(n) if m not in cases]
        for m, (f, _) in enumerate(equations):
            own = f.span(0, len(f.text))
            if m in cases or own.source is not case.source:
                continue
            first, last = sorted((own, case), key=lambda s: s.start)
            between = case.source.text[first.end : last.start]
            if "\n" not in between and (own is last or (before[-1:] == [m] and _JOINS.match(between))):
                special.add(m)
    return cases, special


def _before(fragment: Fragment) -> str:
    """The end of what precedes an equation on its line."""
    span = fragment.span(0, len(fragment.text))
    text = span.source.text[: span.start]
    return text[max(text.rfind("\n") + 1, span.start - LONGEST_BEFORE_CASE) :]


def _is_case(reading: Reading, reference: Reference) -> bool:
    """Whether an equation is between parameters, or gives a coordinate a place that not every motion has."""
    if reading.error is not None or len(reading.components) != 1:
        return False
    (e,) = reading.components
    used = e.free_symbols - {*reference.parameters.values()}
    if not used:
        return bool(e.free_symbols)
    if not used <= {*reference.scope.slots.coordinates} or len(used) != 1:
        return False
    for c in reference.candidates_for({s.name for s in e.free_symbols}):
        try:
            result = compare([c.read(e)], c.system)
        except DivisionByZeroError:
            return False
        return result is not None and Standing.CONTRADICTS in result.standings
    return False
