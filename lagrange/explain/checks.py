"""What was checked, and values to try on a calculator."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lagrange.document.derivation import Block, CheckMark, Detail, Part, Rule, Step, listed, math, prose
from lagrange.explain.words import spoken
from lagrange.mechanics.dynamics.verification import Check
from lagrange.mechanics.solution import Solution

LONGEST_SPOT = 60
"""Numbers of a spot value that somebody may still type."""


def explain_checks(
    solution: Solution, answers: Sequence[tuple[str, str]], remarks: Sequence[tuple[str, str]] = ()
) -> Step:
    """The checks, the comparison with the textbook's answers, the spot values.

    remarks  on what the file says of reactions: the constraint, and how that is taken
    """
    body: list[Block] = [*_grouped(solution.checks), *_answers(answers)]
    body += [prose(f"In the answer for {spoken(name)} {said.replace('`', '')}.") for name, said in remarks]
    if not body:
        body.append(prose("The file has no answers to compare with, and nothing was asked that has a second route."))
    spots = [("", solution.spot), *((c.name, c.spot) for c in solution.choices)]
    several = sum(spot is not None for _, spot in spots) > 1
    for name, spot in spots:
        if spot is not None:
            where = f" ({spoken(name)})" if name and several else ""
            parts: list[Part] = [f"A value to try on a calculator{where}: "]
            parts += [*_assignments(spot.values), " give ", *_assignments(spot.accelerations), "."]
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
    words = [f"in {places[0]}" if places[0].startswith("the ") else places[0], *places[1:]]
    return " (" + "".join(str(p) for p in listed(words)) + ")"


def _answers(answers: Sequence[tuple[str, str]]) -> list[Block]:
    """The file's answers: one line for those that agree, one for each that does not."""
    good = [_called(name) for name, verdict in answers if verdict == "equivalent"]
    found: list[Block] = []
    if good:
        names = "".join(str(p) for p in listed(good))
        found.append(CheckMark((f"the textbook's answers agree: {names}",), True, "compared with the file"))
    for name, verdict in answers:
        if verdict != "equivalent":
            passed = None if verdict == "undecided" else False
            found.append(CheckMark((f"the textbook's {_called(name)}",), passed, f"compared with the file: {verdict}"))
    return found


def _called(answer: str) -> str:
    """A key of the file's answers in running text."""
    return "integrability" if answer == "integrable" else spoken(answer)


def _assignments(values: Mapping[sp.Symbol, sp.Expr]) -> tuple[Part, ...]:
    return listed(math(s, v) for s, v in values.items())
