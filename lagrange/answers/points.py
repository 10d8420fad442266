"""Points: what each part of an answer is worth, and how much of that an answer has earned.

    points: {equations: 6, degrees_of_freedom: 1, ask: {leaves: 3}}

A part earns its weight times the share of it that is right. Of n independent equations of motion with r right ones in
the answer the share is r/n; every wrong equation beyond the n asked for takes one of the right ones away, so that the
right equation and its opposite together earn nothing. Of a part with several statements (reactions, questions) the
share is that of the right ones; a single statement that holds and leaves something open earns one half. A part that
is undecided earns nothing yet: then the score is not settled, and a person must look at it.

Where a file gives no weights, each independent equation of motion is worth one point, and so is an answer about
equilibria.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from lagrange.answers.verdicts import FIRST, AnswerVerdict, EquationVerdict, Judgement, Verdict
from lagrange.core.records import record
from lagrange.problem.model import Problem, Weight

MISSING = "missing"
"""The verdict on a part that was not answered."""
_HALF = Fraction(1, 2)


@record
class PartScore:
    """The points for one part: `equations`, `ask: leaves`. `verdict` is one of `Verdict`, or `missing`."""

    part: str
    points: Fraction
    possible: Fraction
    verdict: str

    def as_json(self) -> dict[str, object]:
        """The part as a JSON object."""
        points, possible = as_number(self.points), as_number(self.possible)
        return {"part": self.part, "points": points, "possible": possible, "verdict": self.verdict}


@record
class Score:
    """The points for an answer, part by part. `weighed`: whether the problem file gives the weights."""

    parts: tuple[PartScore, ...]
    weighed: bool

    @property
    def points(self) -> Fraction:
        """The points earned."""
        return sum((p.points for p in self.parts), Fraction(0))

    @property
    def possible(self) -> Fraction:
        """The points for a complete answer."""
        return sum((p.possible for p in self.parts), Fraction(0))

    @property
    def settled(self) -> bool:
        """Whether no part is undecided."""
        return all(p.verdict != Verdict.UNDECIDED for p in self.parts)

    @property
    def undecided(self) -> Score:
        """The same with every part undecided."""
        return replace(self, parts=tuple(replace(p, verdict=Verdict.UNDECIDED.value) for p in self.parts))

    def as_json(self) -> dict[str, object]:
        """The points as a JSON object; `points` is null where a part is undecided."""
        points = as_number(self.points) if self.settled else None
        return {"points": points, "possible": as_number(self.possible), "parts": [p.as_json() for p in self.parts]}

    def lines(self) -> Iterator[str]:
        """The total, then each part, for a person."""
        undecided = "" if self.settled else ", and what is undecided"
        yield f"points: {points_in_words(self.points)} of {points_in_words(self.possible)}{undecided}"
        if len(self.parts) > 1:
            for p in self.parts:
                name = p.part.replace("_", " ")
                yield f"  {name}: {points_in_words(p.points)} of {points_in_words(p.possible)} ({p.verdict})"


def as_number(points: Fraction) -> int | float:
    """Points as a number with at most two decimals."""
    return int(points) if points.denominator == 1 else round(float(points), 2)


def points_in_words(points: Fraction) -> str:
    """Points with at most two decimals: `7`, `2.5`, `3.33`."""
    return f"{as_number(points):g}"


def score(problem: Problem, judgement: Judgement, required: int | None) -> Score:
    """The points for an answer. `required` is the number of independent equations; None if they are not counted."""
    weights = _weights(problem, None if judgement.statics else required)
    parts = (_of_part(weight, problem, judgement, required) for weight in weights)
    return Score(tuple(parts), bool(problem.points))


def unread_score(problem: Problem, verdict: Verdict, required: int | None) -> Score:
    """The points for an answer of which nothing was judged."""
    weights = _weights(problem, required)
    return Score(tuple(_part(w, Fraction(0), verdict.value) for w in weights), bool(problem.points))


def _weights(problem: Problem, required: int | None) -> Sequence[Weight]:
    if problem.points:
        return problem.points
    return (Weight("equations", "", Fraction(required)) if required else Weight("equilibrium", "", Fraction(1)),)


def _part(weight: Weight, share: Fraction, verdict: str) -> PartScore:
    name = f"{weight.part}: {weight.name}" if weight.name else weight.part
    return PartScore(name, weight.points * share, weight.points, verdict)


def _of_part(weight: Weight, problem: Problem, judgement: Judgement, required: int | None) -> PartScore:
    answer = _answer(weight.part, problem, judgement)
    if answer is None:
        return _part(weight, Fraction(0), MISSING)
    if weight.name:
        named = next((e for e in answer.equations if weight.name in (e.part, e.text.partition(":")[0])), None)
        if named is None:
            return _part(weight, Fraction(0), MISSING)
        return _part(weight, _share_of_statement(named.verdict), named.verdict.value)
    if weight.part == "equations":
        share = _share_of_equations(answer, required)
    else:
        share = _share(answer, _number_asked(weight.part, problem))
    verdict = answer.verdict
    if verdict is Verdict.EQUIVALENT and share < 1:
        verdict = Verdict.INCOMPLETE
    return _part(weight, share, verdict.value)


def _answer(part: str, problem: Problem, judgement: Judgement) -> AnswerVerdict | None:
    """The verdict on a part; None if it was not answered."""
    of_equations = "equilibrium" if judgement.statics else "reactions" if judgement.reactions else "equations"
    forces = _stated_reactions(problem, judgement.each) if of_equations == "equations" else []
    weighed = any(w.part == "reactions" for w in problem.points)
    if part == of_equations and judgement.each:
        others = [e for e in judgement.each if not (weighed and any(f.text == e.text for f in forces))]
        if not others or len(others) == len(judgement.each):
            return judgement.equations if others else None
        incomplete = [Verdict.INCOMPLETE] * bool(judgement.missing)
        return replace(judgement.equations, verdict=_first(others, incomplete), equations=tuple(others))
    found = next((a for a in judgement.others if a.name == part), None)
    if found is None and part == "reactions" and forces:
        return AnswerVerdict(_first(forces), tuple(forces), name=part)
    return found


def _first(each: Sequence[EquationVerdict], further: Sequence[Verdict] = ()) -> Verdict:
    """The verdict on several equations."""
    verdicts = [*(e.verdict for e in each), *further]
    return next((v for v in FIRST if v in verdicts), Verdict.EQUIVALENT)


def _stated_reactions(problem: Problem, each: Sequence[EquationVerdict]) -> list[EquationVerdict]:
    """The equations of a text that give a force of constraint, `N = ...`, each with the name of its constraint."""
    names = {c.reaction.name: c.name for c in problem.constraints}
    stated = ((e, re.sub(r"[\s{}$&\\]", "", e.text.partition("=")[0])) for e in each)
    return [replace(e, part=names[force]) for e, force in stated if force in names]


def _share_of_equations(answer: AnswerVerdict, required: int | None) -> Fraction:
    """The share of the independent equations of motion that are right."""
    verdicts = [e.verdict for e in answer.equations]
    if not required or Verdict.EQUIVALENT not in verdicts:
        return Fraction(0)
    right = max(0, required - answer.missing)
    surplus = max(0, right + verdicts.count(Verdict.WRONG) - required)
    return Fraction(max(0, right - surplus), required)


def _number_asked(part: str, problem: Problem) -> int:
    """Of how many statements a part consists, where that is known."""
    if part == "ask":
        return len(problem.questions)
    stated = problem.answers.reactions if part == "reactions" and problem.answers is not None else ()
    return len(stated)


def _share(answer: AnswerVerdict, asked: int) -> Fraction:
    """The share of the statements of a part that are right."""
    verdict, each = answer.verdict, answer.equations
    if verdict is Verdict.EQUIVALENT:
        return Fraction(min(len(each), asked) or 1, asked or 1) if each else Fraction(1)
    if verdict is Verdict.INCOMPLETE and answer.missing:
        right = _number_right(each)
        return Fraction(right, right + answer.missing)
    if not each or not (asked or verdict is Verdict.INCOMPLETE):
        return _share_of_statement(verdict)
    shares = sum((_share_of_statement(e.verdict) for e in each), Fraction(0))
    return min(shares, Fraction(max(asked, len(each)))) / max(asked, len(each))


def _number_right(each: Sequence[EquationVerdict]) -> int:
    return sum(e.verdict is Verdict.EQUIVALENT for e in each)


def _share_of_statement(verdict: Verdict) -> Fraction:
    """The share of one statement that is earned."""
    return Fraction(1) if verdict is Verdict.EQUIVALENT else _HALF if verdict is Verdict.INCOMPLETE else Fraction(0)
