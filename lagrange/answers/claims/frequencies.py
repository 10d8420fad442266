"""Frequencies of small oscillations beside equations of motion, where the file does not ask for them.

    For small φ it oscillates with the angular frequency ω_0 = √(2 g/(3 (R − r))).

The states of rest are found in numbers at random values of the parameters. A frequency is right if it is that of a
small motion about one of them, with or without its damping, at any of these values, and wrong if at none.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.answers.claims.near_rest import NearRest, near_rest
from lagrange.answers.claims.trying import Outcome, Values, samples, tried
from lagrange.answers.limits import LASTING, SAME_FREQUENCY, SAME_ROUNDED_FREQUENCY
from lagrange.answers.questions.frequencies import frequencies_in
from lagrange.answers.questions.texts.frequency_labels import name_of_frequency
from lagrange.answers.readings import has_decimals
from lagrange.answers.references import Reference
from lagrange.answers.results.at_random import approximate
from lagrange.answers.verdicts import EquationVerdict, Verdict
from lagrange.answers.written.names import has_word
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.symbols import symbols_in
from lagrange.mechanics.results import Solution

_OSCILLATES = re.compile(
    r"oscillat|small\s+(?:motion|angle|displacement|amplitude|vibration)|vibrat|eigen|natural|swings?\b|schwing|kleine|"
    r"frequenc|period",
    re.IGNORECASE,
)
_ANOTHER = re.compile(
    r"rotat|turn|spin|precess|driv|forc|resonan|beat|steady|circ(?:le|ular)|revol|orbit|simple\s+pendulum|mathematical|"
    r"compar|instead|\bif\b|\bwhen\b|\bfor\s+(?!small|the\b)|would|were|approx|≈|about\s+(?:the\s+)?(?:circle|orbit)|"
    r"wenn|falls|umlauf|dreh|ratio|energy|twice",
    re.IGNORECASE,
)
_WRONG = "no small motion about a state of rest has this frequency"


def on_frequencies(
    answer: Sequence[Fragment], solution: Solution, reference: Reference
) -> Iterator[tuple[Fragment, EquationVerdict]]:
    """The verdicts on stated frequencies of small oscillations, each with its place."""
    for f in answer:
        name = name_of_frequency(f)
        if not name or any(has_word(name, g.text) for g in answer if g is not f):
            continue
        line = _line(f)
        if not _OSCILLATES.search(line) or _ANOTHER.search(line):
            continue
        try:
            values = frequencies_in(f, reference)
        except ProblemError:
            continue
        parameters = {*reference.parameters.values()}
        if not values or any(not {*symbols_in(v)} <= parameters or v == 0 for v in values):
            continue
        system = near_rest(solution)
        if system is None or system.statics:
            return
        rounded = has_decimals(f.text) or any(v.is_number for v in values)
        outcomes = [_outcome(v, system, reference, rounded=rounded) for v in values]
        text = " ".join(f.text.split()).strip(" $.,;")
        if Outcome.FALSE in outcomes:
            yield f, EquationVerdict.of(text, Verdict.WRONG, _WRONG)
        elif all(o in (Outcome.TRUE, Outcome.SOMETIMES) for o in outcomes):
            yield f, EquationVerdict.of(text, Verdict.EQUIVALENT, "")


def _line(fragment: Fragment) -> str:
    span, text = fragment.span(0, len(fragment.text)), fragment.whole.source.text
    first = text.rfind("\n", 0, span.start) + 1
    stop = text.find("\n", span.end)
    return f"{getattr(fragment, 'beside', '')} {text[first : stop if stop >= 0 else len(text)]}"


def _outcome(claim: sp.Expr, system: NearRest, reference: Reference, *, rounded: bool) -> Outcome:
    everything = [claim, *system.balance, *(e for m in system.matrices for e in m)]
    symbols = {s for e in everything for s in symbols_in(e)} & {*reference.parameters.values()}
    near = SAME_ROUNDED_FREQUENCY if rounded else SAME_FREQUENCY
    ways = (system, system.undamped())

    def trial(values: Values) -> Iterator[bool | None]:
        stated = approximate(claim, values)
        if not stated > 0:
            return
        found = [x for state in system.states(values, []) for way in ways for x in _oscillations(way, state)]
        if found:
            yield any(abs(x - stated) <= near * stated for x in found)

    return tried(samples(symbols, [], reference.values), trial)


def _oscillations(system: NearRest, state: Values) -> list[float]:
    """The frequencies of the motions about a state that oscillate."""
    exponents = system.exponents(state) or []
    largest = max(map(abs, exponents), default=0)
    return [p.imag for p in exponents if p.imag > LASTING * largest]
