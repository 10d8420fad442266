"""The checks, and numbers to try on a calculator."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from lagrange.algebra.fourier.textbook_form import textbook_form
from lagrange.core.operations import count_operations
from lagrange.document.builders import listed, math, prose
from lagrange.document.derivation import Block, CheckMark, Detail, Part, Prose, Rule, Step
from lagrange.explain.words import constraints_called, joined, plural, spoken
from lagrange.mechanics.dynamics.checks import Check
from lagrange.mechanics.results import InCoordinates, Solution

LONGEST_FORMULA = 30
"""The most operations of an acceleration that is written before its value."""
LONGEST_SOLVED = 4 * LONGEST_FORMULA
"""The most operations of an equation that is solved for it: one of 3,000 takes more than ten seconds."""
LONGEST_SPOT = 20
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
            where = spoken(name) if name and several else ""
            parts: list[Part] = [_SPOT, *_in(where), *_assignments(spot.values)]
            parts += [" give ", *_assignments(spot.accelerations), "."]
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
    values = _without_turns(view, {s: e for s, e in spot.values.items() if _matters(view, s)})
    if not values:
        return []  # nothing accelerates, whatever the values
    results = [math(a, *_formula(view, a), value) for a, value in spot.accelerations.items()]
    long = len(values) + len(spot.accelerations) > LONGEST_SPOT
    words: list[Part] = ["Try it: ", *_assignments(values), plural(len(values), " gives ", " give ")]
    return [prose(*words, *listed(results), ".", detail=Detail.FULL if long else Detail.STEPS)]


def _equations(view: InCoordinates) -> list[sp.Expr]:
    """What the accelerations follow from."""
    rows = view.configuration.rows
    equations = [] if view.motion is None else [e.expression for e in view.motion.equations]
    equations += [e for r in rows for e in (*r.coefficients, r.drift, *([r.finite] if r.finite is not None else []))]
    return [*equations, *(r.nonlinear for r in rows if r.nonlinear is not None)]


def _matters(view: InCoordinates, symbol: sp.Symbol) -> bool:
    """Whether a coordinate occurs in the equations; anything else does."""
    return symbol not in view.configuration.slots.coordinates or any(e.has(symbol) for e in _equations(view))


def _without_turns(view: InCoordinates, values: Mapping[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, sp.Expr]:
    """The values with angles between −π and π, where a coordinate occurs in sines and cosines only."""
    coordinates = {*view.configuration.slots.coordinates}
    far = {s: e for s, e in values.items() if s in coordinates and e.is_number and not abs(e) < 3}
    if not far:
        return {**values}
    plain = [e.replace(lambda x: isinstance(x, TrigonometricFunction), lambda _: sp.Dummy()) for e in _equations(view)]
    turns = {s: sp.floor((e + sp.pi) / (2 * sp.pi)) for s, e in far.items() if not any(p.has(s) for p in plain)}
    return {s: sp.N(e - 2 * sp.pi * turns[s], 6) if turns.get(s) else e for s, e in values.items()}


def _formula(view: InCoordinates, acceleration: sp.Symbol) -> list[sp.Expr]:
    """The acceleration as a formula, where there is only one and it is short."""
    if view.motion is None or len(view.motion.equations) != 1 or view.configuration.rows:
        return []
    equation = view.motion.equations[0].expression
    if count_operations(equation) > LONGEST_SOLVED:
        return []
    factor = equation.diff(acceleration)
    if factor == 0 or factor.has(acceleration):
        return []
    formula = textbook_form(-(equation - factor * acceleration).expand() / factor)
    return [formula] if count_operations(formula) <= LONGEST_FORMULA and not formula.is_number else []


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
