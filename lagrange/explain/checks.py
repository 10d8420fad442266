"""The checks, and numbers to try on a calculator."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.document.builders import listed, math, prose
from lagrange.document.derivation import Block, CheckMark, Detail, Part, Rule, Step
from lagrange.explain.words import constraints_called, joined, spoken
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.solution import Solution

LONGEST_SPOT = 60
"""The most numbers of a spot value that a reader may want to type."""


def explain_checks(
    solution: Solution, answers: Sequence[tuple[str, str]], remarks: Sequence[tuple[str, str]] = ()
) -> Step:
    """The checks, the comparison with the file's answers, the spot values.

    remarks  how the reactions in the file's answers are read: the constraint, and the remark
    """
    body: list[Block] = [*_grouped(solution.checks), *_answers(answers)]
    for name, remark in remarks:
        body.append(prose(f"In the answer for {constraints_called([name])} {remark.replace('`', '')}."))
    if solution.given_up:
        body.append(prose(f"Given up at: {solution.given_up}. What it and the later stages find is missing."))
    if not body:
        body.append(prose("The file states no answers to compare with, and nothing asked for has a second route."))
    spots = [(v.name, v.spot) for v in solution.views]
    several = sum(spot is not None for _, spot in spots) > 1
    for name, spot in spots:
        if spot is not None:
            where = f" ({spoken(name)})" if name and several else ""
            parts: list[Part] = [f"Numerical check{where}: ", *_assignments(spot.values)]
            parts += [" give ", *_assignments(spot.accelerations), "."]
            long = len(spot.values) + len(spot.accelerations) > LONGEST_SPOT
            body.append(prose(*parts, detail=Detail.FULL if long else Detail.STEPS))
    return Step(Rule.CHECKS, "Checks", tuple(body))


def _grouped(checks: Sequence[Check]) -> list[Block]:
    """Checks of the same kind in several sets of coordinates make one line."""
    groups: dict[tuple[str, bool | None, str], list[str]] = {}
    for c in checks:
        groups.setdefault((c.name, c.passed, c.how), []).append(
            spoken(c.choice) if c.choice else "the given coordinates"
        )
    many = {c.choice for c in checks} != {""}
    return [
        CheckMark((f"{name}{_where(places) if many else ''}",), passed, how)
        for (name, passed, how), places in groups.items()
    ]


def _where(places: Sequence[str]) -> str:
    first, *others = places
    return f" ({joined([f'in {first}' if first.startswith('the ') else first, *others])})"


def _answers(answers: Sequence[tuple[str, str]]) -> list[Block]:
    """The file's answers: one line for those that agree, one for each that does not."""
    good = [_called(name) for name, verdict in answers if verdict == "equivalent"]
    marks: list[Block] = []
    if good:
        marks.append(CheckMark((f"the stated answers agree: {joined(good)}",), True, "compared with the file"))
    for name, verdict in answers:
        if verdict != "equivalent":
            passed = None if verdict == "undecided" else False
            marks.append(CheckMark((f"the stated {_called(name)}",), passed, f"compared with the file: {verdict}"))
    return marks


def _called(answer: str) -> str:
    """A key of the file's `answers` in running text."""
    return "integrability" if answer == "integrable" else spoken(answer)


def _assignments(values: Mapping[sp.Symbol, sp.Expr]) -> tuple[Part, ...]:
    return listed(math(s, v) for s, v in values.items())
