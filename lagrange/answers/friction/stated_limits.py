"""Limits of rest that an answer states by equations: `Q_max = ...`, `P_min = ...`, `mu = ... = 0.311`.

They are conditions, `Q <= ...`, `P >= ...`. A limit without an index may be an upper or a lower one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from lagrange.algebra.exact.zero_test import is_zero
from lagrange.answers.friction.rest_conditions import check_rest_answers, pieces
from lagrange.answers.limits import MOST_LIMITS
from lagrange.answers.questions.named_values import NOT_EQUAL, sides_agree
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import AnswerVerdict, EquationVerdict, Verdict
from lagrange.answers.written.reading import tried
from lagrange.core.diagnostics import Fragment, ProblemError
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.expressions.reader import is_inequality, read_value
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.equilibrium.friction.rolling import Rolling
from lagrange.mechanics.results import Solution


def check_limits(
    stated: Sequence[Fragment], rests: Sequence[AtRest | Rolling], reference: Reference, solution: Solution
) -> AnswerVerdict:
    """The verdict on limits that are stated by equations: Q_max = ..., Q_min = ..., mu = ... = 0.311.

    A limit without an index is meant as an upper or a lower one, whichever is right. All sides of a chain must agree.
    """
    if differing := chains_that_differ(stated, reference):
        return differing
    verdicts = [
        check_rest_answers(conditions, rests, reference, solution) for conditions in _as_conditions(stated, reference)
    ]
    if not verdicts:
        return check_rest_answers(stated, rests, reference, solution)
    order = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG, Verdict.UNREADABLE)
    return min(verdicts, key=lambda v: order.index(v.verdict))


def chains_that_differ(stated: Sequence[Fragment], reference: Reference) -> AnswerVerdict | None:
    """The verdict where values in a chain are not equal, `mu = ln(50)/(4 pi) = 0.135`; None if all of them are."""
    parts = []
    for f in stated:
        draft = Draft(f)
        signs = [*_INEQUALITY.finditer(f.text)]
        if len(signs) > 1 or (signs and scope_name(f.text[: signs[0].start()].strip(" $"), reference) is None):
            continue
        draft.replace(_INEQUALITY, "=")
        if sides_agree(draft.finished(latex=is_latex(f)), reference) is False:
            parts.append(EquationVerdict.of(" ".join(f.text.split()), Verdict.WRONG, NOT_EQUAL))
    return AnswerVerdict(Verdict.WRONG, tuple(parts), name="rest", diagnosis=NOT_EQUAL) if parts else None


def with_limits_put_in(answer: Sequence[Fragment]) -> list[Fragment]:
    """`P_min <= P <= P_max` with the values that other lines give the two."""
    values = {m["name"]: m["value"].strip(" $.,;") for f in answer if (m := _STATED_LIMIT.match(f.text))}
    if not values:
        return [*answer]
    made = []
    for f in answer:
        draft = Draft(f)
        if is_inequality(f) and draft.replace(_MARKED, lambda m: f"({values[m[0]]})" if m[0] in values else None):
            f = draft.finished(latex=is_latex(f))
        made.append(f)
    return made


def are_reversed(
    stated: Sequence[Fragment], rests: Sequence[AtRest | Rolling], reference: Reference, solution: Solution
) -> bool:
    """Whether an upper limit is stated as the lower one, `P_min = ...`, or a lower one as the upper one."""
    marked = [f for f in stated if (m := _EXTREMUM.match(f.text.strip(" $"))) and m["which"]]
    known = replace(reference, unknowns=())
    conditions = [next(_as_conditions(marked, known, senses), None) for senses in (_SENSES, _OPPOSITE)] if rests else []
    if not conditions or None in conditions:
        return False
    stated_so, reversed_ = (check_rest_answers(c, rests, reference, solution).verdict for c in conditions if c)
    return stated_so is Verdict.WRONG and reversed_ in (Verdict.EQUIVALENT, Verdict.INCOMPLETE)


def _as_conditions(
    stated: Sequence[Fragment], reference: Reference, senses: Mapping[str, str] | None = None
) -> Iterator[list[Fragment]]:
    """Inequalities for equations between a name and its limits, in both senses where no index tells the sense."""
    limits: list[tuple[Fragment, str, str, str]] = []  # with both sides, and the sense if it is known
    for f in stated:
        sides = pieces(f, _EQUALS)
        if not 2 <= len(sides) <= 5:  # none at all in `=`
            return
        if sides_agree(f, reference):  # mu = ln(50)/(4 pi) = 3.912/12.566 = 0.311
            sides = sides[:2]
        match = _EXTREMUM.fullmatch(sides[0].text.strip(" $"))
        name = scope_name(match["name"], reference) if match is not None else None
        if match is not None and name is None:
            return
        if name is not None and _is_value(name, sides[1:], reference):
            continue
        if any(u.name == name for u in reference.unknowns):  # working: T = P e^(mu beta)
            continue
        which = match["which"] if match is not None else ""
        sense = (senses or _SENSES)[which[:3]] if which else ""
        limits += [(f, name or sides[0].text, side.text, sense) for side in sides[1:]]
    free = [*dict.fromkeys(id(f) for f, _, _, sense in limits if not sense)]
    if len(free) > MOST_LIMITS:
        return
    for chosen in product(("<=", ">="), repeat=len(free)) if limits else ():  # each may be of another kind
        sense_of = dict(zip(free, chosen, strict=True))
        made = []
        for f, left, right, sense in limits:
            draft = Draft(f)
            draft.apply([(0, len(f.text), f"{left} {sense or sense_of[id(f)]} {right}")])
            made.append(draft.finished(latex=is_latex(f)))
        yield made


def _is_value(name: str, sides: Sequence[Fragment], reference: Reference) -> bool:
    """Whether a line only restates the value of a parameter: `beta = 4 pi`."""
    known = reference.values.get(reference.parameters.get(name, sp.nan))
    if known is None or len(sides) != 1:
        return False
    try:
        value = tried(sides[0], reference.scope, lambda f: read_value(f, reference.scope, [], latex=True))
    except ProblemError:
        return False
    return isinstance(value, sp.Expr) and is_zero(value - known) is True


def scope_name(written: str, reference: Reference) -> str | None:
    """The declared name that a text is; None if it is none."""
    name = reference.scope.spelling("".join(GREEK.get(c, c) for c in written.replace("\\", "")))
    return name if name in reference.declared else None


_EQUALS = re.compile(r"(?<![<>!=:])=(?![=>])|\\approx(?![A-Za-z])|≈")
_INEQUALITY = re.compile(r"[<>]=?|[≤≥]|\\[gl]e(?:q(?:slant)?)?(?![A-Za-z])")
_SENSES = {"min": ">=", "max": "<="}
_OPPOSITE = {"min": "<=", "max": ">="}
_MARKED = re.compile(
    r"(?<![A-Za-z0-9\\])[^\W\d_]{1,8}_(?:min|max)(?![A-Za-z])|\\?[A-Za-z]{1,8}_\{\\?(?:min|max|text\{max\}|text\{min\})\}"
)
_STATED_LIMIT = re.compile(rf"[\s$]*(?P<name>{_MARKED.pattern})\s*&?=(?!=)(?P<value>[^=<>≤≥]+)\Z")
_EXTREMUM = re.compile(
    r"(?P<name>\\?[^\W\d_]+?(?:_?[0-9])?)(?:_?\s*\{?\s*\\?(?:text|mathrm|rm)?\s*\{?\s*(?P<which>min|max)[a-z]{0,4}\s*\}?\s*\}?)?"
)
