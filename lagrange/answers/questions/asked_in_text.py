"""Answers to questions among the lines of a text: h_min = 5/2 R, N = m g (1 + 2 h/R), v = sqrt(2 g l).

A line answers a question if it is an equation for the quantity that is asked for, or has its letter as a label, and
contains no other coordinate or velocity. It is compared with every question. A line that answers none, although its
letter is that of a quantity, is wrong as an answer to those. All other lines are judged as in any other answer.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.algebra.exact.zero_test import DivisionByZeroError, NoPointError, UnsupportedError
from lagrange.answers.questions.asked_quantities import check_asked, claims_of
from lagrange.answers.questions.texts.chains import NOT_EQUAL, sides_agree
from lagrange.answers.questions.texts.labels import is_used_beside
from lagrange.answers.references import Reference, reference_of_solution
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.reading import read_as_written
from lagrange.answers.written.working import understood
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.core.records import record
from lagrange.core.symbols import base
from lagrange.expressions.characters import GREEK
from lagrange.mechanics.questions.results import Asked
from lagrange.mechanics.results import Solution

_LETTER = re.compile(r"\s*\$?\s*\\?(?P<name>[^\W\d_](?:[^\W\d_]*))(?P<rest>[^=]{0,40}?)\s*=")
_APPLIED = re.compile(r"\s*\$?\s*\\?(?:cos|sin|tan)\s*(?:\(|\\left\s*\(|\{|~|\s)?\s*\\?(?P<name>[^\W\d_]+)[^=]{0,40}=")
_NAMES_A_RATE = re.compile(
    r"\s*\$?\s*\\?\w{1,8}\s*(?::=|=|\\equiv)\s*(?:\\dot\s*(?:\{\s*\\?\w+\s*\}|\s\w+|\\\w+)|\w+')\s*\$?[\s.,;]*\Z"
)
"""`v = \\dot y`, `v = y'`: a letter for a velocity, which answers no question."""
_SPEEDS = frozenset({"v", "V", "u", "w", "omega", "speed", "velocity"})
_TIMES = frozenset({"t", "T", "tau", "time"})
_NOT_JUDGED = (Verdict.UNREADABLE, Verdict.UNDECIDED)


@record
class AskedInText:
    """The lines of a text, sorted.

    verdict  on the lines that answer questions; None if there are none
    rest     the other lines
    missing  the questions without an answer
    """

    verdict: AnswerVerdict | None
    rest: tuple[Fragment, ...]
    missing: tuple[str, ...]


def asked_in_text(answer: Sequence[Fragment], solution: Solution) -> AskedInText:
    """The lines that answer questions, and the others."""
    questions = [a for a in solution.asked if a.answered]
    parts: list[EquationVerdict] = []
    rest: list[Fragment] = []
    answered: set[str] = set()
    reference = reference_of_solution(solution)
    defined = understood(answer, reference).defined
    scalars = {n: e for n, e in defined.items() if n not in reference.scope.scalars}
    wider = replace(reference, scope=replace(reference.scope, scalars={**reference.scope.scalars, **scalars}))
    for fragment in answer:
        if _is_condition(fragment, questions, reference):
            continue
        compared = [*_verdicts(fragment, questions, solution, reference)]
        if scalars and not any(v.verdict is Verdict.EQUIVALENT for _, v in compared):
            with_names = [*_verdicts(fragment, questions, solution, wider)]
            right_so = any(v.verdict is Verdict.EQUIVALENT for _, v in with_names)
            compared = with_names if right_so else compared or with_names
        right = [(name, v) for name, v in compared if v.verdict is Verdict.EQUIVALENT]
        named = [
            a.question.name for a in questions if _is_named(fragment, a) or _states_quantity(fragment, a, reference)
        ]
        named = [] if _NAMES_A_RATE.match(fragment.text) or is_used_beside(fragment, answer, reference) else named
        about = {name for name, _ in compared}  # y = f(x) is about the path, and not about the greatest height
        named = [name for name in named if name in about] or named
        named = _of_function(named, fragment, questions, reference)
        judged = [(name, v) for name, v in compared if v.verdict not in _NOT_JUDGED and name in named]
        if right and sides_agree(fragment, reference) is False:
            parts.append(EquationVerdict(" ".join(fragment.text.split()), Verdict.WRONG, NOT_EQUAL))
        elif right:
            answered |= {name for name, _ in right}
            name, verdict = next(((n, v) for n, v in right if n in named), right[0])
            parts.append(_part(fragment, name, verdict))
        elif judged and _holds_at_a_limit(fragment, judged, questions, solution, reference):
            continue
        elif judged and len(judged) == len(named):
            name, verdict = _explained(fragment, judged, solution)
            answered |= {*named} if len(named) == 1 else set()
            parts.append(_part(fragment, name, verdict))
        else:
            rest.append(fragment)
    missing = tuple(a.question.name for a in questions if a.question.name not in answered)
    if not parts:
        return AskedInText(None, tuple(rest), missing)
    verdicts = {p.verdict for p in parts}
    order = (Verdict.WRONG, *_NOT_JUDGED, Verdict.INCOMPLETE)
    whole = next((v for v in order if v in verdicts), Verdict.EQUIVALENT)
    return AskedInText(AnswerVerdict(whole, tuple(parts), name="ask"), tuple(rest), missing)


def _of_function(
    named: Sequence[str], fragment: Fragment, questions: Sequence[Asked], reference: Reference
) -> list[str]:
    """Of questions for one quantity those for a function of what occurs in a line, x(t) = ..., or those for none."""
    reading = read_as_written(fragment, reference.scope)
    used = set() if reading.error else {s for e in reading.components for s in e.free_symbols}
    by = {a.question.name: a.question.by for a in questions}
    functions = [name for name in named if by[name] is not None and by[name] in used]
    return functions or [name for name in named if by[name] is None] or [*named]


def _explained(
    fragment: Fragment, judged: Sequence[tuple[str, EquationVerdict]], solution: Solution
) -> tuple[str, EquationVerdict]:
    """A wrong line with what is wrong about it, as the answer to the question to which it is close."""
    for name, _ in judged:
        explained = check_asked({name: fragment}, solution).equations[0]
        if explained.verdict not in _NOT_JUDGED and (explained.diagnosis or len(judged) == 1):
            why = explained.diagnosis if len(judged) == 1 else f"as the answer to `{name}`: {explained.diagnosis}"
            return name, replace(explained, diagnosis=why)
    return judged[0]


def _states_quantity(fragment: Fragment, asked: Asked, reference: Reference) -> bool:
    """Whether one side of a line is the quantity itself, as in R*theta' = ..."""
    reading = read_as_written(fragment, reference.scope)
    quantity = asked.question.quantity
    return not reading.error and not quantity.is_Symbol and any(s == quantity for s in reading.sides)


