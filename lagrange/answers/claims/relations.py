"""Relations that are said to hold under a condition.

    ω_1 = √(c/m), ω_2 = √(g/(l + m g/c)), and ω_1 = 2 ω_2 if c l = 3 m g

The condition is solved for one of its parameters and put into the relation between quantities that the answer defines.
"""

from __future__ import annotations

import math
import random
import re
from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from lagrange.answers.claims.sentences import Relation, Sentence
from lagrange.answers.claims.trying import Outcome, Values, drawn, tried
from lagrange.answers.limits import CLAIM_SAMPLES, SAME_FREQUENCY
from lagrange.answers.references import Reference
from lagrange.answers.results.at_random import approximate
from lagrange.answers.verdicts import EquationVerdict, Verdict

_IF = re.compile(r"(?:\b(?:if|for|when|wenn|falls|für|pour|si)\b|⇔|\\iff|\\Leftrightarrow)[\s,:$]*\Z", re.IGNORECASE)
_WRONG = "if {} it does not hold"


def on_relations(sentence: Sentence, defined: Mapping[str, sp.Expr], reference: Reference) -> EquationVerdict | None:
    """The verdict on a relation between defined quantities under a condition; None if there is none."""
    pair = _pair(sentence)
    if pair is None or not defined:
        return None
    relation, condition = pair
    letters = {n: sp.Dummy(n) for n in defined}
    meanings = {letters[n]: e for n, e in defined.items()}
    scope = replace(reference.scope, scalars={**reference.scope.scalars, **letters})
    readings = [r.reading(scope) for r in (relation, condition)]
    if any(r.error is not None or len(r.components) != 1 for r in readings):
        return None
    [[claimed], [given]] = (r.components for r in readings)
    is_defined = not claimed.free_symbols.isdisjoint(meanings)
    for _ in meanings:  # one may be defined by another
        claimed, given = claimed.xreplace(meanings), given.xreplace(meanings)
    parameters = {*reference.parameters.values()}
    if not is_defined or not claimed.free_symbols | given.free_symbols <= parameters or not given.free_symbols:
        return None
    solved = _solved(given)
    if solved is None:
        return None
    symbol, value = solved
    claimed = claimed.xreplace({symbol: value})
    draw = random.Random(19)
    size = sp.Add(*(sp.Abs(t) for t in sp.Add.make_args(claimed)))

    def states() -> Iterator[Values]:
        for _ in range(2 * CLAIM_SAMPLES):
            yield drawn(claimed.free_symbols | value.free_symbols, set(), draw)

    def trial(values: Values) -> Iterator[bool | None]:
        if value.free_symbols and not approximate(value, values) > 0:
            return
        difference = approximate(claimed, values)
        if math.isfinite(difference):
            yield abs(difference) <= SAME_FREQUENCY * approximate(size, values)

    match tried(states(), trial):
        case Outcome.TRUE:
            return EquationVerdict.of(relation.text, Verdict.EQUIVALENT, "")
        case Outcome.FALSE:
            return EquationVerdict.of(relation.text, Verdict.WRONG, _WRONG.format(condition.text))
    return None


def _pair(sentence: Sentence) -> tuple[Relation, Relation] | None:
    """`A = B if C = D`, or `if C = D, A = B`."""
    equations = sentence.equations
    for n, condition in enumerate(equations):
        if not _IF.search(sentence.text[: condition.start]):
            continue
        before = equations[n - 1] if n else None
        if before is not None and len(sentence.text[before.end : condition.start].split()) <= 3:
            return before, condition
        if n + 1 < len(equations) and len(equations) == n + 2:
            return equations[n + 1], condition
    return None


def _solved(condition: sp.Expr) -> tuple[sp.Symbol, sp.Expr] | None:
    """One of the parameters in which a condition is linear, and its value."""
    for s in sorted(condition.free_symbols, key=str):
        slope = condition.diff(s)
        if slope != 0 and s not in slope.free_symbols:
            return s, -condition.xreplace({s: sp.S.Zero}) / slope
    return None
