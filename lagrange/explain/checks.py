"""The checks, and numbers to try on a calculator."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from lagrange.core.symbols import UnitSymbol
from lagrange.core.units import unit_of
from lagrange.document.derivation import Block, CheckMark, Detail, Part, Prose, Rule, Step, listed, math, prose
from lagrange.explain.limits import LONGEST_SPOT
from lagrange.explain.words import constraints_called, in_decimals, joined, plural, spoken
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.results import Solution
from lagrange.mechanics.rewriting.readable_forms import acceleration_formula, values_that_matter
from lagrange.problem.model import Parameter


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
    stated = _stated(solution)
    spots = [(v.name, v.spot) for v in solution.views]
    several = sum(spot is not None for _, spot in spots) > 1
    for name, spot in spots:
        if spot is not None:
            where = spoken(name) if name and several else ""
            parts: list[Part] = [_SPOT, *_in(where), *_assignments(spot.values, stated)]
            parts += [" give ", *_assignments(spot.accelerations, {}), "."]
            long = len(spot.values) + len(spot.accelerations) > LONGEST_SPOT
            body.append(prose(*parts, detail=Detail.FULL if long else Detail.STEPS))
    return Step(Rule.CHECKS, "Checks", tuple(body))


def in_one_line(step: Step, solution: Solution) -> Step:
    """The step with one line for all checks that held, and with the numbers of one set of coordinates only."""
    held = [b for b in step.body if isinstance(b, CheckMark) and b.passed]
    body = [b for b in step.body if b not in held and not _is_spot(b)]
    if len(held) > 1:
        telling = next((b for b in held if "Lagrange" in str(b.name[0])), held[0])
        name, more = str(telling.name[0]).partition(" (")[0], len(held) - 1
        held = [CheckMark((f"{name}, and {more} more {plural(more, 'check', 'checks')}",), True, "")]
    return replace(step, body=(*held, *body, *_spot(solution)))


def _in(choice: str) -> tuple[Part, ...]:
    return (f"in {choice}, ",) if choice else ()


def _is_spot(block: Block) -> bool:
    return isinstance(block, Prose) and block.parts[0] == _SPOT


_SPOT = "Numerical check: "


def _spot(solution: Solution) -> list[Block]:
    """`Numerical check: g = 10, l = 1, θ = 1/2 give θ'' = −(g/l) sin θ = −4.79426.`"""
    view = next((v for v in solution.views_by_page if v.spot is not None), None)
    if view is None or view.spot is None:
        return []
    spot = view.spot
    values = values_that_matter(view, spot.values)
    if not values:
        return []  # nothing accelerates, whatever the values
    formulas = {a: f for a in spot.accelerations if (f := acceleration_formula(view, a)) is not None}
    results = [math(a, *([formulas[a]] if a in formulas else []), value) for a, value in spot.accelerations.items()]
    long = len(values) + len(spot.accelerations) > LONGEST_SPOT
    words: list[Part] = ["Try it: ", *_assignments(values, _stated(solution)), plural(len(values), " gives ", " give ")]
    return [prose(*words, *listed(results), ".", detail=Detail.FULL if long else Detail.STEPS)]


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
    """The file's answers: one line for those that agree, and one for each that does not."""
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


def _stated(solution: Solution) -> dict[sp.Symbol, Parameter]:
    return {p.symbol: p for p in solution.problem.parameters if p.value is not None}


def _assignments(values: Mapping[sp.Symbol, sp.Expr], stated: Mapping[sp.Symbol, Parameter]) -> tuple[Part, ...]:
    """`g = 9.81, α = 30° and x = 1/2`: values of the file as it has them, others as short decimals or fractions."""
    return listed(math(s, _as_stated(stated[s]) if s in stated else _shortly(v)) for s, v in values.items())


def _shortly(value: sp.Expr) -> sp.Expr:
    """30° for π/6, 0.5 for 1/2, and 2/3 as it is."""
    if value.has(sp.pi):
        return sp.Mul(in_decimals(value * 180 / sp.pi), UnitSymbol("°", positive=True), evaluate=False)
    return in_decimals(value)


def _as_stated(parameter: Parameter) -> sp.Expr:
    value, unit = parameter.value, unit_of(parameter.unit)
    assert value is not None
    if unit is None or not unit.is_angle:
        return in_decimals(value)
    from lagrange.values.quantities import degrees

    return degrees(value)