def _holds_at_a_limit(
    fragment: Fragment,
    judged: Sequence[tuple[str, EquationVerdict]],
    questions: Sequence[Asked],
    solution: Solution,
    reference: Reference,
) -> bool:
    """Whether a line is right for the value of a parameter that is asked for: v = sqrt(g R) at the least height."""
    names = {name for name, _ in judged}
    for asked in questions:
        quantity, values = asked.question.quantity, [v for b in asked.branches for v in b.values]
        if quantity not in reference.parameters.values() or len(values) != 1 or asked.question.name in names:
            continue
        special = replace(reference, values={**reference.values, quantity: values[0]})
        others = [a for a in questions if a.question.name in names]
        if any(v.verdict is Verdict.EQUIVALENT for _, v in _verdicts(fragment, others, solution, special)):
            return True
    return False


def _is_condition(fragment: Fragment, questions: Sequence[Asked], reference: Reference) -> bool:
    """Whether a line is the condition of a question, N = 0, and no answer."""
    reading = read_as_written(fragment, reference.scope)
    if reading.error or len(reading.components) != 1:
        return False
    [e] = reading.components
    conditions = [c.lhs - c.rhs for a in questions for c in a.question.when]
    return any(sp.expand(e - sign * c) == 0 for c in conditions for sign in (1, -1))


def _part(fragment: Fragment, name: str, verdict: EquationVerdict) -> EquationVerdict:
    remarks = (*verdict.remarks, f"it is taken as the answer to `{name}`")
    return EquationVerdict(
        " ".join(fragment.text.split()), verdict.verdict, verdict.diagnosis, remarks if not verdict.diagnosis else ()
    )


def _verdicts(
    fragment: Fragment, questions: Sequence[Asked], solution: Solution, reference: Reference
) -> Iterator[tuple[str, EquationVerdict]]:
    """The verdicts on a line as the answer to each question that it may answer."""
    coordinates = {q for v in solution.views for q in v.configuration.slots.coordinates}
    for asked in questions:
        try:
            claims = claims_of(fragment, asked, solution, reference)
            stated = [e for c in claims for e in (c.expression, c.equation) if e is not None]
            used = {s for e in stated for s in e.free_symbols if isinstance(s, sp.Symbol)}
            asked_for = {*asked.question.quantity.free_symbols, asked.question.by}
            if any((base(s) in coordinates or base(s) != s) and s not in asked_for for s in used):
                continue
            best = min((c.verdict(explaining=False) for c in claims), key=lambda v: v[0] is Verdict.EQUIVALENT)
        except (ProblemError, DivisionByZeroError, NoPointError, UnsupportedError):
            continue
        yield asked.question.name, EquationVerdict.of(fragment.text, *best)


def _is_named(fragment: Fragment, asked: Asked) -> bool:
    """Whether the letter on the left of a line is that of the quantity, or the name of the question."""
    match = _APPLIED.match(fragment.text) or _LETTER.match(fragment.text)
    if match is None:
        return False
    name = "".join(GREEK.get(c, c) for c in match["name"])
    question = asked.question
    if re.match(rf"\s*{re.escape(question.name)}\s*=", fragment.text):
        return True
    symbols = question.quantity.free_symbols
    if re.search(r"['′̇̈]|dot|/", match["rest"] if "rest" in match.re.groupindex else ""):
        return False
    if len(symbols) == 1 and question.quantity.is_Symbol:
        [symbol] = symbols
        if symbol.name == "t":
            return name in _TIMES
        if symbol.name == base(symbol).name:
            return bool(name == symbol.name.partition("_")[0] or match[0].strip(" $=\\") == symbol.name)
    return any(base(s) != s and s.name.count("'") == 1 for s in symbols) and name in _SPEEDS
