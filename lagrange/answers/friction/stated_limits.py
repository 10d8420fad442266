"""Limits of rest that an answer states by equations: `Q_max = ...`, `P_min = ...`, `mu = ... = 0.311`.

They are conditions, `Q <= ...`, `P >= ...`. A limit without an index may be an upper or a lower one.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

from lagrange.answers.friction.rest_conditions import check_rest_answers, pieces
from lagrange.answers.limits import MOST_LIMITS
from lagrange.answers.references import Reference
from lagrange.answers.verdicts import AnswerVerdict, Verdict
from lagrange.core.diagnostics import Fragment
from lagrange.expressions.characters import GREEK
from lagrange.expressions.edits import Draft
from lagrange.expressions.latex_layout import is_latex
from lagrange.mechanics.equilibrium.friction.friction_at_rest import AtRest
from lagrange.mechanics.equilibrium.friction.rolling import Rolling
from lagrange.mechanics.results import Solution


def check_limits(
    stated: Sequence[Fragment], rests: Sequence[AtRest | Rolling], reference: Reference, solution: Solution
) -> AnswerVerdict:
    """The verdict on limits that are stated by equations: Q_max = ..., Q_min = ..., mu = ... = 0.311.

    A limit without an index is meant as an upper or a lower one, whichever is right.
    """
    verdicts = [
        check_rest_answers(conditions, rests, reference, solution) for conditions in _as_conditions(stated, reference)
    ]
    if not verdicts:
        return check_rest_answers(stated, rests, reference, solution)
    order = (Verdict.EQUIVALENT, Verdict.INCOMPLETE, Verdict.UNDECIDED, Verdict.WRONG, Verdict.UNREADABLE)
    return min(verdicts, key=lambda v: order.index(v.verdict))


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
    limits: list[tuple[Fragment, str, Fragment]] = []
    for f in stated:
        sides = pieces(f, _EQUALS)
        if not 2 <= len(sides) <= 5:  # none at all in `=`
            return
        match = _EXTREMUM.fullmatch(sides[0].text.strip(" $"))
        if match is None:
            return
        name = scope_name(match["name"], reference)
        if name is None:
            return
        if any(u.name == name for u in reference.unknowns):  # working: T = P e^(mu beta)
            continue
        for side in sides[1:]:
            sense = (senses or _SENSES)[match["which"][:3]] if match["which"] else "{}"
            limits.append((f, f"{name} {sense} ", side))
    free = [*dict.fromkeys(id(f) for f, start, _ in limits if "{}" in start)]
    if len(free) > MOST_LIMITS:
        return
    for chosen in product(("<=", ">="), repeat=len(free)) if limits else ():  # each may be of another kind
        sense_of = dict(zip(free, chosen, strict=True))
        made = []
        for f, start, side in limits:
            draft = Draft(f)
            draft.apply([(0, len(f.text), f"{start.format(sense_of.get(id(f), ''))}{side.text}")])
            made.append(draft.finished(latex=is_latex(f)))
        yield made


def scope_name(written: str, reference: Reference) -> str | None:
    """The declared name that a text is; None if it is none."""
    name = reference.scope.spelling("".join(GREEK.get(c, c) for c in written.replace("\\", "")))
    return name if name in reference.declared else None


_EQUALS = re.compile(r"(?<![<>!=:])=(?![=>])|\\approx(?![A-Za-z])|≈")
_SENSES = {"min": ">=", "max": "<="}
_OPPOSITE = {"min": "<=", "max": ">="}
_EXTREMUM = re.compile(
    r"(?P<name>\\?[^\W\d_]+?(?:_?[0-9])?)(?:_?\s*\{?\s*\\?(?:text|mathrm|rm)?\s*\{?\s*(?P<which>min|max)[a-z]{0,4}\s*\}?\s*\}?)?"
)
