"""Titles of questions: `The angle from the top where contact ends`, from what is asked for and when.

A quantity is called what the file says that it means, a rate by what it is a rate of. What cannot be called so has the
name of its question.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

import sympy as sp

from lagrange.core.symbols import prime, t
from lagrange.explain.limits import LONGEST_TITLE
from lagrange.explain.words import capital, joined, spoken
from lagrange.mechanics.dynamics.newton import Reaction
from lagrange.mechanics.questions.results import Asked
from lagrange.mechanics.results import Solution
from lagrange.problem.model import Condition, Constraint, Problem, Question

_ANGLES = ("angle", "inclination", "azimuth")
_GREEK = frozenset({"alpha", "beta", "theta", "phi", "psi", "vartheta", "varphi"})


def titles_of_questions(solution: Solution) -> tuple[str, ...]:
    """A title for each question; those of two with one title have their names too."""
    asked = [a.question for a in solution.asked]
    titles = [_signed(_title(solution, a.question), a) for a in solution.asked]
    known = Counter(titles)
    return tuple(
        f"Question: {spoken(q.name)}" if not title else f"{title} ({spoken(q.name)})" if known[title] > 1 else title
        for q, title in zip(asked, titles, strict=True)
    )


def _signed(title: str, asked: Asked) -> str:
    """The velocity for the speed, where it is negative."""
    values = [v for b in asked.branches for v in b.values]
    is_negative = bool(values) and all(v.as_coeff_Mul()[0].is_negative for v in values)
    return title.replace("The speed", "The velocity", 1) if is_negative else title


def _title(solution: Solution, question: Question) -> str:
    """Empty if the quantity has no name."""
    what = capital(_quantity(solution, question.quantity))
    if not what:
        return ""
    if isinstance(question.quantity, sp.Symbol) and [c.lhs for c in question.when if c.rhs == 0] == [
        prime(question.quantity)
    ]:
        return f"Extreme value of {_quantity(solution, question.quantity)}"
    by = _as_function_of(solution, question.by) if question.by is not None else ""
    conditions = _conditions(solution, question.when)
    ends = [_in_time(c) for c in conditions] if question.quantity == t else conditions
    known = (" ".join(filter(None, (what, *clauses))) for clauses in ((by, *ends), ends, ()))
    return next((title for title in known if len(title) <= LONGEST_TITLE), "")


def _quantity(solution: Solution, e: sp.Expr) -> str:
    """`the angle from the top`, `the time`, `the tension`, `the speed`; empty if there is no name for it."""
    problem = solution.problem
    if e == t:
        return "the time"
    if isinstance(e, sp.Symbol):
        meaning = _meaning(problem, e)
        constraint = _with_reaction(solution, e)
        if meaning or constraint is not None:
            return f"the {meaning}" if meaning else f"the {_called(solution, e)}"
    number, power = (e.base, e.exp) if isinstance(e, sp.Pow) else (e, sp.S.One)
    for q in _coordinates(solution):
        for n, called in ((2, "acceleration"), (1, "velocity")):
            factor = number.as_coefficient(prime(q, n)) if power in (1, 2) else None
            if factor == 1:
                return f"the {'angular ' if _is_angle(problem, q) else ''}{called}"
            if factor is not None and n == power == 1 and _is_angle(problem, q):  # R θ'
                return "the speed"
    return ""


def _as_function_of(solution: Solution, by: sp.Symbol) -> str:
    meaning = "time" if by == t else _meaning(solution.problem, by)
    return f"as a function of {'' if by == t else 'the '}{meaning}" if meaning else ""


def _conditions(solution: Solution, when: Sequence[Condition]) -> list[str]:
    """`where contact ends`; nothing if any of the conditions has no name."""
    zero = [c.lhs for c in when if c.rhs == 0]
    coordinates = _coordinates(solution)
    steady = {e for q in coordinates for e in (prime(q), prime(q, 2))}
    if len(zero) == len(when) > 1 and steady.issuperset(zero):
        return ["in a steady state"]
    clauses = [_condition(solution, c) for c in when]
    return [] if "" in clauses or not clauses else [joined(clauses)]


def _in_time(clause: str) -> str:
    """Of an instant: when, for where."""
    return clause.replace("where ", "when ", 1)


def _condition(solution: Solution, c: Condition) -> str:
    problem = solution.problem
    if c.lhs == t:
        return "at the start" if c.rhs == 0 else ""
    if c.rhs == 0 and isinstance(c.lhs, sp.Symbol) and (constraint := _with_reaction(solution, c.lhs)) is not None:
        return "where contact ends" if constraint.side is not None else f"where the {_called(solution, c.lhs)} vanishes"
    for q in _coordinates(solution):
        meaning = _meaning(problem, q)
        if c.lhs == prime(q) and c.rhs == 0:
            if solution.classification.degrees_of_freedom == 1:
                return "where the motion turns"
            return f"where the {meaning} stops changing" if meaning else ""
        if c.lhs == q and meaning and not c.rhs.free_symbols & {*_coordinates(solution)}:
            return f"where the {meaning} is zero" if c.rhs == 0 else f"at a given {meaning}"
    return ""


def _coordinates(solution: Solution) -> Iterator[sp.Symbol]:
    """Those of the file and of all choices."""
    return iter(dict.fromkeys(q for v in solution.views for q in v.configuration.slots.coordinates))


def _meaning(problem: Problem, symbol: sp.Symbol) -> str:
    """What the file says that a letter means, without an article; of a letter for an angle at least that."""
    meanings = {q.symbol: q.meaning for q in problem.coordinates} | {p.symbol: p.meaning for p in problem.parameters}
    words = meanings.get(symbol, "").split(", ")[0].removeprefix("the ")
    return words or ("angle" if symbol not in meanings and symbol.name in _GREEK else "")


def _is_angle(problem: Problem, q: sp.Symbol) -> bool:
    return _meaning(problem, q).startswith(_ANGLES)


def _with_reaction(solution: Solution, symbol: sp.Symbol) -> Constraint | None:
    """The constraint whose reaction, or tension, a letter is."""
    own = next((r.constraint for r in _reactions(solution) if symbol in (r.multiplier, r.symbol, r.given)), None)
    return own or next((c for c in solution.problem.constraints if c.reaction == symbol), None)


def _reactions(solution: Solution) -> tuple[Reaction, ...]:
    newton = None if solution.law is None else solution.law.newton
    return () if newton is None else newton.reactions


def _called(solution: Solution, symbol: sp.Symbol) -> str:
    """`tension` of a rod or string, otherwise `reaction`."""
    named = [r for r in _reactions(solution) if symbol in (r.multiplier, r.symbol, r.given)]
    return "tension" if named and named[0].tension is not None else "reaction"
